package no.hials.crosscom.kafka.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.AdminClientConfig;
import org.apache.kafka.clients.consumer.OffsetAndMetadata;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.connect.errors.ConnectException;
import org.apache.kafka.connect.sink.SinkRecord;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Claims, and what the next task makes of them. The brokers do not answer. */
@Timeout(60)
class ClaimsTest {
  private static final TopicPartition ONE = new TopicPartition("commands", 0);
  private static final TopicPartition TWO = new TopicPartition("commands", 1);
  private static final OffsetAndMetadata NO_CLAIM = new OffsetAndMetadata(0, "");

  private final List<Claims> opened = new ArrayList<>();
  private ServerSocket silent;
  private Claims claims;

  @BeforeEach
  void open() throws Exception {
    silent = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    claims = claims(NO_CLAIM);
  }

  @AfterEach
  void close() throws Exception {
    opened.forEach(Claims::close);
    silent.close();
  }

  private Claims claims() {
    Map<String, Object> properties =
        Map.of(
            AdminClientConfig.BOOTSTRAP_SERVERS_CONFIG,
            "127.0.0.1:" + silent.getLocalPort(),
            AdminClientConfig.REQUEST_TIMEOUT_MS_CONFIG,
            "100",
            AdminClientConfig.DEFAULT_API_TIMEOUT_MS_CONFIG,
            "100");
    Claims created = new Claims(Admin.create(properties), "connect-writes", Duration.ofMinutes(1));
    opened.add(created);
    return created;
  }

  /** Returns the claims of a task that finds this offset of partition one. */
  private Claims claims(OffsetAndMetadata committed) {
    Claims created = claims();
    var unused = created.open(List.of(ONE), Map.of(ONE, committed));
    return created;
  }

  private static SinkRecord record(TopicPartition partition, long offset) {
    return new SinkRecord(partition.topic(), partition.partition(), null, null, null, null, offset);
  }

  private static SinkRecord record(long offset) {
    return record(ONE, offset);
  }

  private void hold(long from, long end) {
    LongStream.range(from, end).forEach(offset -> claims.hold(record(offset)));
  }

  private static Map<TopicPartition, OffsetAndMetadata> offsets(Claims of, long position) {
    return of.offsets(Map.of(ONE, new OffsetAndMetadata(position)));
  }

  private OffsetAndMetadata committed(long position) {
    return offsets(claims, position).get(ONE);
  }

  /** Returns how a task treats the records of partition one. */
  private static List<String> fates(Claims of, long from, long end) {
    LongStream.range(from, end)
        .mapToObj(ClaimsTest::record)
        .filter(it -> !of.isSettled(it))
        .forEach(of::hold);
    Set<Long> unknown =
        of.unknown().stream().map(SinkRecord::originalKafkaOffset).collect(Collectors.toSet());
    return LongStream.range(from, end)
        .mapToObj(
            offset ->
                offset
                    + (of.isSettled(record(offset))
                        ? " settled"
                        : unknown.contains(offset) ? " unknown" : " writes"))
        .toList();
  }

  @Test
  void theReasonWhyTheOffsetsCannotBeReadIsTold() {
    assertThatThrownBy(() -> claims.open(List.of(ONE), Duration.ofMinutes(1)))
        .isInstanceOf(ConnectException.class)
        .hasMessageContaining("cannot read the offsets of the group connect-writes: ")
        .hasMessageContaining("Timed out");
  }

  @Test
  void theNextTaskReportsWhatWasClaimedAndWritesTheRest() {
    hold(0, 2);
    claims.claim();
    hold(2, 3);
    OffsetAndMetadata left = committed(3);
    assertThat(left.offset()).isEqualTo(2);
    Claims next = claims();
    assertThat(next.open(List.of(ONE), Map.of(ONE, left))).containsExactly(Map.entry(ONE, 0L));
    assertThat(fates(next, 0, 3)).containsExactly("0 unknown", "1 unknown", "2 writes");
  }

  @Test
  void unknownRecordsThatWereReportedAreSettled() {
    hold(0, 4);
    claims.claim();
    Claims next = claims(committed(4));
    LongStream.range(0, 5).forEach(offset -> next.hold(record(offset)));
    next.unknown().subList(0, 3).forEach(next::settle);
    OffsetAndMetadata left = offsets(next, 5).get(ONE);
    Claims last = claims();
    assertThat(last.open(List.of(ONE), Map.of(ONE, left))).containsExactly(Map.entry(ONE, 3L));
    assertThat(fates(last, 3, 5)).containsExactly("3 unknown", "4 writes");
  }

  @Test
  void aClaimWhileSomeUnknownRecordsHaveComeKeepsTheOthersUnknown() {
    hold(0, 4);
    claims.claim();
    Claims next = claims(committed(4));
    next.hold(record(0));
    next.claim();
    OffsetAndMetadata left = offsets(next, 1).get(ONE);
    Claims last = claims();
    assertThat(last.open(List.of(ONE), Map.of(ONE, left))).containsExactly(Map.entry(ONE, 0L));
    assertThat(fates(last, 0, 5))
        .containsExactly("0 unknown", "1 unknown", "2 unknown", "3 unknown", "4 writes");
  }

