package no.hials.crosscom.mock.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.function.Predicate;
import no.hials.crosscom.lang.TypeSwitch;
import no.hials.crosscom.protocol.ErrorCode;
import no.hials.crosscom.protocol.MalformedRequestException;
import no.hials.crosscom.protocol.MessageType;
import no.hials.crosscom.protocol.PlainResponse;
import no.hials.crosscom.protocol.Request;
import no.hials.crosscom.protocol.Response;
import no.hials.crosscom.protocol.Tail;
import no.hials.crosscom.protocol.TextResponse;
import no.hials.crosscom.protocol.TypedResponse;
import no.hials.crosscom.protocol.code.Code;
import no.hials.crosscom.protocol.code.ContentOperation;
import no.hials.crosscom.protocol.code.FileAttribute;
import no.hials.crosscom.protocol.code.FileProperty;
import no.hials.crosscom.protocol.code.Flags;
import no.hials.crosscom.protocol.code.ItemType;
import no.hials.crosscom.protocol.file.Bytes;
import no.hials.crosscom.protocol.file.FileProperties;
import no.hials.crosscom.protocol.file.FileRequest;
import no.hials.crosscom.protocol.file.FileRequest.BeginReadRequest;
import no.hials.crosscom.protocol.file.FileRequest.BeginWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.ContentRequest;
import no.hials.crosscom.protocol.file.FileRequest.CopyFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.CreateFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.DeleteFileRequest;
import no.hials.crosscom.protocol.file.FileRequest.EndWriteRequest;
import no.hials.crosscom.protocol.file.FileRequest.FileNameRequest;
import no.hials.crosscom.protocol.file.FileRequest.FilePropertiesRequest;
import no.hials.crosscom.protocol.file.FileRequest.ListDirectoryRequest;
import no.hials.crosscom.protocol.file.FileRequest.ReadDataRequest;
import no.hials.crosscom.protocol.file.FileRequest.SetAttributesRequest;
import no.hials.crosscom.protocol.file.FileRequest.WriteDataRequest;
import no.hials.crosscom.protocol.file.FileResponse.ContentResponse;
import no.hials.crosscom.protocol.file.FileResponse.ContentSizeResponse;
import no.hials.crosscom.protocol.file.FileResponse.FilePropertiesResponse;
import no.hials.crosscom.protocol.file.FileResponse.ListDirectoryResponse;
import no.hials.crosscom.protocol.file.FileResponse.ReadDataResponse;
import no.hials.crosscom.protocol.file.FileResponse.WriteDataResponse;
import no.hials.crosscom.protocol.file.ItemTime;
import no.hials.crosscom.simulator.FileTree;
import no.hials.crosscom.simulator.internal.files.ControllerFileSystem;
import no.hials.crosscom.simulator.internal.files.FileItem;
import no.hials.crosscom.simulator.internal.files.FileRefusedException;
import no.hials.crosscom.simulator.internal.files.TransferBuffer;

/**
 * Answers the messages 20 to 30 of one connection as C3 Bridge does
 * (docs/reference/c3-messages.md#files-20-to-28). A connection has two buffers, one for writing and
 * one for reading; it is assumed that connections do not share them.
 *
 * <p>Not thread-safe. Other connections can use the same files at the same time.
 */
public final class C3FileHandler implements AutoCloseable {
  private static final TypeSwitch<C3FileHandler, FileRequest, TypedResponse, RuntimeException>
      REQUESTS =
          TypeSwitch.create(
              FileRequest.class,
              cases ->
                  cases
                      .on(ListDirectoryRequest.class, C3FileHandler::list)
                      .on(FilePropertiesRequest.class, C3FileHandler::properties)
                      .on(FileNameRequest.class, C3FileHandler::name)
                      .on(WriteDataRequest.class, C3FileHandler::writeData)
                      .on(ReadDataRequest.class, C3FileHandler::readData)
                      .on(
                          BeginWriteRequest.class,
                          (it, begin) ->
                              it.size(
                                  begin,
                                  ContentOperation.BEGIN,
                                  run(() -> it.writing.begin(begin.size()))))
                      .on(BeginReadRequest.class, C3FileHandler::beginRead)
                      .on(
                          EndWriteRequest.class,
                          (it, end) ->
                              content(end, Code.of(ContentOperation.END), run(() -> it.end(end))))
                      .on(ContentRequest.class, C3FileHandler::content)
                      .on(
                          SetAttributesRequest.class,
                          (it, set) ->
                              plain(
                                  set,
                                  () ->
                                      it.tree.setAttributes(
                                          set.name(), set.attributes(), set.mask())))
                      .on(
                          CreateFileRequest.class,
                          (it, create) -> plain(create, () -> it.create(create)))
                      .on(
                          DeleteFileRequest.class,
                          (it, delete) ->
                              plain(
                                  delete,
                                  () ->
                                      it.tree.delete(delete.name(), delete.always(), it.selected)))
                      .on(CopyFileRequest.class, (it, copy) -> plain(copy, () -> it.copy(copy))));

