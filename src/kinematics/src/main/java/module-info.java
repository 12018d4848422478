/** Forward and inverse kinematics of six-axis KUKA robots. */
module no.hials.crosscom.kinematics {
  requires static org.jspecify;

  exports no.hials.crosscom.kinematics;
}
