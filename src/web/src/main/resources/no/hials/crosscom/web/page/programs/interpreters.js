// The two interpreters: their programs, their states and their buttons.

import { h } from 'preact';
import { useState } from 'preact/hooks';
import { call } from '../socket.js';
import { header, mayStop, mayWrite, note, useRobot, writeHint } from '../state.js';
import { percentText } from '../value.js';

const STATES = {
  __proto__: null, // a robot may answer with any word
  '#P_FREE': 'no program selected',
  '#P_RESET': 'at its start',
  '#P_ACTIVE': 'running',
  '#P_STOP': 'stopped',
  '#P_END': 'at its end',
};

/** Returns the hint for Start: the first motion is a BCO run, at whose end Start is pressed again. */
function startHint(robotState, values) {
  const one = header();
  if (values['$MOVE_BCO']?.value === true) {
    return 'BCO run: the robot moves slowly to the first point of the program and stops there. Press Start again at its end.';
  }
  if (['#P_RESET', '#P_STOP', '#P_END'].includes(robotState) && one.mode === '#EX') {
    return 'In EXT the PLC starts the program.';
  }
  if (robotState === '#P_STOP' && one.stop === 'TRUE') {
    return 'Stopped by a message: confirm it, then press Start.';
  }
  if (robotState === '#P_STOP' && values['$ON_PATH']?.value === true) {
    return 'Stopped on its path, as at the end of the BCO run. Press Start again to go on.';
  }
  if (['#P_RESET', '#P_STOP', '#P_END'].includes(robotState)) {
    return 'The next Start is the BCO run: slow, to the first point, where the robot stops. Then press Start again.';
  }
  return '';
}

/** The dialogs before each order. */
function question(robotName, order, interpreter, program) {
  const name = program || 'the program';
  const robot = interpreter === 'robot';
  const send = (text) => async () => {
    await call('program-order', { robot: robotName, order, interpreter, confirmed: true });
    return text;
  };
  const facts = [['Interpreter', interpreter], ['Program', program || 'unknown']];
  switch (order) {
    case 'start':
      return {
        title: `Start ${name}?`,
        action: 'Start',
        facts: robot ? [...facts, ['Override', percentText(header().override)]] : facts,
        warning: robot
          ? 'The robot will move. Nobody may be in its reach, except in T1 with the enabling switch.'
          : 'A submit program can switch outputs, which move grippers and other machines.',
        work: send(`${name}: the controller has accepted Start`),
      };
    case 'reset':
      return {
        title: `Reset ${name}?`,
        action: 'Reset',
        facts,
        warning: 'The program begins again at its first line.',
        work: send(`${name}: the controller has accepted the reset`),
      };
    default:
      return {
        title: `Deselect ${name}?`,
        action: 'Deselect',
        facts,
        warning: 'The program loses its place.',
        work: send(`${name} is no longer selected`),
      };
  }
}

async function stop(robot, interpreter) {
  try {
    await call('program-stop', { robot, interpreter, confirmed: true });
    note('done', `The controller has accepted the stop of the ${interpreter} interpreter.`);
  } catch (e) {
    note('error', e.message);
  }
}

/** Stops the program, also while the robot is locked; one stop at a time. */
function Stop({ robot, interpreter, bridge }) {
  const [busy, setBusy] = useState(false);
  const press = async () => {
    setBusy(true);
    await stop(robot, interpreter);
    setBusy(false);
  };
  const disabled = busy || !mayStop() || bridge === false;
  return h('button', { class: 'stop', disabled, onClick: press }, busy ? 'Stopping …' : 'Stop');
}

function Interpreter({ interpreter, title, program, programState, hint, bridge, onAsk }) {
  const robot = useRobot();
  const may = mayWrite() && bridge;
  const selected = programState != null && programState !== '#P_FREE';
  const active = programState === '#P_ACTIVE';
  const order = (name, text, enabled, kind = '') =>
    h(
      'button',
      {
        class: kind,
        disabled: !may || !enabled,
        onClick: () => onAsk(question(robot, name, interpreter, program)),
      },
      text,
    );
  return h(
    'section',
    { class: `interpreter ${interpreter}`, 'aria-label': title },
    h('h2', null, title),
    h(
      'p',
      { class: 'program-state' },
      h('span', { class: 'variable reading' }, program || '–'),
      h(
        'span',
        { class: `state reading ${(programState ?? '').replace('#', '')}` },
        STATES[programState] ?? programState ?? 'unknown',
      ),
    ),
    hint && h('p', { class: 'bco' }, hint),
    h(
      'div',
      { class: 'buttons' },
      order('start', 'Start …', selected && !active, 'main'),
      h(Stop, { robot, interpreter, bridge }),
      order('reset', 'Reset …', selected),
      order('cancel', 'Deselect …', selected && !active),
    ),
  );
}

/** Shows both interpreters. */
export function Interpreters({ known, values, stale, onAsk }) {
  const one = header();
  return h(
    'section',
    { class: `panel interpreters ${stale ? 'stale' : ''}`, 'aria-label': 'Interpreters' },
    h(Interpreter, {
      interpreter: 'robot',
      title: 'Robot interpreter',
      program: one.robot_program,
      programState: one.robot_state,
      hint: stale ? '' : startHint(one.robot_state, values), // an old hint may be wrong
      bridge: known?.bridge,
      onAsk,
    }),
    h(Interpreter, {
      interpreter: 'submit',
      title: 'Submit interpreter',
      program: one.submit_program,
      programState: one.submit_state,
      bridge: known?.bridge,
      onAsk,
    }),
    known?.bridge === false &&
      h(
        'p',
        { class: 'hint' },
        'KUKAVARPROXY has no commands for programs: select, start and stop them on the pendant. C3 Bridge has them.',
      ),
    known?.bridge &&
      h(
        'p',
        { class: 'hint' },
        'Stop works only while the network works. It is not an emergency stop.',
        ` ${writeHint('to use the other buttons')}`,
      ),
  );
}
