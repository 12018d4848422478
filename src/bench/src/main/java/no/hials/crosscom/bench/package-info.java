/**
 * Measures the cost of the client, the parser and the mock server. Never deployed.
 *
 * <p>JMH runs {@link no.hials.crosscom.bench.ExchangeBenchmark} and {@link
 * no.hials.crosscom.bench.TextBenchmark}; {@link no.hials.crosscom.bench.RatioBenchmark} compares
 * the client with a bare socket loop, {@link no.hials.crosscom.bench.MockLoad} loads the mock
 * server. {@code run.sh} runs them all.
 */
@NullMarked
package no.hials.crosscom.bench;

import org.jspecify.annotations.NullMarked;