  @Test
  void theNextTaskWritesWhatWasReleasedAndNothingThatWasSettled() {
    hold(0, 6);
    claims.claim();
    claims.settle(record(0));
    claims.settle(record(2));
    claims.settle(record(3));
    claims.settle(record(5));
    claims.release();
    assertThat(claims.hasClaimed()).isFalse();
    OffsetAndMetadata left = committed(6);
    assertThat(left.offset()).isEqualTo(1);
    Claims next = claims();
    assertThat(next.open(List.of(ONE), Map.of(ONE, left))).isEmpty();
    assertThat(fates(next, 1, 7))
        .containsExactly("1 writes", "2 settled", "3 settled", "4 writes", "5 settled", "6 writes");
  }

  @Test
  void whatWasSettledBeforeAClaimIsNotUnknownToTheNextTask() {
    hold(0, 3);
    claims.claim();
    claims.settle(record(1));
    claims.release();
    hold(3, 4);
    claims.claim();
    assertThat(fates(claims(committed(4)), 0, 5))
        .containsExactly("0 unknown", "1 settled", "2 unknown", "3 unknown", "4 writes");
  }

  @Test
  void whatIsSettledStaysSoForTheTaskAfterTheNextOne() {
    hold(0, 6);
    claims.claim();
    List.of(1L, 2L, 4L).forEach(offset -> claims.settle(record(offset)));
    claims.release();
    OffsetAndMetadata left = committed(6);
    Claims next = claims(left);
    // nothing has come, the first record, two records
    assertThat(fates(claims(offsets(next, 0).get(ONE)), 0, 6)).isEqualTo(fates(claims(left), 0, 6));
    next.hold(record(0));
    assertThat(fates(claims(offsets(next, 1).get(ONE)), 0, 6)).isEqualTo(fates(claims(left), 0, 6));
    assertThat(fates(claims(offsets(next, 2).get(ONE)), 0, 6)).isEqualTo(fates(claims(left), 0, 6));
    next.claim();
    next.settle(record(0));
    next.release();
    assertThat(offsets(next, 2).get(ONE).offset()).isEqualTo(2);
    assertThat(fates(claims(offsets(next, 2).get(ONE)), 2, 7))
        .containsExactly("2 settled", "3 writes", "4 settled", "5 writes", "6 writes");
  }

  @Test
  void settledRecordsThatDoNotFitIntoTheMetadataAreUnknown() {
    long records = 4000;
    hold(0, records);
    claims.claim();
    for (long offset = 1; offset < records; offset += 2) {
      claims.settle(record(offset));
    }
    claims.release();
    OffsetAndMetadata left = committed(records);
    assertThat(left.metadata()).hasSizeLessThan(4096);
    assertThat(fates(claims(left), 0, records + 1))
        .startsWith("0 unknown", "1 unknown")
        .endsWith((records - 1) + " unknown", records + " writes");
    claims.claim();
    assertThat(claims.areCommitted(offsets(claims, records))).isTrue();
  }

  @Test
  void onlyTheCommitOfTheNewestClaimProvesIt() {
    hold(0, 2);
    claims.claim();
    var before = offsets(claims, 2);
    assertThat(claims.areCommitted(before)).isTrue();
    claims.settle(record(0));
    claims.release();
    var released = offsets(claims, 2);
    claims.claim();
    assertThat(claims.areCommitted(before)).isFalse();
    assertThat(claims.areCommitted(released)).isFalse();
    assertThat(claims.areCommitted(offsets(claims, 2))).isTrue();
    assertThat(claims.areCommitted(Map.of())).isFalse();
    Claims another = claims(NO_CLAIM);
    another.hold(record(0));
    another.hold(record(1));
    another.claim();
    assertThat(claims.areCommitted(offsets(another, 2))).isFalse();
  }

  @Test
  void eachPartitionComesFirstInItsTurn() {
    var unused = claims.open(List.of(TWO), Map.of());
    hold(0, 2);
    claims.hold(record(TWO, 0));
    claims.claim();
    assertThat(claims.claimed()).containsExactly(record(0), record(1), record(TWO, 0));
    claims.release();
    assertThat(claims.claimed()).isEmpty();
    claims.claim();
    assertThat(claims.claimed()).containsExactly(record(TWO, 0), record(0), record(1));
  }

  @Test
  void aPartitionIsFullFrom500HeldRecords() {
    hold(0, 499);
    assertThat(claims.full()).isEmpty();
    hold(499, 500);
    assertThat(claims.full()).containsExactly(ONE);
    claims.settle(record(0));
    assertThat(claims.full()).isEmpty();
  }
}
