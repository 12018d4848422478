package no.hials.crosscom.c3;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import no.hials.crosscom.protocol.code.CopyFlag;

/**
 * The options of an upload or download. Immutable; created by {@link #create}.
 *
 * @param overwrite whether to replace an existing file; default false
 * @param flags flags for the controller, except {@link CopyFlag#OVERWRITE}, which {@code overwrite}
 *     sets; default none
 * @param verification how to check that all bytes arrived; default {@link Verification#SIZE}
 * @param progress called with the progress; default nothing
 */
public record TransferConfig(
    boolean overwrite, Set<CopyFlag> flags, Verification verification, TransferProgress progress) {

  /** All options at their defaults. */
  public static final TransferConfig DEFAULT = create(cfg -> {});

  /** Checks every field. */
  public TransferConfig {
    EnumSet<CopyFlag> copy = EnumSet.noneOf(CopyFlag.class);
    copy.addAll(flags);
    if (copy.contains(CopyFlag.OVERWRITE)) {
      throw new IllegalArgumentException("say overwrite(true) instead of the flag OVERWRITE");
    }
    flags = Collections.unmodifiableSet(copy);
    Objects.requireNonNull(verification, "verification");
    Objects.requireNonNull(progress, "progress");
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
    return new TransferConfig(
        builder.overwrite, builder.flags, builder.verification, builder.progress);
  }

  /**
   * Sets the options. Each method returns this builder; the component of the same name describes
   * its option.
   */
  public static final class Builder {
    private boolean overwrite;
    private Set<CopyFlag> flags = Set.of();
    private Verification verification = Verification.SIZE;
    private TransferProgress progress = (bytes, total) -> {};

    private Builder() {}

    /** Sets whether to replace an existing file. */
    public Builder overwrite(boolean value) {
      overwrite = value;
      return this;
    }

    /** Sets the flags for the controller, any but {@link CopyFlag#OVERWRITE}. */
    public Builder flags(CopyFlag... value) {
      flags = Set.of(value);
      return this;
    }

    /** Sets how to check that all bytes arrived. */
    public Builder verification(Verification value) {
      verification = value;
      return this;
    }

    /** Sets the listener for the progress, called in the thread that transfers. */
    public Builder progress(TransferProgress value) {
      progress = value;
      return this;
    }
  }
}
