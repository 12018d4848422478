package no.hials.crosscom.KRL;

import java.util.Objects;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.internal.BoxedFrame;
import no.hials.crosscom.internal.Latin1;
import no.hials.crosscom.internal.VariableAccess;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.variable.ReadRequest;
import no.hials.crosscom.protocol.variable.WriteRequest;
import org.jspecify.annotations.Nullable;

/**
 * Holds the local copy of a variable of the controller.
 *
 * <p>A program may derive classes of its own; those that come with the client read numbers without
 * making objects.
 */
public abstract class KRLVariable {
  private static final AtomicInteger IDS = new AtomicInteger();

  private final int id;
  private final String name;
  private final byte @Nullable [] readFrame;
  private long readTime = -1;

  /** Whether the class is part of the client, so that no program has changed how it prints. */
  private final boolean builtIn =
      getClass().getPackageName().startsWith(KRLVariable.class.getPackageName());

  private @Nullable StringBuilder writeText;

  static {
    VariableAccess.set(new Access());
  }

  /**
   * Makes a variable.
   *
   * @param name the name on the controller, such as {@code $OV_PRO}, {@code MYPOS.X} or {@code
   *     $TORQUE_AXIS_ACT[3]}; case does not matter to the controller
   * @throws IllegalArgumentException if the name is blank or too long for a message
   */
  protected KRLVariable(String name) {
    Objects.requireNonNull(name, "name");
    if (name.isBlank()) {
      throw new IllegalArgumentException("a variable's name must not be blank");
    }
    this.name = name;
    this.id = IDS.getAndIncrement();
    this.readFrame = Latin1.has(name) ? Codec.encode(new ReadRequest(0, name)) : null;
  }

  /**
   * Gives a number that no other variable of this program has. It is not the id of the messages.
   *
   * @return the number; later variables have greater ones
   */
  public int getId() {
    return id;
  }

  /**
   * Gives the name on the controller.
   *
   * @return the name
   */
  public String getName() {
    return name;
  }

  /**
   * Gives the name of the variable's class.
   *
   * @return such as {@code KRLReal}
   */
  public String getType() {
    return getClass().getSimpleName();
  }

  /**
   * Gives the local value.
   *
   * @return the value; null for a scalar, string or array that was neither set nor read
   */
  public abstract @Nullable Object getValue();

  /**
   * Gives the text that a write sends.
   *
   * @return the local value as KRL text
   * @throws IllegalStateException if there is no value
   */
  public abstract String getStringValue();

  /**
   * Sets the local value from KRL text.
   *
   * @param strValue the text as a controller prints it
   * @throws IllegalArgumentException if it is not a value of this type
   */
  protected abstract void setValueFromString(String strValue);

  /**
   * Sets the local value from KRL text in place. A class that does not override this is set by
   * {@link #setValueFromString}.
   *
   * @param scanner at the beginning of the text
   * @param written whether the text is that of a write, which may name some fields only
   * @return true if the value was set
   * @throws IllegalArgumentException if the text is not a value of this type; the value is as
   *     before
   */
  protected boolean setValueFrom(KrlScanner scanner, boolean written) {
    return false;
  }

  /**
   * Appends the text that a write sends, without creating objects. A class that does not override
   * this is printed by {@link #getStringValue}, and so is a class that a program derives.
   *
   * @param text where to append
   * @return false if nothing was appended
   * @throws IllegalStateException if there is no value
   */
  protected boolean appendValue(StringBuilder text) {
    return false;
  }

  private CharSequence writeText() {
    if (!builtIn) {
      return getStringValue();
    }
    StringBuilder text = writeText;
    if (text == null) {
      text = new StringBuilder();
      writeText = text;
    }
    text.setLength(0);
    return appendValue(text) ? text : getStringValue();
  }

  /** Says whether the value can have characters that function 0 of C3 Bridge does not give. */
  boolean holdsText() {
    return false;
  }

  /**
   * Makes the exception for a value that is asked for too early.
   *
   * @return the exception, to be thrown
   */
  protected IllegalStateException noValue() {
    return new IllegalStateException(name + " has no value: it was neither set nor read");
  }