  /** Operation, offset and size, which precede the data of a write. */
  private static final int DATA_FIELDS = 1 + 4 + 4;

  private final ControllerFileSystem tree;
  private final Predicate<String> selected;
  private final TransferBuffer writing;
  private final TransferBuffer reading;

  /**
   * Creates the handler of one connection.
   *
   * @param files the files
   * @param selected whether the module of a name in capital letters is selected; its files cannot
   *     be changed then (assumed)
   */
  public C3FileHandler(FileTree files, Predicate<String> selected) {
    tree = ControllerFileSystem.of(files);
    this.selected = selected;
    writing = new TransferBuffer(tree);
    reading = new TransferBuffer(tree);
  }

  /** Releases the buffers. */
  @Override
  public void close() {
    writing.close();
    reading.close();
  }

  /** Answers a request of a type from 20 to 30. */
  public TypedResponse handle(FileRequest request) {
    return REQUESTS.apply(this, request);
  }

  private WriteDataResponse writeData(WriteDataRequest data) {
    int written = writing.write(data.offset(), data.data());
    return new WriteDataResponse(data.id(), data.offset(), written, Tail.SUCCESS);
  }

  private ReadDataResponse readData(ReadDataRequest data) {
    Bytes read = reading.read(data.offset(), data.size());
    return new ReadDataResponse(data.id(), data.offset(), read, Tail.SUCCESS);
  }

  private static PlainResponse plain(Request request, Work change) {
    return new PlainResponse(request.id(), request.type(), run(change));
  }

  private interface Work {
    void run() throws IOException;
  }

  private static Tail run(Work work) {
    try {
      work.run();
      return Tail.SUCCESS;
    } catch (IOException e) {
      return failure(e);
    }
  }

  private static Tail failure(IOException e) {
    return C3Answers.tail(
        e instanceof FileRefusedException refused ? refused.code() : ErrorCode.GENERAL);
  }

  private void create(CreateFileRequest request) throws IOException {
    // measured for 0, assumed for unknown numbers
    ItemType type = request.itemType().known().orElse(ItemType.UNKNOWN);
    tree.create(
        request.name(), type, request.parts(), request.always(), request.template(), selected);
  }

  private void copy(CopyFileRequest request) throws IOException {
    if (request.type() == MessageType.COPY_FILE) {
      tree.copy(request.source(), request.destination(), request.flags(), selected);
    } else {
      tree.move(request.source(), request.destination(), request.flags(), selected);
    }
  }

  private ListDirectoryResponse list(ListDirectoryRequest request) {
    try {
      ControllerFileSystem.Listed found =
          tree.list(request.path(), request.types(), request.flags());
      return new ListDirectoryResponse(request.id(), found.names(), found.infos(), Tail.SUCCESS);
    } catch (IOException e) {
      return new ListDirectoryResponse(request.id(), List.of(), List.of(), failure(e));
    }
  }

  private FilePropertiesResponse properties(FilePropertiesRequest request) {
    try {
      FileProperties found = properties(tree.item(request.name()), request.properties());
      return new FilePropertiesResponse(request.id(), found, Tail.SUCCESS);
    } catch (IOException e) {
      return new FilePropertiesResponse(request.id(), FileProperties.NONE, failure(e));
    }
  }

  private FileProperties properties(FileItem item, Flags<FileProperty> wanted) {
    FileProperties none = FileProperties.NONE;
    return new FileProperties(
        wanted.has(FileProperty.TYPE) ? Code.of(item.type()) : none.itemType(),
        wanted.has(FileProperty.SIZE) ? item.size() : 0,
        wanted.has(FileProperty.ATTRIBUTES)
            ? new Flags<>(FileAttribute.class, item.attributes())
            : none.attributes(),
        time(wanted.has(FileProperty.CREATION), item.created()),
        time(wanted.has(FileProperty.ACCESS), item.accessed()),
        time(wanted.has(FileProperty.MODIFICATION), item.modified()),
        wanted.has(FileProperty.EDIT_MODE) ? Code.of(item.editMode()) : none.editMode(),
        wanted.has(FileProperty.NAME) ? item.path().name() : "");
  }

