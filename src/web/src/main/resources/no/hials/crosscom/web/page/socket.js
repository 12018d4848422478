// The connection to the server: commands with their answers, events, and watched variables. It
// reconnects automatically, and then watches the same variables as before.

import { changed, forgetServerTime, noteServerTime, state } from './state.js';

const LONGEST_WAIT = 10_000;
const PING_PERIOD = 1000;

// bytes: the server closes the connection at a longer message
const LONGEST_MESSAGE = 256 * 1024;

// ms of silence until the page gives up the server: longer than the server accepts old commands
const LONGEST_SILENCE = 4000;

const token = document.querySelector('meta[name=socket-token]').content;
const pending = new Map();
const watches = new Map();
const eventListeners = new Map();
let socket = null;
let number = 0;
let attempts = 0;

// the server's time in its latest answer
let clock;

// when the first ping since that answer was sent, by performance.now()
let askedAt = null;

/** Opens the socket. */
export function connect() {
  const origin = location.origin.replace(/^http/, 'ws');
  socket = new WebSocket(`${origin}/socket?page=${encodeURIComponent(token)}`);
  const own = socket;
  socket.onopen = () => {
    attempts = 0;
    clock = undefined;
    askedAt = null;
    state.socket = 'open';
    forgetServerTime();
    changed();
    begin().catch(() => own.close());
  };
  socket.onmessage = (message) => receive(JSON.parse(message.data));
  socket.onclose = () => {
    if (own === socket) {
      lost();
    }
  };
}

async function begin() {
  state.who = await call('who');
  if (!state.who.robots.includes(state.robot)) {
    state.robot = state.who.robots[0];
  }
  changed();
  await tellVisible();
  for (const one of watches.values()) {
    sendWatch(one);
  }
}

function lost() {
  state.socket = 'lost';
  changed();
  for (const { reject } of pending.values()) {
    reject('the connection to the server is lost');
  }
  pending.clear();
  attempts++;
  setTimeout(reconnect, Math.min(250 * attempts, 2000));
}

/** Reconnects, unless the server answers that this browser has no session any more. */
async function reconnect() {
  try {
    const answer = await fetch('/style/base.css', { cache: 'no-store' });
    if (answer.status === 403) {
      state.socket = 'ended';
      changed();
      return;
    }
  } catch {
    lost();
    return;
  }
  connect();
}

/**
 * Sends a command and returns its answer.
 *
 * @throws Error with a sentence for the user if it is refused
 */
export function call(name, fields = {}) {
  return new Promise((resolve, reject) => {
    if (socket?.readyState !== WebSocket.OPEN) {
      reject(new Error('there is no connection to the server'));
      return;
    }
    const id = ++number;
    const message = JSON.stringify({ id, do: name, clock, ...fields });
    const size = bytes(message);
    if (size > LONGEST_MESSAGE) {
      reject(new Error(`too large: ${size} bytes; the server takes ${LONGEST_MESSAGE}`));
      return;
    }
    const timer = setTimeout(() => {
      pending.delete(id);
      if (fields.confirmed) {
        withdraw();
      }
      unanswered(`no answer to ${name} within ${LONGEST_WAIT / 1000} s`);
    }, LONGEST_WAIT);
    const unknown = fields.confirmed ? '; whether it was done is unknown: look at the robot' : '';
    const unanswered = (reason) => reject(new Error(reason + unknown));
    const done = (settle) => (value) => {
      clearTimeout(timer);
      settle(value);
    };
    pending.set(id, {
      resolve: done(resolve),
      refuse: done((error) => reject(new Error(error))),
      reject: done(unanswered),
    });
    socket.send(message);
  });
}

/** Returns the size of a text in UTF-8. */
function bytes(text) {
  return new TextEncoder().encode(text).length;
}

/** Cancels the changes of this page that still wait for the robot; their answers say so. */
export function withdraw() {
  tell('withdraw');
}

/** Sends a command, such as a beat, without waiting for its answer; returns whether it was sent. */
export function tell(name, fields = {}) {
  const message = JSON.stringify({ id: 0, do: name, ...fields });
  if (socket?.readyState !== WebSocket.OPEN || bytes(message) > LONGEST_MESSAGE) {
    return false;
  }
  socket.send(message);
  return true;
}

function receive(message) {
  if (message.event === undefined) {
    clock = message.clock;
    askedAt = null;
    const waiting = pending.get(message.id);
    pending.delete(message.id);
    if (message.error === undefined) {
      waiting?.resolve(message.ok);
    } else {
      waiting?.refuse(message.error);
    }
    return;
  }
  if (message.event === 'header') {
    state.headers.set(message.robot, message);
    noteServerTime(message.now);
    changed();
  } else if (message.event === 'jog') {
    state.jogs.set(message.robot, message);
    changed();
  } else if (message.event === 'samples') {
    watches.get(`${message.robot}/${message.list}`)?.listener(message);
  }
  eventListeners.get(message.event)?.forEach((listener) => listener(message));
}

/** Calls a function with each event of a kind; returns a function that stops the calls. */
export function onEvent(kind, listener) {
  const all = eventListeners.get(kind) ?? new Set();
  eventListeners.set(kind, all.add(listener));
  return () => all.delete(listener);
}

/**
 * Watches variables of a robot.
 *
 * @param list a name for the list, unique to the view; watching again replaces the list
 * @param period in ms
 * @param listener called with each event: time and access_ms in ms, missed, and values by the
 *     names in capitals: {type, value} or {error}
 * @returns a function that ends the watching
 */
export function watch(robot, list, names, period, listener) {
  const one = { robot, list, names, period, listener };
  watches.set(`${robot}/${list}`, one);
  sendWatch(one);
  return () => {
    if (watches.get(`${robot}/${list}`) === one) {
      watches.delete(`${robot}/${list}`);
      tell('unwatch', { robot, list });
    }
  };
}

function sendWatch({ robot, list, names, period }) {
  tell('watch', { robot, list, names, period });
}

function tellVisible() {
  return call('visible', { visible: !document.hidden });
}

document.addEventListener('visibilitychange', () => tellVisible().catch(() => {}));

// detects a lost network, which a socket alone notices only after minutes
setInterval(() => {
  if (state.socket !== 'open') {
    return;
  }
  if (askedAt !== null && performance.now() - askedAt > LONGEST_SILENCE) {
    socket.onclose = null;
    socket.close();
    lost();
    return;
  }
  askedAt ??= performance.now();
  call('ping').catch(() => {});
}, PING_PERIOD);
