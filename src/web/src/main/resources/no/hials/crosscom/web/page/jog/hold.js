// Hold to run: a press, then a beat 20 times a second until the release. The server decides; it stops
// the robot 150 ms after the last beat, whatever happens to this page.

import { call, tell } from '../socket.js';
import { changed, note, state } from '../state.js';

const BEAT_PERIOD = 50; // ms

/** The time without an answer after which the server has ended the hold. */
const MAX_SILENCE = 300; // ms

/** The buttons that are held, by their directions, 0 to 5. */
const holds = new Map();
let number = 0;

/** Returns the holds of this page. */
export function held() {
  return [...holds.values()];
}

/**
 * Holds a button.
 *
 * @param source the device that holds the button: 'touch', 'pen', 'mouse' or 'key'
 * @param fields direction, positive, percent and step
 */
export function press(source, fields) {
  if (holds.has(fields.direction)) {
    release(fields.direction); // both buttons of a direction
    return;
  }
  const one = { id: ++number, robot: state.robot, source, fields, beat: 0, mark: 0, moving: false, late: false };
  holds.set(fields.direction, one);
  changed();
  call('jog-press', { robot: one.robot, hold: one.id, ...fields }).then((answer) => {
    if (!isHeld(one)) {
      return;
    }
    one.mark = answer.mark;
    one.answered = performance.now();
    one.timer = setInterval(() => beat(one), BEAT_PERIOD);
    beat(one);
  }, refused(one));
}

function isHeld(one) {
  return holds.get(one.fields.direction) === one;
}

/** Sends a beat with the newest time of the server, which tells the server its age. */
function beat(one) {
  if (performance.now() - one.answered > MAX_SILENCE) {
    note('error', `the server has not answered for ${MAX_SILENCE} ms: release, and press again`);
    release(one.fields.direction);
    return;
  }
  const { id, robot, mark } = one;
  call('jog-beat', { robot, hold: id, beat: ++one.beat, mark }).then((answer) => {
    one.mark = Math.max(one.mark, answer.mark);
    one.answered = performance.now();
    if (one.moving !== answer.moving || one.late !== answer.late) {
      one.moving = answer.moving;
      one.late = answer.late;
      changed();
    }
  }, refused(one));
}

const refused = (one) => (error) => {
  if (isHeld(one)) {
    forget(one);
    if (!error.message.endsWith('the step is done')) {
      note('error', error.message);
    }
  }
};

function forget(one) {
  clearInterval(one.timer);
  holds.delete(one.fields.direction);
  changed();
}

/** Releases the button of a direction, if it is held. */
export function release(direction) {
  const one = holds.get(direction);
  if (one) {
    tell('jog-release', { robot: one.robot, hold: one.id });
    forget(one);
  }
}

/** Releases all buttons, or those of one kind of source. */
export function releaseAll(isOf = () => true) {
  for (const one of held()) {
    if (isOf(one)) {
      release(one.fields.direction);
    }
  }
}

addEventListener('blur', () => releaseAll());
addEventListener('pagehide', () => releaseAll());
document.addEventListener('visibilitychange', () => document.hidden && releaseAll());
// a long touch requests a menu, too, which the buttons do not show
addEventListener('contextmenu', () => releaseAll((one) => one.source !== 'touch'));
