package no.hials.crosscom.KRL;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import no.hials.crosscom.KRL.structs.KRLE6Axis;
import no.hials.crosscom.KRL.structs.KRLE6Pos;
import no.hials.crosscom.internal.BoxedFrame;
import no.hials.crosscom.internal.VariableAccess;
import no.hials.crosscom.internal.VariableName;
import no.hials.crosscom.protocol.Codec;
import no.hials.crosscom.protocol.value.KrlScanner;
import no.hials.crosscom.protocol.value.KrlText;
import no.hials.crosscom.protocol.variable.VariableRequest.ReadRequest;
import no.hials.crosscom.protocol.variable.VariableRequest.WriteRequest;
import org.jspecify.annotations.Nullable;

/**
 * Holds the local copy of a variable of the controller.
 *
 * <p>Programs may derive classes. The client's own classes read numbers without creating objects.
 */
public abstract class KRLVariable {
  private static final AtomicInteger IDS = new AtomicInteger(1);

  private final int id;
  private final String name;
  private final byte @Nullable [] readFrame;
  private long readTime = -1;

  /** Whether the class is part of the client, so its printing is not overridden. */
  private final boolean builtIn = isBuiltIn(getClass());

  /** Whether the class is a program's, with a method of its own that sets the value from text. */
  private final boolean parsesItself = !builtIn && parsesItself(getClass());

  private @Nullable KrlText writeText;

  static {
    VariableAccess.set(new Access());
  }

  /**
   * Creates a variable.
   *
   * @param name the name on the controller, such as {@code $OV_PRO}, {@code MYPOS.X} or {@code
   *     $TORQUE_AXIS_ACT[3]}; the controller ignores case
   * @throws IllegalArgumentException if the name is blank or too long for a message
   */
  public KRLVariable(String name) {
    this.name = VariableName.check(name);
    this.id = IDS.getAndIncrement();
    boolean ascii = name.chars().allMatch(c -> c < 0x80);
    this.readFrame = ascii ? Codec.encode(new ReadRequest(0, name)) : null;
  }

  /**
   * Returns a number that is unique in this program. It is not the id of the messages.
   *
   * @return the number, from 1; later variables have larger numbers
   */
  public int getId() {
    return id;
  }

  /** Returns the name on the controller. */
  public String getName() {
    return name;
  }

  /** Returns the name of the variable's class, such as {@code KRLReal}. */
  public String getType() {
    return getClass().getSimpleName();
  }

  /**
   * Returns the local value.
   *
   * @return the value; null for a scalar, string or array that was neither set nor read
   */
  public abstract @Nullable Object getValue();

  /**
   * Returns the text that a write sends.
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
   * Sets the local value from KRL text in place. If a class does not override this method, {@link
   * #setValueFromString} sets the value.
   *
   * @param scanner at the start of the text
   * @param written whether the text is from a write, which may name only some fields
   * @return true if the value was set
   * @throws IllegalArgumentException if the text is not a value of this type; the value is then
   *     unchanged
   */
  protected boolean setValueFrom(KrlScanner scanner, boolean written) {
    return false;
  }

  /**
   * Appends the text that a write sends, without creating objects. If a class does not override
   * this method, or is derived by a program, {@link #getStringValue} prints the value.
   *
   * @param text the destination
   * @return false if nothing was appended
   * @throws IllegalStateException without a value
   */
  protected boolean appendValue(KrlText text) {
    return false;
  }

  /**
   * Returns whether a program's class overrides {@link #setValueFromString}, which then must be
   * called instead of a method of the client that sets the value in place.
   */
  private static boolean parsesItself(Class<?> type) {
    for (Class<?> c = type; c != null && !isBuiltIn(c); c = c.getSuperclass()) {
      List<String> names = Arrays.stream(c.getDeclaredMethods()).map(Method::getName).toList();
      if (names.contains("setValueFrom")) {
        return false;
      }
      if (names.contains("setValueFromString")) {
        return true;
      }
    }
    return false;
  }

