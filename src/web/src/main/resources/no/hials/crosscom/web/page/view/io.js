// The view of inputs and outputs: lamps, switches and analog values, one bank at a time.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { Confirm } from '../programs/confirm.js';
import { useReadings } from '../readings.js';
import { call, onEvent } from '../socket.js';
import { header, isStale, mayWrite, note, state, useRobot, useSharedState, writeHint } from '../state.js';

const BANK = 16;
const ANALOG_BANK = 8;
const MAX_FOUND = 12;
const MAX_BITS = 32;

/** Names and lengths; requested again when the server has read the data lists. */
function useSignals() {
  const { socket } = useSharedState();
  const [answer, setAnswer] = useState({ signals: [], lengths: {}, simulated: false });
  useEffect(() => {
    let wanted = true;
    const ask = () =>
      call('signals', { robot: state.robot })
        .then((found) => wanted && setAnswer(found))
        .catch((e) => wanted && note('error', e.message));
    if (socket === 'open') {
      ask();
    }
    const stop = onEvent('names', (event) => event.robot === state.robot && ask());
    return () => {
      wanted = false;
      stop();
    };
  }, [socket]);
  return answer;
}

function element(array, number) {
  return { array, number, name: `${array}[${number}]` };
}

/** The elements that signals name, by their own name; an element of a range with its bit. */
function namedElements(signals) {
  const named = new Map();
  for (const { array, first, last, names } of signals) {
    for (let n = first; n <= Math.min(last, first + MAX_BITS - 1); n++) {
      const one = element(array, n);
      const before = named.get(one.name)?.names ?? [];
      const more = first === last ? names : names.map((name) => `${name} bit ${n - first}`);
      named.set(one.name, { ...one, names: [...before, ...more] });
    }
  }
  return named;
}

function elements(array, first, count, length) {
  return Array.from({ length: Math.max(0, Math.min(count, length - first + 1)) }, (_, i) =>
    element(array, first + i),
  );
}

function BankChoice({ title, first, size, length, onChange }) {
  const last = Math.max(1, length - ((length - 1) % size));
  const move = (by) => onChange(Math.min(last, Math.max(1, first + by)));
  return h(
    'div',
    { class: 'bank', role: 'group', 'aria-label': `Bank of ${title}` },
    h('button', { disabled: first <= 1, 'aria-label': 'Previous bank', onClick: () => move(-size) }, '‹'),
    h(
      'label',
      null,
      'from ',
      h('input', {
        type: 'number',
        min: 1,
        max: length || 1,
        value: first,
        onChange: (event) => {
          const number = Number(event.target.value);
          if (number >= 1 && number <= length) {
            onChange(number - ((number - 1) % size));
          }
        },
      }),
      ` of ${length || '…'}`,
    ),
    h('button', { disabled: first >= last, 'aria-label': 'Next bank', onClick: () => move(size) }, '›'),
  );
}

/** The elements of an array that are shown, and their head with the choice of the bank. */
function useBank({ title, array, length, named, period, size, jump }) {
  const [first, setFirst] = useState(1);
  useEffect(() => {
    if (jump?.array === array) {
      setFirst(jump.number - ((jump.number - 1) % size));
    }
  }, [jump]);
  const shown = elements(array, first, size, length);
  const [values, stale] = useReadings(array, shown.map((one) => one.name), period);
  const head = h(
    'div',
    { class: 'text-tools' },
    h('h2', null, title),
    h(BankChoice, { title, first, size, length, onChange: setFirst }),
    stale &&
      !isStale(header()) &&
      h('span', { class: 'hint' }, 'Not up to date: the server needs long to read them.'),
  );
  const rows = shown.map((one) => ({ ...one, names: named.get(one.name)?.names ?? [], reading: values[one.name] }));
  return { head, rows, kind: `panel ${stale ? 'stale' : ''}` };
}

