// The table of watched variables: structures and arrays open into their parts, changed values are
// marked, and numbers have a line with their history.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { watch } from '../socket.js';
import { header, isStale, mayWrite, oldAfter, serverTime, state, useAges } from '../state.js';
import { Value, valueText } from '../value.js';

const MARKED = 1500; // ms after a change
const MAX_POINTS = 120;
const WIDTH = 96;
const HEIGHT = 20;

/** Returns the parts of a value: names and readings; none for a scalar. */
function partsOf(name, reading) {
  const value = reading?.value;
  if (value === null || typeof value !== 'object') {
    return [];
  }
  const base = name.replace(/\[\]$/, '');
  return Array.isArray(value)
    ? value.map((one, i) => [`${base}[${i + 1}]`, { type: reading.type, value: one }])
    : Object.entries(value).map(([field, one]) => [`${base}.${field}`, { type: '', value: one }]);
}

/** The last values of each variable and each of its parts. */
class History {
  readings = new Map();
  numbers = new Map();

  add(name, reading, time) {
    const text = valueText(reading);
    const old = this.readings.get(name);
    const isNew = old !== undefined && old.text !== text;
    this.readings.set(name, {
      ...reading,
      text,
      time,
      changed: isNew ? time : (old?.changed ?? 0),
    });
    const parts = partsOf(name, reading);
    parts.forEach(([part, one]) => this.add(part, one, time));
    if (typeof reading.value === 'number') {
      const numbers = this.numbers.get(name) ?? [];
      this.numbers.set(name, numbers);
      numbers.push(reading.value);
      if (numbers.length > MAX_POINTS) {
        numbers.shift();
      }
    }
  }
}

/** Watches a list; renders again with each reading. */
export function useHistory({ names, period }) {
  const history = useRef(new History());
  const [, setCount] = useState(0);
  useEffect(
    () =>
      watch(state.robot, 'variables', names, period, (event) => {
        if (event.missed) {
          return; // the old values stay, and become stale
        }
        for (const [name, reading] of Object.entries(event.values)) {
          history.current.add(name, reading, event.time);
        }
        setCount((count) => count + 1);
      }),
    [names.join('\n'), period],
  );
  return history.current;
}

/** A line with the last values of a number. */
function Sparkline({ numbers }) {
  if (numbers === undefined || numbers.length < 2) {
    return null;
  }
  const least = Math.min(...numbers);
  const range = Math.max(...numbers) - least;
  const points = numbers.map((value, i) => {
    const x = (i * WIDTH) / (MAX_POINTS - 1);
    const y = range === 0 ? HEIGHT / 2 : HEIGHT - 1 - ((value - least) / range) * (HEIGHT - 2);
    return `${x.toFixed(1)},${y.toFixed(1)}`;
  });
  return h(
    'svg',
    {
      class: 'sparkline',
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      role: 'img',
      'aria-label': `The last ${numbers.length} values were ${least} to ${least + range}`,
    },
    h('polyline', { points: points.join(' ') }),
  );
}

function Row({ name, title, level, reading, numbers, stale, isOpen, onOpen, onEdit, onRemove }) {
  const isMarked = reading?.changed && serverTime() - reading.changed < MARKED;
  const isGroup = onOpen !== null;
  return h(
    'tr',
    { class: `${stale ? 'stale' : ''} ${isMarked ? 'fresh' : ''} level-${Math.min(level, 3)}` },
    h(
      'th',
      { scope: 'row', class: 'variable' },
      isGroup
        ? h(
            'button',
            {
              class: 'opener',
              'aria-expanded': String(isOpen),
              'aria-label': `Parts of ${name}`,
              onClick: onOpen,
            },
            isOpen ? '▾' : '▸',
          )
        : h('span', { class: 'opener' }),
      h('span', null, title),
    ),
    h('td', { class: 'reading' }, isOpen ? null : h(Value, { reading })),
    h('td', { class: 'history' }, h(Sparkline, { numbers })),
    h('td', { class: 'type' }, reading?.struc ?? reading?.type ?? ''),
    h(
      'td',
      { class: 'buttons' },
      h(
        'button',
        { 'aria-label': `Change ${name}`, disabled: !mayWrite() || !reading, onClick: onEdit },
        'Change',
      ),
      onRemove &&
        h('button', { 'aria-label': `Remove ${name}`, class: 'quiet', onClick: onRemove }, '×'),
    ),
  );
}

/** Shows the variables of a list that a filter selects. */
export function WatchTable({ list, history, filter, onEdit, onRemove }) {
  const [open, setOpen] = useState(new Set());
  const toggle = (name) => {
    const next = new Set(open);
    if (!next.delete(name)) {
      next.add(name);
    }
    setOpen(next);
  };
  const isOld = (reading) => !reading || serverTime() - reading.time > oldAfter(list.period);
  useAges(() => list.names.map((name) => isOld(history.readings.get(name))).join());
  const cut = isStale(header());
  const words = filter.toUpperCase();
  const rows = [];
  const add = (name, level, title) => {
    const reading = history.readings.get(name);
    const parts = partsOf(name, reading);
    const isOpen = open.has(name) && parts.length > 0;
    rows.push(
      h(Row, {
        key: name,
        name,
        title,
        level,
        reading,
        numbers: history.numbers.get(name),
        stale: cut || isOld(reading),
        isOpen,
        onOpen: parts.length > 0 ? () => toggle(name) : null,
        onEdit: () => onEdit(name),
        onRemove: level === 0 ? () => onRemove(name) : null,
      }),
    );
    if (isOpen) {
      const skipped = name.replace(/\[\]$/, '').length;
      parts.forEach(([part]) => add(part, level + 1, part.slice(skipped)));
    }
  };
  list.names
    .filter((name) => {
      const text = history.readings.get(name)?.text ?? '';
      return name.includes(words) || text.toUpperCase().includes(words);
    })
    .forEach((name) => add(name, 0, name));
  return h(
    'table',
    null,
    h(
      'thead',
      null,
      h(
        'tr',
        null,
        ['Variable', 'Value', 'History', 'Type', 'Change'].map((title) =>
          h('th', { key: title, scope: 'col' }, title),
        ),
      ),
    ),
    h('tbody', null, rows),
  );
}
