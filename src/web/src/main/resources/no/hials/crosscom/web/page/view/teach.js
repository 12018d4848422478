// The controls with which a teacher changes a simulated robot: mode key, emergency stop, faults of the network, and
// the variables that the robot follows; the robot and a lesson of the tutorial next to them.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { useReadings } from '../readings.js';
import { call, onEvent } from '../socket.js';
import { header, isStale, mayStop, mayWrite, note, serverTime, useRobot, useSharedState, writeHint } from '../state.js';
import { numberText } from '../value.js';
import { Waiting } from '../waiting.js';
import { View as Robot } from './robot.js';

const MODES = { T1: '#T1', T2: '#T2', AUT: '#AUT', EXT: '#EX' };
const PROGRAMS = {
  actuator: {
    title: 'Cartesian increments',
    variable: 'MYPOS',
    fields: ['X', 'Y', 'Z', 'A', 'B', 'C'],
    units: ['mm', 'mm', 'mm', '°', '°', '°'],
    most: [5, 5, 5, 1, 1, 1],
  },
  ext_move_axis: {
    title: 'Axis increments',
    variable: 'MYAXIS',
    fields: ['A1', 'A2', 'A3', 'A4', 'A5', 'A6'],
    units: ['°', '°', '°', '°', '°', '°'],
    most: [1, 1, 1, 1, 1, 1],
  },
};
const STEPS = 50; // of a slider, to each side
const WRITE_PERIOD = 100; // ms
const READ_PERIOD = 250; // ms

/** Returns a function that sends a change to the robot of the view and shows why it was refused. */
function useChange() {
  const robot = useRobot();
  return async (name, fields = {}) => {
    try {
      await call(name, { robot, confirmed: true, ...fields });
      return true;
    } catch (e) {
      note('error', e.message);
      return false;
    }
  };
}

function useBench() {
  const [bench, setBench] = useState(null);
  const { socket } = useSharedState();
  const robot = useRobot();
  const ask = () =>
    call('teach', { robot })
      .then(setBench)
      .catch((e) => note('error', e.message));
  useEffect(() => {
    if (socket === 'open') {
      ask();
    }
  }, [socket]);
  // other pages change it, too
  useEffect(() => onEvent('teach', (event) => event.robot === robot && setBench(event)), []);
  return [bench, ask];
}

function Mode() {
  const change = useChange();
  const one = header();
  const mode = isStale(one) ? null : one.mode;
  return h(
    'fieldset',
    { class: 'panel mode-key', disabled: !mayWrite() },
    h('legend', null, 'Mode key'),
    Object.entries(MODES).map(([name, value]) =>
      h(
        'button',
        {
          key: name,
          'aria-pressed': String(mode === value),
          onClick: () => change('teach-mode', { mode: name }),
        },
        name,
      ),
    ),
  );
}

function EmergencyStop({ bench, onChange }) {
  const change = useChange();
  const pressed = bench.emergency_stop;
  const press = async () => {
    await change('teach-stop', { pressed: !pressed });
    onChange();
  };
  return h(
    'section',
    { class: 'panel', 'aria-label': 'Emergency stop' },
    h(
      'button',
      { class: `emergency ${pressed ? 'pressed' : ''}`, 'aria-pressed': String(pressed), disabled: !mayWrite(), onClick: press },
      pressed ? 'Release the emergency stop' : 'Emergency stop',
    ),
    h('p', { class: 'hint' }, 'Of the simulated robot. It is not an emergency stop of a machine.'),
  );
}