  /**
   * Gives how long the last read or write took.
   *
   * @return from sending the request to having the answer, in ns; -1 if there was none
   */
  public long getReadTimeNano() {
    return readTime;
  }

  /**
   * Gives how long the last read or write took.
   *
   * @return in whole ms; 0 if there was none
   */
  public long getReadTimeMillis() {
    return readTime / 1_000_000;
  }

  /**
   * Gives how long the last read or write took.
   *
   * @return in s
   */
  public double getReadTimeSec() {
    return readTime / 1e9;
  }

  /**
   * Sets the local value as if it had been read.
   *
   * @param answerId must be {@link #getId()}
   * @param strValue the text as a controller prints it
   * @param readTimeNanos how long it took, in ns
   * @deprecated the client does this; kept for programs of the original that simulate answers
   */
  @Deprecated
  public void update(int answerId, String strValue, long readTimeNanos) {
    if (answerId != id) {
      throw new IllegalArgumentException("id must be " + id + ", is " + answerId);
    }
    setValueFromString(strValue);
    readTime = readTimeNanos;
  }

  /**
   * Gives the frame that asks for this variable.
   *
   * @return the bytes
   * @deprecated use {@link no.hials.crosscom.CrossComClient#readVariable}, or {@link Codec} for
   *     bytes
   */
  @Deprecated
  public Byte[] getReadCommand() {
    return BoxedFrame.of(new ReadRequest(id & 0xFFFF, name));
  }

  /**
   * Gives the frame that writes this variable.
   *
   * @return the bytes
   * @deprecated use {@link no.hials.crosscom.CrossComClient#writeVariable}, or {@link Codec} for
   *     bytes
   */
  @Deprecated
  public Byte[] getWriteCommand() {
    return BoxedFrame.of(new WriteRequest(id & 0xFFFF, name, getStringValue()));
  }

  /**
   * Makes a variable for the jog override.
   *
   * @return {@code $OV_JOG}, in %
   */
  public static KRLReal OV_JOG() {
    return new KRLReal("$OV_JOG");
  }

  /**
   * Makes a variable for the program override.
   *
   * @return {@code $OV_PRO}, in %
   */
  public static KRLReal OV_PRO() {
    return new KRLReal("$OV_PRO");
  }

  /**
   * Makes a variable for the axis angles.
   *
   * @return {@code $AXIS_ACT}, in degrees or mm
   */
  public static KRLE6Axis AXIS_ACT() {
    return new KRLE6Axis("$AXIS_ACT");
  }

  /**
   * Makes a variable for the position of the tool.
   *
   * @return {@code $POS_ACT}, in mm and degrees
   */
  public static KRLE6Pos POS_ACT() {
    return new KRLE6Pos("$POS_ACT");
  }

  /** Gives the value as {@link #toString} shows it. */
  @Nullable Object valueForPeople() {
    return getValue();
  }

  @Override
  public String toString() {
    return "KRLVariable{id="
        + id
        + ", name="
        + name
        + ", value="
        + valueForPeople()
        + ", readTime="
        + getReadTimeMillis()
        + "ms}";
  }

  /** What the client may do. */
  private static final class Access extends VariableAccess {
    @Override
    public byte @Nullable [] readFrame(KRLVariable variable) {
      return variable.readFrame;
    }

    @Override
    public boolean holdsText(KRLVariable variable) {
      return variable.holdsText();
    }

    @Override
    public CharSequence writeText(KRLVariable variable) {
      return variable.writeText();
    }

    @Override
    public boolean scan(KRLVariable variable, KrlScanner scanner, boolean written) {
      return variable.setValueFrom(scanner, written);
    }

    @Override
    public void setFromString(KRLVariable variable, String text) {
      variable.setValueFromString(text);
    }

    @Override
    public void scanElement(KRLArray array, KrlScanner scanner, int index) {
      array.read(scanner, index);
      scanner.expectEnd();
    }

    @Override
    public void acceptElements(KRLArray array, int count) {
      array.acceptAll(count);
    }

    @Override
    public void setReadTime(KRLVariable variable, long nanos) {
      variable.readTime = nanos;
    }
  }
}
