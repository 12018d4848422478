/** The client of KUKAVARPROXY and C3 Bridge, with the API of JOpenShowVar 0.2.2. */
module no.hials.crosscom {
  requires transitive no.hials.crosscom.protocol;
  requires jdk.jfr;
  requires org.slf4j;
  requires static org.jspecify;

  exports no.hials.crosscom;
  exports no.hials.crosscom.KRL;
  exports no.hials.crosscom.KRL.structs;
  exports no.hials.crosscom.c3;
  exports no.hials.crosscom.networking;
  exports no.hials.crosscom.variables;
}