  private static boolean isBuiltIn(Class<?> type) {
    return type.getPackageName().startsWith(KRLVariable.class.getPackageName());
  }

  private CharSequence writeText() {
    if (!builtIn) {
      return getStringValue();
    }
    KrlText text = writeText;
    if (text == null) {
      text = new KrlText();
      writeText = text;
    }
    return appendValue(text.clear()) ? text : getStringValue();
  }

  /**
   * Returns whether the value can contain a text or an ENUM, so that it must be read in the charset
   * of the controller. If a class does not override this method, it can.
   */
  protected boolean holdsText() {
    return true;
  }

  /** Returns the exception to throw for a variable without a value. */
  protected IllegalStateException noValue() {
    return new IllegalStateException(name + " has no value: it was neither set nor read");
  }

  /**
   * Returns the time of the last read or write.
   *
   * @return from sending the request to receiving the answer, in ns; -1 before the first access
   */
  public long getReadTimeNano() {
    return readTime;
  }

  /** Returns the time of the last read or write in whole ms; 0 before the first access. */
  public long getReadTimeMillis() {
    return readTime / 1_000_000;
  }

  /** Returns the time of the last read or write in s. */
  public double getReadTimeSec() {
    return readTime / 1e9;
  }

  /**
   * Sets the local value as a read does.
   *
   * @param answerId must be {@link #getId()}
   * @param strValue the text as a controller prints it
   * @param readTimeNanos the time of the access, in ns
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
   * Returns the frame that reads this variable.
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
   * Returns the frame that writes this variable.
   *
   * @return the bytes
   * @deprecated use {@link no.hials.crosscom.CrossComClient#writeVariable}, or {@link Codec} for
   *     bytes
   */
  @Deprecated
  public Byte[] getWriteCommand() {
    return BoxedFrame.of(new WriteRequest(id & 0xFFFF, name, getStringValue()));
  }

  /** Returns a new variable for the jog override {@code $OV_JOG}, in %. */
  public static KRLReal OV_JOG() {
    return new KRLReal("$OV_JOG");
  }

  /** Returns a new variable for the program override {@code $OV_PRO}, in %. */
  public static KRLReal OV_PRO() {
    return new KRLReal("$OV_PRO");
  }

  /** Returns a new variable for the axis positions {@code $AXIS_ACT}, in degrees or mm. */
  public static KRLE6Axis AXIS_ACT() {
    return new KRLE6Axis("$AXIS_ACT");
  }

  /**
   * Returns a new variable for {@code $POS_ACT}, the position of the tool, in mm and degrees. It
   * was a KRLReal in the original, which could never be read
   * (docs/reference/compatibility.md#changed-on-purpose).
   */
  public static KRLE6Pos POS_ACT() {
    return new KRLE6Pos("$POS_ACT");
  }

  /** Returns the value as shown by {@link #toString}. */
  @Nullable Object valueForPeople() {
    return getValue();
  }

  /** Returns the type of the value as named in a message. */
  String typeForPeople() {
    return getType();
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

  /** The access of the client. */
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
    public String type(KRLVariable variable) {
      return variable.typeForPeople();
    }

    @Override
    public KRLEnum newEnum(String name, Class<?> type) {
      return new KRLEnum(name, type.getSimpleName());
    }

    @Override
    public IllegalArgumentException cause(IllegalArgumentException failure) {
      return failure instanceof RecordShape.PathException
          ? new IllegalArgumentException(failure.getMessage(), failure.getCause())
          : failure;
    }

    @Override
    public CharSequence writeText(KRLVariable variable) {
      return variable.writeText();
    }

    @Override
    public boolean scan(KRLVariable variable, KrlScanner scanner, boolean written) {
      return !variable.parsesItself && variable.setValueFrom(scanner, written);
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
