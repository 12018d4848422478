// The state that all views share, and the hook that renders them when it changes.

import { useEffect, useRef, useState } from 'preact/hooks';

export const state = {
  /** The socket: 'connecting', 'open', 'lost' or 'ended' (the session is no longer valid). */
  socket: 'connecting',
  /** This browser: its name and its role. */
  who: { name: '', role: 'VIEW', robots: [] },
  /** The name of the robot that the views show. */
  robot: localStorage.getItem('robot') ?? '',
  /** The last header event of each robot, by its name. */
  headers: new Map(),
  /** The last jog event of each robot, by its name: who jogs it. */
  jogs: new Map(),
  /** The player of the recording that is open in all views; null shows the robot. */
  replay: null,
  /** Short messages at the edge of the page. */
  notes: [],
};

const AGE_PERIOD = 100; // ms
const LATE = 750; // ms

const listeners = new Set();
let scheduled = false;

/** Renders the components that use the state, once for many changes. */
export function changed() {
  if (!scheduled) {
    scheduled = true;
    // a hidden page gets no animation frames, and needs none
    requestAnimationFrame(() => {
      scheduled = false;
      listeners.forEach((listener) => listener());
    });
  }
}

/** Renders the component again after each change of the state. */
export function useSharedState() {
  const [, setCount] = useState(0);
  useEffect(() => {
    const listener = () => setCount((count) => count + 1);
    listeners.add(listener);
    return () => listeners.delete(listener);
  }, []);
  return state;
}

const CLOCK_DRIFT = 0.0002; // two clocks run apart by less than 17 s a day
const clock = { offset: Infinity, noted: 0 };

/** Forgets the clock of the server, which may have been set before a new connection. */
export function forgetServerTime() {
  clock.offset = Infinity;
}

/**
 * Stores the time at which the server sent a message. The fastest message is the most exact: a
 * message that the network delayed must not make old values look new.
 */
export function noteServerTime(sent) {
  const here = performance.now();
  const offset = sent - here;
  const before = clock.offset - (here - clock.noted) * CLOCK_DRIFT;
  clock.offset = Number.isFinite(before) && offset < before ? before : offset;
  clock.noted = here;
}

/** Returns the time of the server, in ms since 1970; infinite before its first message. */
export function serverTime() {
  return performance.now() + clock.offset;
}

/**
 * Returns the robot of a view, which stays the same until the view ends: its late messages
 * must not reach another robot.
 */
export function useRobot() {
  return useState(state.robot)[0];
}

/** Returns the header of the chosen robot; an empty object before the first one. */
export function header() {
  return state.headers.get(state.robot) ?? {};
}

/** Returns who jogs the chosen robot, and how; an empty object before the first event. */
export function jogging() {
  return state.jogs.get(state.robot) ?? {};
}

/** Returns how old the values of a header are in ms; infinite if there are none. */
export function ageOf(one) {
  return one.time === undefined ? Infinity : Math.max(0, serverTime() - one.time);
}

/** Returns the age in ms from which a value with this period is old: the next one is late. */
export function oldAfter(period) {
  return period + LATE;
}

/** Returns whether the values of a header may be outdated. */
export function isStale(one) {
  return (
    state.socket !== 'open' || one.connection !== 'connected' || ageOf(one) > oldAfter(one.period_ms)
  );
}

/** Returns why the values of a header may be outdated, as a sentence; empty if they are current. */
export function staleReason(one) {
  if (!isStale(one)) {
    return '';
  }
  if (state.socket !== 'open') {
    return 'There is no connection to the server of this page.';
  }
  if (one.reason) {
    return `The robot does not answer: ${one.reason}.`;
  }
  return one.time === undefined ? 'The robot has not answered yet.' : 'The robot answers late, or not at all.';
}

const ages = new Set();

/** Renders the component as soon as a function of the time, such as an age, changes. */
export function useAges(tell) {
  useSharedState();
  const latest = useRef(tell);
  latest.current = tell;
  useEffect(() => {
    const own = () => latest.current();
    ages.add(own);
    return () => ages.delete(own);
  }, []);
}

/**
 * Returns whether the values of a view may be outdated: the header is stale, or the values are too
 * old.
 *
 * @param timeOf returns the time of the values by the clock of the server; undefined without values
 * @param longest the maximum age in ms
 */
export function useStale(timeOf, longest) {
  const isOld = () => serverTime() - timeOf() > longest;
  useAges(isOld);
  return isStale(header()) || isOld();
}

/** Renders the component when a value becomes stale, which happens without any event. */
export function watchAges() {
  let before = '';
  setInterval(() => {
    const headers = [...state.headers.values()].map(isStale);
    const stale = [...headers, ...[...ages].map((tell) => tell())].join();
    if (stale !== before) {
      before = stale;
      changed();
    }
  }, AGE_PERIOD);
}

/** Returns whether this browser may change the chosen robot now. */
export function mayWrite() {
  return mayOperate() && header().lock?.open === true && state.socket === 'open';
}

/** Returns whether this browser may stop the chosen robot now, which needs no unlocking. */
export function mayStop() {
  return mayOperate() && !header().lock?.read_only_by && state.socket === 'open';
}

/** Returns whether the role of this browser allows changes at all. */
export function mayOperate() {
  return state.who.role !== 'VIEW';
}

/** Returns why this browser cannot change the chosen robot, or what allows it; empty if it can. */
export function writeHint(purpose) {
  if (mayWrite()) {
    return '';
  }
  const readOnlyBy = header().lock?.read_only_by;
  if (readOnlyBy) {
    return `The robot is read-only: ${readOnlyBy}.`;
  }
  return mayOperate() ? `Unlock the robot, at the top, ${purpose}.` : 'This browser may only view.';
}

export function chooseRobot(name) {
  state.robot = name;
  localStorage.setItem('robot', name);
  changed();
}

/** Shows a short message, as text: 'error' or 'done'. */
export function note(kind, text) {
  const one = { kind, text };
  state.notes = [...state.notes.slice(-3), one];
  changed();
  setTimeout(() => {
    state.notes = state.notes.filter((it) => it !== one);
    changed();
  }, 8000);
}
