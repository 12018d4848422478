// The search of variables in the data lists that the server knows.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { call, onEvent } from '../socket.js';
import { note, state } from '../state.js';

/** Searches; searches again when the server has read the data lists of the controller. */
function useSearch(text) {
  const [answer, setAnswer] = useState({ total: 0, found: [] });
  useEffect(() => {
    let wanted = true;
    const ask = () =>
      call('search', { robot: state.robot, text, limit: 60 })
        .then((found) => wanted && setAnswer(found))
        .catch((e) => wanted && note('error', e.message));
    ask();
    const stop = onEvent('names', (event) => event.robot === state.robot && ask());
    return () => {
      wanted = false;
      stop();
    };
  }, [text, state.socket]);
  return answer;
}

/** The fields of a structure, each of which can be watched alone. */
function Fields({ name, onAdd }) {
  const [fields, setFields] = useState([]);
  useEffect(() => {
    call('describe', { robot: state.robot, name })
      .then((answer) => setFields(answer.fields ?? []))
      .catch((e) => note('error', e.message));
  }, [name]);
  return h(
    'ul',
    { class: 'parts' },
    fields.map((field) =>
      h(
        'li',
        { key: field.name },
        h(
          'button',
          { onClick: () => onAdd(`${name}.${field.name}`) },
          h('span', { class: 'variable' }, `.${field.name}`),
          h('span', { class: 'kind' }, field.type),
        ),
      ),
    ),
  );
}

function Found({ entry, names, onAdd }) {
  const [open, setOpen] = useState(false);
  const isArray = entry.dimensions.length > 0;
  const name = isArray ? `${entry.name}[]` : entry.name;
  return h(
    'li',
    null,
    h(
      'div',
      { class: 'entry' },
      entry.structure && !isArray
        ? h(
            'button',
            {
              class: 'opener',
              'aria-expanded': String(open),
              'aria-label': `Fields of ${name}`,
              onClick: () => setOpen(!open),
            },
            open ? '▾' : '▸',
          )
        : h('span', { class: 'opener' }),
      h(
        'button',
        {
          disabled: names.includes(name.toUpperCase()),
          title: entry.meaning,
          onClick: () => onAdd(name),
        },
        h('span', { class: 'variable' }, name),
        h(
          'span',
          { class: 'kind' },
          [entry.type, entry.unit, entry.access].filter((it) => it && it !== '-').join(' '),
        ),
        h('span', { class: 'meaning' }, entry.meaning || entry.origin),
      ),
    ),
    open && h(Fields, { name, onAdd }),
  );
}

/** Searches variables and their fields; those in a list of names cannot be added again. */
export function Search({ names, onAdd }) {
  const [text, setText] = useState('');
  const answer = useSearch(text);
  const typed = text.trim().toUpperCase();
  return h(
    'section',
    { class: 'panel search', 'aria-label': 'Search' },
    h('input', {
      type: 'search',
      placeholder: 'Name, meaning, unit …',
      'aria-label': 'Search variables',
      maxLength: 200, // as the server searches
      value: text,
      onInput: (event) => setText(event.target.value),
      onKeyDown: (event) => {
        if (event.key === 'Enter' && typed) {
          onAdd(typed);
          event.target.select(); // the next name replaces it
        }
      },
    }),
    h(
      'p',
      { class: 'hint' },
      `${answer.total} found. Enter adds the text itself, such as $POS_ACT.X or $IN[1].`,
      answer.loading ? ' The data lists of the controller are being read.' : '',
    ),
    h(
      'ul',
      { class: 'found' },
      answer.found.map((entry) => h(Found, { key: entry.name, entry, names, onAdd })),
    ),
  );
}