/** A lamp with its number and names; a switch if it can be changed. */
function Lamp({ name, number, names, reading, onSwitch }) {
  const known = typeof reading?.value === 'boolean';
  const on = known && reading.value;
  const words = known ? (on ? 'TRUE' : 'FALSE') : (reading?.error ?? '…');
  const content = [
    h('span', { key: 'lamp', class: `lamp ${on ? 'on' : ''} ${known ? '' : 'dark'}`, 'aria-hidden': 'true' }),
    h('span', { key: 'number', class: 'number' }, number),
    h('span', { key: 'names', class: 'names' }, names.join(', ')),
    h('span', { key: 'words', class: known ? 'words reading' : 'words failure' }, words),
  ];
  return h(
    'li',
    null,
    onSwitch
      ? h(
          'button',
          {
            class: 'io-switch',
            role: 'switch',
            'aria-checked': String(on),
            'aria-label': [name, ...names].join(', '),
            disabled: !known || !mayWrite(),
            onClick: () => onSwitch(name, number, !on),
          },
          content,
        )
      : h('div', { class: 'io-lamp' }, content),
  );
}

function Digital({ onSwitch, children, ...bank }) {
  const { head, rows, kind } = useBank({ ...bank, size: BANK });
  return h(
    'section',
    { class: kind, 'aria-label': bank.title },
    head,
    h('ul', { class: 'lamps' }, rows.map((one) => h(Lamp, { key: one.name, ...one, onSwitch }))),
    children,
  );
}

function Analog({ onSet, ...bank }) {
  const { head, rows, kind } = useBank({ ...bank, size: ANALOG_BANK });
  return h(
    'section',
    { class: kind, 'aria-label': bank.title },
    head,
    h(
      'ul',
      { class: 'analog' },
      rows.map(({ name, number, names, reading }) => {
        const known = typeof reading?.value === 'number';
        return h(
          'li',
          { key: name },
          h('span', { class: 'number' }, number),
          h('span', { class: 'names' }, names.join(', ')),
          known && h('meter', { min: -1, max: 1, value: reading.value, 'aria-label': name }),
          h(
            'span',
            { class: known ? 'reading' : 'failure' },
            known ? reading.value.toFixed(3) : (reading?.error ?? '…'),
          ),
          onSet &&
            h(
              'button',
              { disabled: !known || !mayWrite(), 'aria-label': `Set ${name}`, onClick: () => onSet(name, number, reading.value) },
              'Set …',
            ),
        );
      }),
    ),
  );
}

function Find({ named, onJump }) {
  const [text, setText] = useState('');
  const wanted = text.trim().toUpperCase();
  const found = wanted
    ? [...named.values()]
        .filter(
          ({ array, name, names }) =>
            (array === '$IN' || array === '$OUT') && `${name} ${names}`.toUpperCase().includes(wanted),
        )
        .slice(0, MAX_FOUND)
    : [];
  return h(
    'section',
    { class: 'panel find', 'aria-label': 'Find by name' },
    h('input', {
      type: 'search',
      placeholder: 'Name of a signal …',
      'aria-label': 'Find an input or output by its name',
      value: text,
      onInput: (event) => setText(event.target.value),
    }),
    found.map(({ array, number, name, names }) =>
      h('button', { key: name, onClick: () => onJump({ array, number }) }, `${names.join(', ')} ${name}`),
    ),
    wanted && found.length === 0 && h('span', { class: 'hint' }, 'No SIGNAL of this name is known.'),
  );
}

/** A field for an analog value in the dialog, which otherwise shows a fixed value. */
function AnalogField({ value, onInput }) {
  return h(
    'label',
    null,
    'New value, -1 to 1',
    h('input', {
      type: 'number',
      min: -1,
      max: 1,
      step: 'any',
      required: true,
      defaultValue: value,
      onInput: (event) => onInput(event.target.value),
    }),
  );
}

