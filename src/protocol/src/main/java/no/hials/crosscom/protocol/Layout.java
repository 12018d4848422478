package no.hials.crosscom.protocol;

/**
 * How the fields of one message lie between the function byte and the end of a request or the tail
 * of an answer.
 *
 * @param <M> the message
 * @param writer writes the fields
 * @param reader reads them; the id and, for an answer, the tail are read already
 */
record Layout<M>(Writer<M> writer, Reader<M> reader) {

  /** Writes a message's fields. */
  @FunctionalInterface
  interface Writer<M> {
    void write(M message, WireBuffer out);
  }

  /** Reads a message's fields. */
  @FunctionalInterface
  interface Reader<M> {
    M read(int id, WireBuffer in, Tail tail) throws MalformedFrameException;
  }

  /**
   * Makes the layout of the answers of C3 Bridge of one type: as given, or nothing at all if the
   * access failed, as in c3-vectors.tsv, "29 data without fields". That this can be with every type
   * is assumed.
   */
  static Layout<TypedResponse> orNothing(
      MessageType type, Layout<? extends TypedResponse> complete) {
    return new Layout<>(
        (m, out) -> {
          if (!(m instanceof PlainResponse)) {
            complete.writeAny(m, out);
          }
        },
        (id, in, tail) ->
            in.isEmpty() && !tail.success()
                ? new PlainResponse(id, type, tail)
                : complete.reader().read(id, in, tail));
  }

  /** Writes a message whose class only the caller's dispatch knows. */
  @SuppressWarnings("unchecked") // a MessageType pairs each layout with the class it is for
  void writeAny(Object message, WireBuffer out) {
    writer.write((M) message, out);
  }
}