function Faults({ bench, onChange }) {
  const change = useChange();
  const set = async (changes) => {
    await change('teach-faults', changes);
    onChange();
  };
  const slider = (label, name, most, unit) =>
    h(
      'label',
      null,
      `${label}: ${bench[name]} ${unit}`,
      h('input', {
        type: 'range',
        min: 0,
        max: most,
        step: most / 50,
        value: bench[name],
        onChange: (event) => set({ [name]: Number(event.target.value) }),
      }),
    );
  return h(
    'fieldset',
    { class: 'panel faults', disabled: !mayWrite() },
    h('legend', null, 'Faults of the network'),
    slider('Each answer is late by', 'latency_ms', 1000, 'ms'),
    slider('Answers that get lost', 'lost_percent', 50, '%'),
    h(
      'label',
      { class: 'switch' },
      h('input', {
        type: 'checkbox',
        checked: bench.silent,
        onChange: (event) => set({ silent: event.target.checked }),
      }),
      'The server does not answer',
    ),
    h(
      'div',
      { class: 'buttons' },
      h('button', { onClick: () => change('teach-fault', { kind: 'lose' }) }, 'Lose the next answer'),
      h('button', { onClick: () => change('teach-fault', { kind: 'cut' }) }, 'Cut the connection'),
    ),
    h('p', { class: 'hint' }, 'This page reads through the same server: watch its values become stale.'),
  );
}

/**
 * Writes the newest value of the sliders, one write at a time. Continues after a failed write or
 * the end of the view, since the last write may stop the robot.
 *
 * @param onDone called when the newest value is written, or the write failed
 */
function useWriter(variable, onDone) {
  const change = useChange();
  const writer = useRef({ next: null, busy: false });
  return async (value) => {
    const own = writer.current;
    own.next = value;
    if (own.busy) {
      return;
    }
    own.busy = true;
    while (own.next !== null) {
      const newest = own.next;
      own.next = null;
      await change('write', { name: variable, value: newest });
      await new Promise((resolve) => setTimeout(resolve, WRITE_PERIOD));
    }
    own.busy = false;
    onDone();
  };
}

/** Sliders for the increment that the running program adds repeatedly. */
function Increments({ program }) {
  const { variable, fields, units, most } = PROGRAMS[program];
  const [readings, stale] = useReadings('teach', [variable], READ_PERIOD);
  const [wanted, setWanted] = useState(null); // shown until the value can be read back
  const written = useRef(Infinity);
  const change = useChange();
  const write = useWriter(variable, () => (written.current = serverTime()));
  const reading = readings[variable];
  const isBack = reading?.time > written.current;
  const values = wanted && !isBack ? wanted : fields.map((name) => reading?.value?.[name]);
  const known = values.every(Number.isFinite);
  const set = (next) => {
    written.current = Infinity;
    setWanted(next);
    write(`{${fields.map((name, i) => `${name} ${next[i].toFixed(3)}`).join(',')}}`);
  };
  // like Stop, this also works while the robot is locked
  const still = () =>
    mayWrite() ? set(fields.map(() => 0)) : change('teach-still', { name: variable });
  return h(
    'fieldset',
    { class: `panel increments ${stale ? 'stale' : ''}` },
    h('legend', null, variable),
    reading?.error && h('p', { class: 'failure' }, reading.error),
    fields.map((name, i) =>
      h(
        'label',
        { key: name },
        h('span', null, name),
        h('input', {
          type: 'range',
          min: -most[i],
          max: most[i],
          step: most[i] / STEPS,
          value: known ? values[i] : 0,
          disabled: !known || !mayWrite(),
          'aria-label': `${variable}.${name} in ${units[i]} per step`,
          onInput: (event) => set(values.with(i, Number(event.target.value))),
        }),
        h('output', { class: 'reading' }, numberText(values[i], 2, units[i])),
      ),
    ),
    h(
      'div',
      { class: 'buttons' },
      h('button', { class: 'main', disabled: !mayStop(), onClick: still }, 'All to 0'),
    ),
    h(
      'p',
      { class: 'hint' },
      `The program adds ${variable} to the position again and again: the robot moves until all are 0.`,
    ),
  );
}

