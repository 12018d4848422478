// The readings of a view, and whether they may be outdated.

import { useEffect, useState } from 'preact/hooks';
import { watch } from './socket.js';
import { oldAfter, useRobot, useStale } from './state.js';

/** Returns the values of an event of `watch`, each with its time. */
export function timed(event) {
  const entries = Object.entries(event.values);
  return Object.fromEntries(entries.map(([name, one]) => [name, { ...one, time: event.time }]));
}

/** Returns the time of the oldest of some values; undefined if there are none. */
export function oldestTime(values) {
  const times = Object.values(values).map((one) => one.time);
  return times.length > 0 ? Math.min(...times) : undefined;
}

/**
 * Watches variables of the robot of the view.
 *
 * @returns the last values by their names, each with its time, and whether they may be outdated
 */
export function useReadings(list, names, period) {
  const robot = useRobot();
  const [values, setValues] = useState({});
  useEffect(() => {
    setValues({});
    return watch(robot, list, names, period, (event) => {
      if (!event.missed) {
        setValues((old) => ({ ...old, ...timed(event) })); // without readings the old ones stay
      }
    });
  }, [names.join(), period]);
  return [values, useStale(() => oldestTime(values), oldAfter(period))];
}
