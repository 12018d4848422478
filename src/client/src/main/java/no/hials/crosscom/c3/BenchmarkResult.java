package no.hials.crosscom.c3;

import java.time.Duration;

/**
 * How long accesses to variables took on the server itself, without the network
 * (docs/reference/c3-messages.md#benchmark-17).
 *
 * @param variables how many variables were accessed in each iteration
 * @param iterations how often
 * @param duration how long all of it took, to the ms
 */
public record BenchmarkResult(int variables, long iterations, Duration duration) {}