export function View() {
  useSharedState();
  const one = header();
  const robot = useRobot();
  const { signals, lengths, simulated } = useSignals();
  const [asked, setAsked] = useState(null);
  const [asks, setAsks] = useState(true);
  const [jump, setJump] = useState(null);
  const named = namedElements(signals);
  const unlocked = mayWrite();
  useEffect(() => {
    if (!unlocked) {
      setAsks(true); // each person who unlocks decides again
    }
  }, [unlocked]);
  // KUKAVARPROXY reads one variable after the other
  const period = (one.server ?? '').startsWith('C3') ? 250 : 1000;
  const write = async (name, value, before) => {
    const { text } = await call('write', { robot, name, value, before, confirmed: true });
    return `${name} = ${text}`;
  };
  const setInput = async (fields, name) => {
    await call('set-input', { robot, ...fields, confirmed: true });
    return `${name} is set`;
  };
  const change = async (name, value, warning, work) => {
    if (asks) {
      const label = [name, ...(named.get(name)?.names ?? [])].join(', ');
      setAsked({ title: `Switch ${name} ${value ? 'on' : 'off'}?`, action: value ? 'Switch on' : 'Switch off', facts: [['Signal', label]], warning, work });
      return;
    }
    try {
      await work();
    } catch (e) {
      note('error', e.message);
    }
  };
  const switchOutput = (name, number, value) =>
    change(name, value, 'An output can move a gripper or another machine.', () =>
      write(name, value ? 'TRUE' : 'FALSE', value ? 'FALSE' : 'TRUE'),
    );
  const switchInput = (name, number, value) =>
    change(name, value, 'A program may wait for this input, and move the robot.', () =>
      setInput({ number, value }, name),
    );
  const setAnalog = (output) => (name, number, value) => {
    let text = String(value);
    setAsked({
      title: `Set ${name}?`,
      action: 'Set',
      facts: [['Old', value.toFixed(3)]],
      warning: output ? 'An output can move another machine.' : '',
      details: h(AnalogField, { value, onInput: (typed) => (text = typed) }),
      work: () =>
        output
          ? write(name, text, String(value))
          : setInput({ analog: true, number, value: Number(text) }, name),
    });
  };
  return h(
    'div',
    { class: 'io' },
    h('h1', { class: 'unseen' }, 'Inputs and outputs'),
    h(Find, { named, onJump: setJump }),
    h(
      Digital,
      {
        title: 'Inputs',
        array: '$IN',
        length: lengths.$IN ?? 0,
        named,
        period,
        jump,
        onSwitch: simulated ? switchInput : undefined,
      },
      h(
        'p',
        { class: 'hint' },
        simulated
          ? 'This robot is simulated: its inputs can be set, as its cell would.'
          : 'The controller takes its inputs from the bus: nobody can set them from here.',
      ),
    ),
    h(
      Digital,
      { title: 'Outputs', array: '$OUT', length: lengths.$OUT ?? 0, named, period, jump, onSwitch: switchOutput },
      h(
        'label',
        { class: 'switch' },
        h('input', {
          type: 'checkbox',
          checked: asks,
          disabled: !unlocked,
          onChange: (event) => setAsks(event.target.checked),
        }),
        'Ask before each switch',
      ),
      h(
        'p',
        { class: 'hint' },
        unlocked ? 'Outputs that system signals use cannot be set.' : writeHint('to switch outputs'),
      ),
    ),
    h(Analog, {
      title: 'Analog inputs',
      array: '$ANIN',
      length: lengths.$ANIN ?? 0,
      named,
      period,
      onSet: simulated ? setAnalog(false) : undefined,
    }),
    h(Analog, { title: 'Analog outputs', array: '$ANOUT', length: lengths.$ANOUT ?? 0, named, period, onSet: setAnalog(true) }),
    asked && h(Confirm, { asked, onClose: () => setAsked(null) }),
  );
}
