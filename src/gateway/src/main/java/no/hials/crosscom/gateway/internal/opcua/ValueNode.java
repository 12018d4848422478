package no.hials.crosscom.gateway.internal.opcua;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import no.hials.crosscom.cell.feed.Quality;
import no.hials.crosscom.cell.feed.Update;
import no.hials.crosscom.protocol.value.KrlValue;
import org.eclipse.milo.opcua.sdk.core.AccessLevel;
import org.eclipse.milo.opcua.sdk.server.AccessContext;
import org.eclipse.milo.opcua.sdk.server.items.DataItem;
import org.eclipse.milo.opcua.sdk.server.nodes.UaNodeContext;
import org.eclipse.milo.opcua.sdk.server.nodes.UaVariableNode;
import org.eclipse.milo.opcua.stack.core.AttributeId;
import org.eclipse.milo.opcua.stack.core.NodeIds;
import org.eclipse.milo.opcua.stack.core.StatusCodes;
import org.eclipse.milo.opcua.stack.core.UaException;
import org.eclipse.milo.opcua.stack.core.types.builtin.DataValue;
import org.eclipse.milo.opcua.stack.core.types.builtin.DateTime;
import org.eclipse.milo.opcua.stack.core.types.builtin.LocalizedText;
import org.eclipse.milo.opcua.stack.core.types.builtin.NodeId;
import org.eclipse.milo.opcua.stack.core.types.builtin.QualifiedName;
import org.eclipse.milo.opcua.stack.core.types.builtin.StatusCode;
import org.eclipse.milo.opcua.stack.core.types.builtin.Variant;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UByte;
import org.eclipse.milo.opcua.stack.core.types.builtin.unsigned.UInteger;
import org.jspecify.annotations.Nullable;

/**
 * A variable whose value comes from a reading. The value is converted only when a client reads or
 * watches it.
 */
final class ValueNode extends UaVariableNode {
  private final @Nullable Reading reading;
  private final UnaryOperator<@Nullable KrlValue> part;
  private final Function<KrlValue, @Nullable Object> conversion;
  private final Access access;
  private final Set<DataItem> items = ConcurrentHashMap.newKeySet();

  /** The variable of a robot that clients may change through a node. */
  interface Access {
    /** A node that nobody may change. */
    Access READ_ONLY =
        new Access() {
          @Override
          public String robot() {
            return "";
          }

          @Override
          public String variable() {
            return "";
          }

          @Override
          public boolean isWritable() {
            return false;
          }

          @Override
          public void describe(ValueNode node) {}
        };

    /** Returns the name of the robot. */
    String robot();

    /** Returns the name that reads and writes the value on its own. */
    String variable();

    /** Returns whether operators may write it. */
    boolean isWritable();

    /** Called when the type of the value is known. */
    void describe(ValueNode node);
  }

  /**
   * Creates a node.
   *
   * @param reading where the value comes from; null if nothing reads it
   * @param part returns the part of the reading that is the value of the node
   * @param conversion converts the value for clients; returns null if it cannot
   */
  ValueNode(
      UaNodeContext context,
      NodeId id,
      QualifiedName name,
      NodeId dataType,
      @Nullable Reading reading,
      UnaryOperator<@Nullable KrlValue> part,
      Function<KrlValue, @Nullable Object> conversion,
      Access access) {
    super(
        context,
        id,
        name,
        LocalizedText.english(name.name()),
        LocalizedText.NULL_VALUE,
        UInteger.MIN,
        UInteger.MIN);
    this.reading = reading;
    this.part = part;
    this.conversion = conversion;
    this.access = access;
    setDataType(dataType);
  }

  /** Adds the properties that depend on the type of the value. */
  void describe() {
    access.describe(this);
  }

  /** Returns the last value of the robot, or null. */
  @Nullable KrlValue krlValue() {
    KrlValue whole = reading == null ? null : reading.value();
    return whole == null ? null : part.apply(whole);
  }

  /** Returns whether operators may write it. */
  boolean isWritable() {
    return access.isWritable();
  }

  /** Returns the robot and the name that writes it. */
  Access access() {
    return access;
  }

  /** Returns whether it is a number; false if its type is not known yet. */
  boolean isNumber() {
    return getDataType().equals(NodeIds.Int32) || getDataType().equals(NodeIds.Double);
  }

  @Override
  public DataValue getValue() {
    if (reading == null) {
      return new DataValue(StatusCodes.Bad_NotSupported);
    }
    Update update = reading.last();
    if (update == null) {
      return new DataValue(StatusCodes.Bad_WaitingForInitialData);
    }
    KrlValue whole = update.value();
    KrlValue own = whole == null ? null : part.apply(whole);
    Object value = own == null ? null : conversion.apply(own);
    return new DataValue(
        value == null ? Variant.NULL_VALUE : new Variant(value),
        status(update.quality(), value != null),
        new DateTime(update.time()),
        DateTime.now());
  }

  private static StatusCode status(Quality quality, boolean hasValue) {
    return new StatusCode(
        switch (quality) {
          // a field that the controller has not initialised
          case GOOD -> hasValue ? StatusCodes.Good : StatusCodes.Bad_NoDataAvailable;
          case STALE ->
              hasValue ? StatusCodes.Uncertain_LastUsableValue : StatusCodes.Bad_NoCommunication;
          case BAD -> StatusCodes.Bad_ConfigurationError;
        });
  }

  @Override
  public synchronized Object getAttribute(AttributeId attribute) {
    return switch (attribute) {
      case Value -> getValue();
      case AccessLevel -> level(access.isWritable());
      default -> super.getAttribute(attribute);
    };
  }

  @Override
  public UByte getAccessLevel() {
    return level(access.isWritable());
  }

  @Override
  public Object getAttribute(AccessContext context, AttributeId attribute) {
    if (attribute == AttributeId.UserAccessLevel) {
      return userLevel(context);
    }
    return getAttribute(attribute);
  }

  @Override
  public Object readAttribute(AccessContext context, AttributeId attribute) throws UaException {
    return getAttribute(context, attribute);
  }

  private UByte userLevel(AccessContext context) {
    boolean operator =
        context
            .getSession()
            .map(session -> Users.of(session).role() == User.Role.OPERATOR)
            .orElse(false);
    return level(operator && access.isWritable());
  }

  private static UByte level(boolean writable) {
    return writable
        ? AccessLevel.toValue(AccessLevel.CurrentRead, AccessLevel.CurrentWrite)
        : AccessLevel.toValue(AccessLevel.CurrentRead);
  }

  /**
   * Returns the lock under which clients get values, so that no older value follows a newer one.
   */
  private Object lock() {
    return reading == null ? this : reading;
  }

  /** Passes the current value and later ones on to an item of a subscription. */
  void watch(DataItem item) {
    synchronized (lock()) {
      items.add(item);
      if (reading != null) {
        reading.watch(this, true);
      }
      item.setValue(getValue());
    }
  }

  /** Stops passing values on to an item. */
  void forget(DataItem item) {
    synchronized (lock()) {
      items.remove(item);
      if (reading != null && items.isEmpty()) {
        reading.watch(this, false);
      }
    }
  }

  /** Passes the current value on; called with the reading locked. */
  void push() {
    DataValue value = getValue();
    for (DataItem item : items) {
      item.setValue(value);
    }
  }
}
