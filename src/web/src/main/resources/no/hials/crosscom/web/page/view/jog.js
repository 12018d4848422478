// Moves the robot by hand, designed for a phone: the robot moves while a button is held.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { Dialog } from '../dialog.js';
import { JogButton } from '../jog/button.js';
import { held, releaseAll } from '../jog/hold.js';
import { isMine, jog, Owner } from '../jog/owner.js';
import { useReadings } from '../readings.js';
import { call, tell } from '../socket.js';
import { header, jogging, mayWrite, note, state, useRobot, useSharedState } from '../state.js';
import { numberText } from '../value.js';

const SPACES = {
  joints: { title: 'Axes', program: 'ext_move_axis', variable: '$AXIS_ACT', names: ['A1', 'A2', 'A3', 'A4', 'A5', 'A6'] },
  base: { title: 'Base', program: 'actuator', variable: '$POS_ACT', names: ['X', 'Y', 'Z', 'A', 'B', 'C'] },
  tool: { title: 'Tool', program: 'actuator', variable: '$POS_ACT', names: ['X', 'Y', 'Z', 'A', 'B', 'C'] },
};
const STEPS = [0, 0.1, 1, 10]; // mm or degrees; 0 moves until the release
const POSITION_PERIOD = 100; // ms
const PRESENCE_PERIOD = 1000; // ms

/** Shows the server that this page is there while it has the robot; gives the robot up at the end. */
function usePresence() {
  const robot = state.robot;
  useEffect(() => {
    const leave = () => {
      releaseAll();
      tell('jog-close', { robot });
    };
    const hide = () => document.hidden && leave();
    const timer = setInterval(() => isMine() && tell('jog-here', { robot }), PRESENCE_PERIOD);
    document.addEventListener('visibilitychange', hide);
    addEventListener('pagehide', leave);
    return () => {
      clearInterval(timer);
      document.removeEventListener('visibilitychange', hide);
      removeEventListener('pagehide', leave);
      leave();
    };
  }, []);
}

/** Why nobody can start here; empty if this page can. */
function obstacle() {
  const lock = header().lock;
  if (state.socket !== 'open') {
    return 'there is no connection to the server';
  }
  if (state.replay) {
    return 'a recording is open: close it, at the top'; // its pose is not that of the robot
  }
  if (lock?.read_only_by) {
    return `the robot is read-only: ${lock.read_only_by}`;
  }
  if (state.who.role !== 'JOG') {
    return `this browser may only ${state.who.role.toLowerCase()}`;
  }
  const { owner } = jogging();
  if (owner && !isMine()) {
    return `${owner.name} jogs this robot`;
  }
  return mayWrite() ? '' : 'unlock the robot, at the top';
}

/** Returns the state in words, and its kind. */
function status(ready) {
  if (held().some((one) => one.late)) {
    return ['refused', 'The robot does not answer: its watchdog has to stop it'];
  }
  const moving = held().filter((one) => one.moving);
  if (moving.length > 0) {
    return ['moving', 'Moving'];
  }
  if (ready) {
    return ['ready', held().length > 0 ? 'Standing' : 'Ready'];
  }
  if (jogging().opening) {
    return ['waiting', 'Checking the robot …'];
  }
  const why = obstacle();
  if (why) {
    return ['refused', `Not allowed: ${why}`];
  }
  const { reason } = jogging(); // why jogging did not start, or ended
  return reason ? ['refused', `Not jogging: ${reason}`] : ['waiting', 'Not started'];
}

function Choice({ label, values, value, show, onChoose }) {
  return h(
    'div',
    { class: 'choice', role: 'group', 'aria-label': label },
    values.map((one) =>
      h(
        'button',
        { key: one, 'aria-pressed': String(one === value), onClick: () => onChoose(one) },
        show(one),
      ),
    ),
  );
}

function Speed({ space, percent, onChange }) {
  const { full_mm = 0, full_turn = 0, full_axis = 0 } = jogging();
  const shown = (full) => Number(((full * percent) / 100).toPrecision(2));
  const words =
    space === 'joints' ? `${shown(full_axis)} °/s` : `${shown(full_mm)} mm/s, ${shown(full_turn)} °/s`;
  return h(
    'label',
    { class: 'speed' },
    h('span', null, `Speed ${percent} %: ${words}`),
    h('input', {
      type: 'range',
      min: 1,
      max: 100,
      value: percent,
      onInput: (event) => onChange(Number(event.target.value)),
    }),
  );
}

