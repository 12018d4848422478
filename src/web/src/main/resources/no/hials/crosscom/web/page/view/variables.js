// The view of variables: search, a list that is watched, and changes with a confirmation.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { Dialog } from '../dialog.js';
import { call, watch } from '../socket.js';
import { header, isStale, mayWrite, note, serverTime, state, useSharedState } from '../state.js';
import { Value, valueText } from '../value.js';

const PERIOD = 250;
const FIRST_LIST = ['$POS_ACT', '$AXIS_ACT', '$OV_PRO', '$MODE_OP', '$VEL_ACT'];

function savedList() {
  try {
    const names = JSON.parse(localStorage.getItem(`watch-list/${state.robot}`));
    return Array.isArray(names) ? names.map(String) : FIRST_LIST;
  } catch {
    return FIRST_LIST;
  }
}

/** Returns the readings of a list by its names, with the time when each value changed. */
function useReadings(names) {
  const readings = useRef(new Map());
  const [, setCount] = useState(0);
  const key = names.join('\n');
  useEffect(
    () =>
      watch(state.robot, 'variables', names, PERIOD, (event) => {
        for (const [name, reading] of Object.entries(event.values)) {
          const old = readings.current.get(name);
          if (event.missed) {
            continue; // the old value stays, and is stale
          }
          const text = valueText(reading);
          const isNew = old !== undefined && old.text !== text;
          readings.current.set(name, {
            ...reading,
            text,
            time: event.time,
            changed: isNew ? event.time : (old?.changed ?? 0),
          });
        }
        setCount((count) => count + 1);
      }),
    [key],
  );
  return readings.current;
}

function Search({ names, onAdd }) {
  const [text, setText] = useState('');
  const [answer, setAnswer] = useState({ total: 0, found: [] });
  useEffect(() => {
    let wanted = true;
    call('search', { robot: state.robot, text, limit: 60 })
      .then((found) => wanted && setAnswer(found))
      .catch((e) => wanted && note('error', e.message));
    return () => (wanted = false);
  }, [text, state.socket]);
  const typed = text.trim().toUpperCase();
  return h(
    'section',
    { class: 'panel search', 'aria-label': 'Search' },
    h('input', {
      type: 'search',
      placeholder: 'Name, meaning, unit …',
      'aria-label': 'Search variables',
      value: text,
      onInput: (event) => setText(event.target.value),
      onKeyDown: (event) => event.key === 'Enter' && typed && onAdd(typed),
    }),
    h(
      'p',
      { class: 'hint' },
      `${answer.total} found. Enter adds the text itself, such as $POS_ACT.X or $IN[1].`,
    ),
    h(
      'ul',
      { class: 'found' },
      answer.found.map((entry) => {
        const name = entry.dimensions.length > 0 ? `${entry.name}[]` : entry.name;
        const watched = names.includes(name.toUpperCase());
        return h(
          'li',
          { key: entry.name },
          h(
            'button',
            { disabled: watched, title: entry.meaning, onClick: () => onAdd(name) },
            h('span', { class: 'variable' }, name),
            h(
              'span',
              { class: 'kind' },
              [entry.type, entry.unit, entry.access].filter((it) => it && it !== '-').join(' '),
            ),
            h('span', { class: 'meaning' }, entry.meaning),
          ),
        );
      }),
    ),
  );
}

function Row({ name, reading, stale, onEdit, onRemove }) {
  const now = serverTime();
  const fresh = reading?.changed && now - reading.changed < 1500;
  return h(
    'tr',
    { class: `${stale ? 'stale' : ''} ${fresh ? 'fresh' : ''}` },
    h('th', { scope: 'row', class: 'variable' }, name),
    h('td', { class: 'reading' }, h(Value, { reading })),
    h('td', { class: 'type' }, reading?.struc ?? reading?.type ?? ''),
    h(
      'td',
      { class: 'buttons' },
      h(
        'button',
        { 'aria-label': `Change ${name}`, disabled: !mayWrite() || !reading, onClick: onEdit },
        'Change',
      ),
      h('button', { 'aria-label': `Remove ${name}`, class: 'quiet', onClick: onRemove }, '×'),
    ),
  );
}

