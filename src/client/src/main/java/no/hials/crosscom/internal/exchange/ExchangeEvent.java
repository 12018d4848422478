package no.hials.crosscom.internal.exchange;

import jdk.jfr.Category;
import jdk.jfr.DataAmount;
import jdk.jfr.Description;
import jdk.jfr.Event;
import jdk.jfr.Label;
import jdk.jfr.Name;
import jdk.jfr.StackTrace;
import jdk.jfr.Timespan;

/**
 * The flight recorder's event of an exchange. A connection uses one object again and again, so that
 * an exchange creates none.
 */
@Name("no.hials.crosscom.Exchange")
@Label("Exchange")
@Category("CrossCom")
@Description("A request to a robot controller and its answer")
@StackTrace(false)
public final class ExchangeEvent extends Event {
  @Label("Server")
  String server = "";

  @Label("Request")
  String request = "";

  @Label("Queue Time")
  @Timespan
  long queueTime;

  @Label("Length of Request")
  @DataAmount
  int requestLength;

  @Label("Answered")
  boolean answered;

  /** Sets what the recorder shows of an exchange. */
  public void set(String toServer, String what, long queueNanos, int bytes, boolean withAnswer) {
    server = toServer;
    request = what;
    queueTime = queueNanos;
    requestLength = bytes;
    answered = withAnswer;
  }
}
