#!/usr/bin/env bash
# Reruns the figures of docs/reference/performance.md: without an argument those of the client and
# the mock server, in about ten minutes. Nothing else should run on the machine meanwhile.
#
#   src/bench/run.sh          all of it
#   src/bench/run.sh ratio    the client against a bare socket, both on one CPU
#   src/bench/run.sh strace   the system calls of 20,000 exchanges, if strace is installed
#   src/bench/run.sh load     the mock server under load
#   src/bench/run.sh jmh ...  JMH, with its options
#   src/bench/run.sh robots [ROBOTS [SILENT [SECONDS]]]  many robots watched by one process
#   src/bench/run.sh viewers [VIEWERS [SECONDS [ROWS]]]    what the web page's server costs
#   src/bench/run.sh gateway [ROBOTS [SECONDS]]    robots into an MQTT broker, by one process
#   src/bench/run.sh kafka [ROBOTS [SECONDS]]      robots onto a Kafka broker, by one worker
#   src/bench/run.sh jogcuts [CUTS]    cut connections of a page that jogs, 100 times
#
# Two more look for defects instead of measuring; they exit with 1 if they find one:
#
#   src/bench/run.sh soak [CALLS [THREADS [FAULTS%]]]  faulty servers, 1,000,000 calls each
#   src/bench/run.sh mutation [EXCHANGES]              changed bytes, 20,000 exchanges each
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# Broker and workers are parts of the tests of src/kafka.
if [[ ${1:-} == kafka ]]; then
  mvn -B -q -Pplant verify -pl src/kafka -am -Dtests.required=false -Dspotless.check.skip -Dcheckstyle.skip \
    -Dtest=none -Dsurefire.failIfNoSpecifiedTests=false \
    -Dit.test=ClusterLoad -Dfailsafe.failIfNoSpecifiedTests=false \
    -Dkafka.tiers=4 -Dload.robots="${2:-100}" -Dload.seconds="${3:-30}"
  exit
fi

mvn -B -q -pl src/bench,src/gateway -am -Dmaven.test.skip=true package

one_cpu=()
if command -v taskset >/dev/null; then
  one_cpu=(taskset -c 0)
fi
java=${JAVA_HOME:+$JAVA_HOME/bin/}java
run=("$java" -cp 'src/bench/target/classes:src/bench/target/lib/*')
ours=no.hials.crosscom.bench

ratio() {
  "${one_cpu[@]}" "${run[@]}" $ours.RatioBenchmark "$@"
}

system_calls() {
  if ! command -v strace >/dev/null; then
    echo "strace is not installed: the system calls are not counted"
    return
  fi
  local who
  for who in client socket; do
    echo "== 20,000 exchanges by the $who; the server in the same process reads and writes as often"
    "${one_cpu[@]}" strace -c -f -o src/bench/target/strace.txt \
      "${run[@]}" $ours.ExchangeLoop $who READ_INT 20000
    grep -E ' (read|write|calls|recv[a-z]*|send[a-z]*|poll)( |$)' src/bench/target/strace.txt
  done
}

jmh() {
  "${one_cpu[@]}" "${run[@]}" org.openjdk.jmh.Main -prof gc "$@"
}

case ${1:-all} in
  ratio) ratio "${@:2}" ;;
  strace) system_calls ;;
  load) "${run[@]}" $ours.MockLoad ;;
  jmh) jmh "${@:2}" ;;
  robots) "${run[@]:0:1}" -Xmx96m -XX:+UseSerialGC "${run[@]:1}" $ours.ManyRobots "${@:2}" ;;
  viewers) "${run[@]:0:1}" -Xmx96m -XX:+UseSerialGC "${run[@]:1}" $ours.PageViewers "${@:2}" ;;
  gateway) "${run[@]}" $ours.GatewayLoad src/gateway/target/gateway/jopenshowvar-gateway.jar "${@:2}" ;;
  jogcuts) "${run[@]}" $ours.JogCuts "${@:2}" ;;
  soak) "${run[@]}" $ours.Soak "${@:2}" ;;
  mutation) "${run[@]}" $ours.MutationRun "${@:2}" ;;
  all)
    date
    "$java" -version
    uname -srm
    nproc
    uptime
    ratio
    system_calls
    "${run[@]}" $ours.MockLoad
    jmh
    uptime
    ;;
  *)
    echo "usage: $0 [all|ratio|strace|load|jmh|robots|viewers|gateway|kafka|jogcuts|soak|mutation]" >&2
    exit 64
    ;;
esac
