/** The messages of KUKAVARPROXY and C3 Bridge, the codec for them, and the KRL values in them. */
module no.hials.crosscom.protocol {
  requires static org.jspecify;

  exports no.hials.crosscom.protocol;
  exports no.hials.crosscom.protocol.code;
  exports no.hials.crosscom.protocol.file;
  exports no.hials.crosscom.protocol.program;
  exports no.hials.crosscom.protocol.server;
  exports no.hials.crosscom.protocol.value;
  exports no.hials.crosscom.protocol.variable;
}