/** Asks for a new value, and then whether to write it. */
function Edit({ name, onClose }) {
  const [before, setBefore] = useState(null);
  const [value, setValue] = useState('');
  const [constants, setConstants] = useState([]);
  const [asked, setAsked] = useState(false);
  const [error, setError] = useState('');
  useEffect(() => {
    call('read', { robot: state.robot, name })
      .then(({ text }) => {
        setBefore(text);
        setValue(text);
      })
      .catch((e) => setError(e.message));
    call('describe', { robot: state.robot, name })
      .then((answer) => setConstants(answer.constants ?? []))
      .catch(() => {});
  }, [name]);
  const write = async () => {
    try {
      const fields = { robot: state.robot, name, value, before: before ?? '', confirmed: true };
      const { text } = await call('write', fields);
      note('done', `${name} = ${text}`);
      onClose();
    } catch (e) {
      setAsked(false);
      setError(e.message);
    }
  };
  const submit = (event) => {
    event.preventDefault();
    if (asked) {
      write();
    } else {
      setError('');
      setAsked(true);
    }
  };
  return h(
    Dialog,
    { title: asked ? `Write ${name}?` : `Change ${name}`, onClose },
    h(
      'form',
      { onSubmit: submit },
      asked
        ? h(
            'dl',
            { class: 'change' },
            h('dt', null, 'Robot'),
            h('dd', null, `${state.robot}, mode ${header().mode ?? 'unknown'}`),
            h('dt', null, 'Old'),
            h('dd', { class: 'variable' }, before),
            h('dt', null, 'New'),
            h('dd', { class: 'variable new' }, value),
          )
        : h(
            'label',
            null,
            'New value, as KRL',
            h('input', {
              value,
              list: 'constants',
              autofocus: true,
              spellcheck: false,
              autocomplete: 'off',
              onInput: (event) => setValue(event.target.value),
            }),
            h(
              'datalist',
              { id: 'constants' },
              constants.map((one) => h('option', { key: one, value: one })),
            ),
          ),
      error && h('p', { class: 'failure', role: 'alert' }, error),
      h(
        'div',
        { class: 'buttons' },
        h('button', { type: 'button', class: 'quiet', onClick: onClose }, 'Cancel'),
        h(
          'button',
          { class: 'main', disabled: before === null || value.trim() === '' },
          asked ? 'Write' : 'Continue',
        ),
      ),
    ),
  );
}

export function View() {
  useSharedState();
  const [names, setNames] = useState(savedList);
  const [edited, setEdited] = useState(null);
  const readings = useReadings(names);
  const save = (list) => {
    setNames(list);
    localStorage.setItem(`watch-list/${state.robot}`, JSON.stringify(list));
  };
  const add = (name) => {
    const key = name.toUpperCase();
    if (!names.includes(key)) {
      save([...names, key]);
    }
  };
  const cut = isStale(header());
  return h(
    'div',
    { class: 'variables' },
    h(Search, { names, onAdd: add }),
    h(
      'section',
      { class: 'panel watched', 'aria-label': 'Watched variables' },
      names.length === 0
        ? h('p', { class: 'hint' }, 'Choose variables on the left to watch them.')
        : h(
            'table',
            null,
            h(
              'thead',
              null,
              h(
                'tr',
                null,
                ['Variable', 'Value', 'Type', ''].map((title) => h('th', { scope: 'col' }, title)),
              ),
            ),
            h(
              'tbody',
              null,
              names.map((name) => {
                const reading = readings.get(name);
                const old = !reading || serverTime() - reading.time > 4 * PERIOD;
                return h(Row, {
                  key: name,
                  name,
                  reading,
                  stale: cut || old,
                  onEdit: () => setEdited(name),
                  onRemove: () => save(names.filter((it) => it !== name)),
                });
              }),
            ),
          ),
    ),
    edited && h(Edit, { name: edited, onClose: () => setEdited(null) }),
  );
}
