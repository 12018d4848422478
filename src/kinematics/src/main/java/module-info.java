/** Forward and inverse kinematics of six-axis KUKA robots. */
module no.hials.crosscom.kinematics {
  requires transitive no.hials.crosscom.protocol;
  requires static org.jspecify;

  exports no.hials.crosscom.kinematics;
}
