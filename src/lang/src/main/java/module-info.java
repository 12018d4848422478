/** The parser of KRL: programs and data lists as trees, with errors and their positions. */
@SuppressWarnings("requires-automatic") // ANTLR sets its name in the manifest
module no.hials.crosscom.lang {
  requires org.antlr.antlr4.runtime;
  requires no.hials.crosscom.protocol;
  requires static org.jspecify;

  exports no.hials.crosscom.lang;
}
