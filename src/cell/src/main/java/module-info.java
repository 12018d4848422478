/**
 * The parts that every front end needs: named robots, permission to write, sampling, recordings.
 */
module no.hials.crosscom.cell {
  requires transitive com.fasterxml.jackson.core;
  requires com.fasterxml.jackson.dataformat.toml;
  requires transitive de.siegmar.fastcsv;
  requires transitive no.hials.crosscom;
  requires transitive no.hials.crosscom.lang;
  requires org.slf4j;
  requires static org.jspecify;

  exports no.hials.crosscom.cell;
  exports no.hials.crosscom.cell.feed;
  exports no.hials.crosscom.cell.recording;
}
