package no.hials.crosscom.c3;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.protocol.code.CopyFlag;
import org.jspecify.annotations.Nullable;

/**
 * The options of an upload or download. Immutable; created by {@link #create}. The {@link Builder}
 * describes the options.
 */
public final class TransferConfig {
  /** All options at their defaults. */
  public static final TransferConfig DEFAULT = create(cfg -> {});

  private final boolean overwrite;
  private final Set<CopyFlag> flags;
  private final Verification verification;
  private final TransferProgress progress;

  private TransferConfig(Builder builder) {
    overwrite = builder.overwrite;
    flags = builder.flags;
    verification = builder.verification;
    progress = builder.progress;
  }

  /**
   * Creates a configuration.
   *
   * @param settings sets the options that differ from their defaults
   * @return the configuration
   * @throws IllegalArgumentException if a value is out of its range
   */
  public static TransferConfig create(Consumer<Builder> settings) {
    Builder builder = new Builder();
    settings.accept(builder);
    return new TransferConfig(builder);
  }

  /** Returns whether to replace an existing file. */
  public boolean overwrite() {
    return overwrite;
  }

  /** Returns the flags for the controller, never {@link CopyFlag#OVERWRITE}. */
  public Set<CopyFlag> flags() {
    return flags;
  }

  /** Returns how to check that all bytes arrived. */
  public Verification verification() {
    return verification;
  }

  /** Returns the listener for the progress. */
  public TransferProgress progress() {
    return progress;
  }

  /** Returns whether the other is a configuration with equal options. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof TransferConfig config && values().equals(config.values());
  }

  @Override
  public int hashCode() {
    return values().hashCode();
  }

  @Override
  public String toString() {
    return "TransferConfig" + values();
  }

  private Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("overwrite", overwrite);
    values.put("flags", flags);
    values.put("verification", verification);
    values.put("progress", progress);
    return values;
  }

  /** Sets the options. Each method sets one option and returns this builder. */
  public static final class Builder {
    private boolean overwrite;
    private Set<CopyFlag> flags = Set.of();
    private Verification verification = Verification.SIZE;
    private TransferProgress progress = (bytes, total) -> {};

    private Builder() {}

    /** Sets whether to replace an existing file. The default is false. */
    public Builder overwrite(boolean value) {
      overwrite = value;
      return this;
    }

    /**
     * Sets the flags for the controller, any but {@link CopyFlag#OVERWRITE}, which {@link
     * #overwrite} sets. By default there are no flags.
     */
    public Builder flags(CopyFlag... value) {
      Set<CopyFlag> copy = Set.of(value);
      if (copy.contains(CopyFlag.OVERWRITE)) {
        throw new IllegalArgumentException("use overwrite(true) instead of the flag OVERWRITE");
      }
      flags = copy;
      return this;
    }

    /** Sets how to check that all bytes arrived. The default is {@link Verification#SIZE}. */
    public Builder verification(Verification value) {
      verification = Objects.requireNonNull(value, "verification");
      return this;
    }

    /**
     * Sets the listener for the progress, called in the thread that transfers. The default does
     * nothing.
     */
    public Builder progress(TransferProgress value) {
      progress = Objects.requireNonNull(value, "progress");
      return this;
    }
  }
}
