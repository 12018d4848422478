// The view of variables: search, a list that is watched, and changes with a confirmation.

import { h } from 'preact';
import { useState } from 'preact/hooks';
import { note, useSharedState } from '../state.js';
import { Edit } from '../variables/edit.js';
import { Lists, useList } from '../variables/lists.js';
import { Search } from '../variables/search.js';
import { useHistory, WatchTable } from '../variables/table.js';

const MAX_NAMES = 500; // as the server watches

export function View() {
  useSharedState();
  const [list, change] = useList();
  const [filter, setFilter] = useState('');
  const [edited, setEdited] = useState(null);
  const history = useHistory(list);
  const add = (name) => {
    const key = name.toUpperCase();
    if (list.names.length >= MAX_NAMES) {
      note('error', `A list can have at most ${MAX_NAMES} variables.`);
    } else if (!list.names.includes(key)) {
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
            onEdit: setEdited,
            onRemove: (name) => change({ names: list.names.filter((it) => it !== name) }),
          }),
    ),
    edited && h(Edit, { name: edited, onClose: () => setEdited(null) }),
  );
}
