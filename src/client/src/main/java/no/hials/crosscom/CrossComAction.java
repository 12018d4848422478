package no.hials.crosscom;

/** Operations of a client without a result, for {@link CrossComClient#asyncRun}. */
@FunctionalInterface
public interface CrossComAction {
  /**
   * Does the operations.
   *
   * @param client the client to use
   * @throws Exception if an operation fails; the future fails with the same exception
   */
  void run(CrossComClient client) throws Exception;
}
