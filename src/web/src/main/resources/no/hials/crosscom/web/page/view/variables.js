// The view of variables: search, a list that is watched, and changes with a confirmation.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { call, onEvent } from '../socket.js';
import { header, isStale, note, state, useSharedState } from '../state.js';
import { Edit } from '../variables/edit.js';
import { Lists, useList } from '../variables/lists.js';
import { useHistory, WatchTable } from '../variables/table.js';

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

function Search({ names, onAdd }) {
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
      value: text,
      onInput: (event) => setText(event.target.value),
      onKeyDown: (event) => event.key === 'Enter' && typed && onAdd(typed),
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

export function View() {
  useSharedState();
  const [list, change] = useList();
  const [filter, setFilter] = useState('');
  const [edited, setEdited] = useState(null);
  const history = useHistory(list);
  const add = (name) => {
    const key = name.toUpperCase();
    if (!list.names.includes(key)) {
      change({ names: [...list.names, key] });
    }
  };
  return h(
    'div',
    { class: 'variables' },
    h('h1', { class: 'unseen' }, 'Variables'),
    h(Search, { names: list.names, onAdd: add }),
    h(
      'section',
      { class: 'panel watched', 'aria-label': 'Watched variables' },
      h(
        'div',
        { class: 'list-tools' },
        h(Lists, { list, onChange: change }),
        h('input', {
          type: 'search',
          class: 'filter',
          placeholder: 'Filter',
          'aria-label': 'Filter the list',
          value: filter,
          onInput: (event) => setFilter(event.target.value),
        }),
      ),
      list.names.length === 0
        ? h('p', { class: 'hint' }, 'Choose variables in the search to watch them.')
        : h(WatchTable, {
            list,
            history,
            filter,
            cut: isStale(header()),
            onEdit: setEdited,
            onRemove: (name) => change({ names: list.names.filter((it) => it !== name) }),
          }),
    ),
    edited && h(Edit, { name: edited, onClose: () => setEdited(null) }),
  );
}
