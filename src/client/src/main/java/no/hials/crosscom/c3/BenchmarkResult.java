package no.hials.crosscom.c3;

import java.time.Duration;

/**
 * The time that accesses to variables took on the server itself, without the network
 * (docs/reference/c3-messages.md#benchmark-17).
 *
 * @param variables number of variables accessed in each iteration
 * @param iterations number of iterations
 * @param duration the time of all iterations, to the ms
 */
public record BenchmarkResult(int variables, long iterations, Duration duration) {}