  private ItemTime time(boolean wanted, Instant time) {
    return wanted
        ? new ItemTime(
            time.truncatedTo(ChronoUnit.MICROS), tree.biasMinutes(time)) // a FILETIME has 100 ns
        : ItemTime.NONE;
  }

  private TextResponse name(FileNameRequest request) {
    try {
      String name =
          request.type() == MessageType.FULL_NAME
              ? tree.fullName(request.path())
              : tree.krcName(request.path());
      return new TextResponse(request.id(), request.type(), name, Tail.SUCCESS);
    } catch (IOException e) {
      return new TextResponse(request.id(), request.type(), "", failure(e));
    }
  }

  private ContentSizeResponse beginRead(BeginReadRequest request) {
    // assumed: a file that cannot be read does not leave the last one in the buffer
    reading.close();
    Tail tail = run(() -> reading.begin(tree.read(request.name())));
    return size(request, ContentOperation.BEGIN, tail);
  }

  /**
   * Stores the content of the buffer; if that fails the buffer stays
   * (docs/reference/c3-messages.md#file-content-29-and-30).
   */
  private void end(EndWriteRequest request) throws IOException {
    if (!writing.isOpen()) {
      throw new FileRefusedException(ErrorCode.UNEXPECTED, "no transfer has begun"); // assumed
    }
    tree.write(request.name(), writing.content(), request.flags(), selected);
    writing.close();
  }

  private TypedResponse content(ContentRequest request) {
    if (request.operation().is(ContentOperation.SIZE)) {
      return size(request, ContentOperation.SIZE, Tail.SUCCESS);
    }
    if (request.operation().is(ContentOperation.END)) {
      reading.close();
      return content(request, request.operation(), Tail.SUCCESS);
    }
    return content(request, request.operation(), C3Answers.tail(ErrorCode.NOT_IMPLEMENTED));
  }

  private static ContentResponse content(
      Request request, Code<ContentOperation> operation, Tail tail) {
    return content(request.id(), request.type(), operation, tail);
  }

  private static ContentResponse content(
      int id, MessageType type, Code<ContentOperation> operation, Tail tail) {
    return new ContentResponse(id, type, operation, tail);
  }

  private ContentSizeResponse size(Request request, ContentOperation operation, Tail tail) {
    return size(request.id(), request.type(), operation, tail);
  }

  private ContentSizeResponse size(
      int id, MessageType type, ContentOperation operation, Tail tail) {
    int size = (type == MessageType.WRITE_CONTENT ? writing : reading).size();
    return new ContentSizeResponse(id, type, operation, size, tail);
  }

  /**
   * Answers a request of a type from 20 to 30 with malformed fields
   * (docs/reference/c3-messages.md#file-content-29-and-30). Of file content, those of type 29 are
   * measured, those of type 30 assumed.
   */
  Response malformed(MalformedRequestException request) {
    int id = request.id();
    MessageType type = request.type();
    byte[] fields = request.fields();
    Tail tail = C3Answers.tail(ErrorCode.PROTOCOL);
    if (type != MessageType.WRITE_CONTENT && type != MessageType.READ_CONTENT) {
      return C3Answers.empty(id, type, fields, tail);
    }
    Code<ContentOperation> operation =
        new Code<>(ContentOperation.class, fields.length == 0 ? 0 : fields[0] & 0xFF);
    if (operation.is(ContentOperation.BEGIN)) {
      return size(id, type, ContentOperation.BEGIN, tail);
    }
    if (operation.is(ContentOperation.END)) {
      return content(id, type, operation, tail);
    }
    if (type == MessageType.WRITE_CONTENT && fields.length >= DATA_FIELDS && !writing.isOpen()) {
      long offset = Integer.toUnsignedLong(ByteBuffer.wrap(fields).getInt(1));
      return new WriteDataResponse(id, offset, 0, Tail.SUCCESS);
    }
    return new PlainResponse(id, type, tail);
  }
}