function Programs({ onChange }) {
  const change = useChange();
  const one = header();
  const running = Object.keys(PROGRAMS).find((name) => one.robot_program === name.toUpperCase());
  const start = async (program) => {
    await change('teach-program', { program });
    onChange();
  };
  return [
    h(
      'fieldset',
      { key: 'programs', class: 'panel', disabled: !mayWrite() },
      h('legend', null, 'Move by a variable'),
      h(
        'div',
        { class: 'buttons' },
        Object.entries(PROGRAMS).map(([name, { title, variable }]) =>
          h('button', { key: name, 'aria-pressed': String(name === running), onClick: () => start(name) }, `${variable}: ${title}`),
        ),
      ),
      h(
        'p',
        { class: 'hint' },
        'Ends all faults, puts the robot at its start, and starts the program of krl that follows the variable, in AUT.',
      ),
    ),
    running && h(Increments, { key: running, program: running }),
  ];
}

/** Draws a node of a lesson; a node of an unknown kind becomes its text. */
function Node({ node, onLesson }) {
  const children = () =>
    (node.children ?? []).map((one, i) => h(Node, { key: i, node: one, onLesson }));
  switch (node.kind) {
    case 'text':
      return node.text;
    case 'code':
      return h('code', null, node.text);
    case 'pre':
      return h('pre', { tabIndex: 0 }, node.text);
    case 'lesson':
      return h('button', { class: 'link', onClick: () => onLesson(node.name) }, children());
    case 'h2':
    case 'h3':
    case 'h4':
    case 'p':
    case 'ul':
    case 'ol':
    case 'li':
    case 'em':
    case 'strong':
      return h(node.kind, null, children());
    default:
      return h('span', null, children());
  }
}

function Lesson() {
  const [lessons, setLessons] = useState([]);
  const [name, setName] = useState(sessionStorage.getItem('lesson') ?? '');
  const [nodes, setNodes] = useState([]);
  useEffect(() => {
    call('lessons')
      .then((answer) => {
        setLessons(answer.lessons);
        setName((old) => old || answer.lessons[0].name);
      })
      .catch((e) => note('error', e.message));
  }, []);
  useEffect(() => {
    let wanted = true;
    if (name) {
      sessionStorage.setItem('lesson', name);
      call('lesson', { name })
        .then((answer) => wanted && setNodes(answer.nodes))
        .catch((e) => wanted && note('error', e.message));
    }
    return () => (wanted = false);
  }, [name]);
  return h(
    'section',
    { class: 'panel lesson', 'aria-label': 'Lesson' },
    h(
      'select',
      { 'aria-label': 'Lesson', value: name, onChange: (event) => setName(event.target.value) },
      lessons.map((one) => h('option', { key: one.name, value: one.name }, one.title)),
    ),
    h(
      'article',
      { key: name },
      nodes.map((node, i) => h(Node, { key: i, node, onLesson: setName })),
    ),
  );
}

export function View() {
  useSharedState();
  const [bench, ask] = useBench();
  if (!bench) {
    return h(Waiting, { title: 'Teach' });
  }
  if (!bench.simulated) {
    return h(
      'section',
      { class: 'panel' },
      h('h1', null, 'Teach'),
      h(
        'p',
        null,
        'Mode key, emergency stop and faults are for simulated robots. Start a page with one by ',
        h('code', null, 'jopenshowvar web --mock'),
        '.',
      ),
    );
  }
  return h(
    'div',
    { class: 'teach' },
    h(
      'div',
      { class: 'controls' },
      h('h1', { class: 'unseen' }, 'Teach'),
      !mayWrite() && h('p', { class: 'panel hint' }, writeHint('to change it')),
      h(Programs, { onChange: ask }),
      h(Mode),
      h(EmergencyStop, { bench, onChange: ask }),
      h(Faults, { bench, onChange: ask }),
    ),
    h('div', { class: 'picture-side' }, h(Robot)),
    h(Lesson),
  );
}
