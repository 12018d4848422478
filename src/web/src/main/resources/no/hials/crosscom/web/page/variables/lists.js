// The lists of watched variables: one that belongs to this browser, and those that the server
// keeps for all browsers. They are exchanged as text files with one name on each line.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { Dialog, useChange } from '../dialog.js';
import { call, onEvent } from '../socket.js';
import { mayOperate, note, state, useSharedState } from '../state.js';

export const PERIODS = [50, 100, 250, 500, 1000, 5000];
const MAX_BYTES = 200_000; // of a file
const MAX_CHARACTERS = 255; // the server refuses a whole list with a longer name
const DEFAULT = {
  name: '',
  period: 250,
  names: ['$POS_ACT', '$AXIS_ACT', '$OV_PRO', '$MODE_OP', '$VEL_ACT'],
};

function stored() {
  try {
    const list = JSON.parse(localStorage.getItem(`watch-list/${state.robot}`));
    return Array.isArray(list.names)
      ? {
          name: String(list.name),
          period: Number(list.period),
          names: list.names.map(String).filter((name) => name.length <= MAX_CHARACTERS),
        }
      : DEFAULT;
  } catch {
    return DEFAULT;
  }
}

/** Returns the list that is watched, and a function that replaces some of its fields. */
export function useList() {
  const [list, setList] = useState(stored);
  const change = (fields) => {
    const next = { ...list, ...fields };
    setList(next);
    localStorage.setItem(`watch-list/${state.robot}`, JSON.stringify(next));
  };
  return [list, change];
}

function useSavedLists() {
  const [lists, setLists] = useState([]);
  const { socket } = useSharedState();
  useEffect(() => {
    const ask = () =>
      call('lists')
        .then((answer) => setLists(answer.lists))
        .catch((e) => note('error', e.message));
    if (socket === 'open') {
      ask();
    }
    return onEvent('lists', ask);
  }, [socket]);
  return lists;
}

/** Offers a text as a file. */
function download(name, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type: 'text/plain' }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function Save({ list, saved, onSaved, onClose }) {
  const [name, setName] = useState(list.name);
  const { busy, error, close, make } = useChange(onClose);
  const replaced = saved.find((one) => one.name.toLowerCase() === name.trim().toLowerCase());
  const submit = async (event) => {
    event.preventDefault();
    const fields = { name: name.trim(), period: list.period, names: list.names };
    if (await make(() => call('list-save', fields))) {
      onSaved(replaced?.name ?? name.trim());
      onClose();
    }
  };
  return h(
    Dialog,
    { title: 'Save the list for all browsers', onClose: close },
    h(
      'form',
      { onSubmit: submit },
      h(
        'label',
        null,
        'Name',
        h('input', { value: name, autofocus: true, onInput: (event) => setName(event.target.value) }),
      ),
      replaced && h('p', { class: 'hint' }, 'This replaces the list of that name.'),
      error && h('p', { class: 'failure', role: 'alert' }, error),
      h(
        'div',
        { class: 'buttons' },
        h('button', { type: 'button', class: 'quiet', onClick: close }, 'Cancel'),
        h('button', { class: 'main', 'aria-disabled': busy, disabled: name.trim() === '' }, 'Save'),
      ),
    ),
  );
}

/** Chooses, saves, deletes, imports and exports lists. */
export function Lists({ list, onChange }) {
  const saved = useSavedLists();
  const [saving, setSaving] = useState(false);
  const attempt = (work) => work().catch((e) => note('error', e.message));
  const choose = (event) => {
    const chosen = saved.find((one) => one.name === event.target.value);
    onChange(chosen ?? { name: '' });
  };
  const remove = () =>
    attempt(async () => {
      await call('list-delete', { name: list.name });
      onChange({ name: '' });
    });
  const exportFile = () =>
    attempt(async () => {
      const { text } = await call('list-text', { period: list.period, names: list.names });
      download(`${list.name || 'Var_list'}.txt`, text);
    });
  const importFile = (event) => {
    const file = event.target.files[0];
    event.target.value = '';
    if (file) {
      attempt(async () => {
        if (file.size > MAX_BYTES) {
          throw new Error(`${file.name} has ${file.size} bytes; a list has at most ${MAX_BYTES}`);
        }
        const { period, names } = await call('list-parse', { text: await file.text() });
        if (names.length === 0) {
          throw new Error(`${file.name} has no variable; the list is unchanged`);
        }
        onChange({ name: '', period, names });
        note('done', `${names.length} variables from ${file.name}`);
      });
    }
  };
  const isSaved = saved.some((one) => one.name === list.name);
  return h(
    'div',
    { class: 'lists' },
    h(
      'select',
      { 'aria-label': 'List', value: isSaved ? list.name : '', onChange: choose },
      h('option', { value: '' }, 'This browser’s list'),
      saved.map((one) => h('option', { key: one.name, value: one.name }, one.name)),
    ),
    h(
      'select',
      {
        'aria-label': 'Period of the readings',
        value: list.period,
        onChange: (event) => onChange({ period: Number(event.target.value) }),
      },
      [...new Set([...PERIODS, list.period])]
        .sort((a, b) => a - b)
        .map((period) => h('option', { key: period, value: period }, `every ${period} ms`)),
    ),
    mayOperate() && h('button', { onClick: () => setSaving(true) }, 'Save …'),
    mayOperate() && isSaved && h('button', { onClick: remove }, 'Delete'),
    h(
      'label',
      { class: 'button' },
      'Import …',
      h('input', { type: 'file', accept: '.txt,text/plain', onChange: importFile }),
    ),
    h('button', { onClick: exportFile }, 'Export'),
    saving &&
      h(Save, {
        list,
        saved,
        onSaved: (name) => onChange({ name }),
        onClose: () => setSaving(false),
      }),
  );
}