function Pads({ space, position, percent, step, ready }) {
  const { names } = SPACES[space];
  return h(
    'div',
    { class: 'pads' },
    names.map((name, direction) => {
      const button = (positive) =>
        h(JogButton, { name, direction, positive, percent, step, disabled: !ready });
      const unit = space === 'joints' || direction > 2 ? '°' : 'mm';
      return h(
        'div',
        { key: name, class: 'pad', role: 'group', 'aria-label': name },
        button(false),
        h(
          'div',
          { class: 'place' },
          h('strong', null, name),
          h('span', { class: 'reading' }, numberText(position?.[name], 2, unit)),
        ),
        button(true),
      );
    }),
  );
}

/** Asks before jogging where nobody has to hold an enabling switch. */
function Confirm({ onYes, onNo }) {
  return h(
    Dialog,
    { title: `The mode is ${header().mode ?? 'unknown'}, not #T1`, onClose: onNo },
    h('p', null, 'Nobody has to hold an enabling switch. Is the cell closed, and a person at the emergency stop?'),
    h(
      'div',
      { class: 'buttons' },
      h('button', { onClick: onNo }, 'Cancel'),
      h('button', { class: 'main', onClick: onYes }, 'Jog the robot'),
    ),
  );
}

export function View() {
  useSharedState();
  usePresence();
  const [space, setSpace] = useState(sessionStorage.getItem('jog-space') ?? 'base');
  const [percent, setPercent] = useState(25);
  const [step, setStep] = useState(0);
  const [asks, setAsks] = useState(false);
  const robot = useRobot();
  const gone = useRef(false);
  useEffect(() => () => (gone.current = true), []);
  const one = header();
  const open = isMine() ? jogging().open : '';
  const ready = open === space && state.socket === 'open' && one.lock?.open === true;
  const [kind, words] = status(ready);
  const { variable } = SPACES[space];
  const [values, stale] = useReadings('jog', [variable], POSITION_PERIOD);

  const start = (wanted) => jog('open', { robot, space: wanted, confirmed: true });
  const begin = () => (one.mode === '#T1' || one.simulated ? start(space) : setAsks(true));
  const choose = (wanted) => {
    releaseAll();
    setSpace(wanted);
    sessionStorage.setItem('jog-space', wanted);
    if (open && open !== wanted) {
      start(wanted);
    }
  };
  const prepare = async () => {
    try {
      const { program } = SPACES[space];
      await call('teach-program', { robot, program, confirmed: true });
      if (!gone.current) {
        await start(space);
      }
    } catch (e) {
      note('error', e.message);
    }
  };
  return h(
    'div',
    { class: `jog ${stale ? 'stale' : ''}` },
    h('h1', { class: 'unseen' }, 'Jog'),
    h('p', { class: 'warning' }, 'Not an enabling device, not an emergency stop.'),
    h(Owner),
    h(
      'section',
      { class: `panel state ${kind}`, 'aria-label': 'State of jogging' },
      h('p', { class: 'status', role: 'status' }, words),
      h(
        'div',
        { class: 'buttons' },
        ready
          ? h('button', { onClick: () => jog('close') }, 'End jogging')
          : h(
              'button',
              { class: 'main', disabled: Boolean(obstacle()) || jogging().opening, onClick: begin },
              'Start jogging',
            ),
        one.simulated &&
          !ready &&
          h('button', { disabled: Boolean(obstacle()) || jogging().opening, onClick: prepare }, 'Prepare the simulated robot'),
      ),
    ),
    h(Choice, {
      label: 'Coordinates',
      values: Object.keys(SPACES),
      value: space,
      show: (name) => SPACES[name].title,
      onChoose: choose,
    }),
    h(Choice, {
      label: 'Step',
      values: STEPS,
      value: step,
      show: (size) => (size === 0 ? 'Continuous' : `${size} ${space === 'joints' ? '°' : 'mm, °'}`),
      onChoose: setStep,
    }),
    h(Speed, { space, percent, onChange: setPercent }),
    h(Pads, { key: space, space, position: values[variable]?.value, percent, step, ready }),
    h(
      'p',
      { class: 'hint' },
      `Needs ${SPACES[space].program.toUpperCase()} and the watchdog of the folder krl; a real robot in T1.`,
    ),
    asks &&
      h(Confirm, {
        onYes: () => {
          setAsks(false);
          start(space);
        },
        onNo: () => setAsks(false),
      }),
  );
}
