// The dialog that changes a variable: type and range, the new value, and a confirmation.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { Dialog } from '../dialog.js';
import { call, withdraw } from '../socket.js';
import { header, note, useRobot } from '../state.js';

function Facts({ entry, range, constants }) {
  const rows = [
    ['Type', [entry.type, entry.unit].filter((it) => it && it !== '-').join(', ')],
    ['Range of the type', range || constants.join(', ')],
    ['Meaning', entry.meaning],
    ['Declared in', entry.origin],
  ];
  return h(
    'dl',
    { class: 'change facts' },
    rows
      .filter(([, text]) => text)
      .map(([title, text]) => [h('dt', { key: title }, title), h('dd', null, text)]),
  );
}

/** Asks for a new value, and then whether to write it. */
export function Edit({ name, onClose }) {
  const robot = useRobot();
  const [before, setBefore] = useState(null);
  const [value, setValue] = useState('');
  const [known, setKnown] = useState({ constants: [] });
  const [asked, setAsked] = useState(false);
  const [error, setError] = useState('');
  const [busy, setBusy] = useState(false);
  const closed = useRef(false);
  const close = () => {
    closed.current = true;
    if (busy) {
      withdraw();
    }
    onClose();
  };
  useEffect(() => {
    call('read', { robot, name })
      .then(({ text }) => {
        setBefore(text);
        setValue(text);
      })
      .catch((e) => setError(e.message));
    call('describe', { robot, name })
      .then((answer) => setKnown({ constants: [], ...answer }))
      .catch(() => {});
  }, [name]);
  const attempt = async (work) => {
    setError('');
    setBusy(true);
    try {
      await work();
    } catch (e) {
      if (closed.current && asked) {
        note('error', e.message);
      }
      setAsked(false);
      setError(e.message);
    }
    setBusy(false);
  };
  const check = async () => {
    await call('check', { robot, name, value });
    setBefore((await call('read', { robot, name })).text);
    setAsked(true);
  };
  const write = async () => {
    const fields = { robot, name, value, confirmed: true };
    const { text } = await call('write', fields);
    note('done', `${name} = ${text}`);
    if (!closed.current) {
      onClose();
    }
  };
  const submit = (event) => {
    event.preventDefault();
    if (!busy) {
      attempt(asked ? write : check);
    }
  };
  const readOnly = known.entry?.access === 'RO';
  return h(
    Dialog,
    { title: asked ? `Write ${name}?` : `Change ${name}`, onClose: close },
    h(
      'form',
      { onSubmit: submit },
      asked
        ? h(
            'dl',
            { class: 'change' },
            h('dt', null, 'Robot'),
            h('dd', null, `${robot}, mode ${header().mode ?? 'unknown'}`),
            h('dt', null, 'Old'),
            h('dd', { class: 'variable' }, before),
            h('dt', null, 'New'),
            h('dd', { class: 'variable new' }, value),
          )
        : [
            known.entry && h(Facts, { key: 'facts', ...known }),
            h(
              'label',
              { key: 'value' },
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
                known.constants.map((one) => h('option', { key: one, value: one })),
              ),
            ),
            readOnly &&
              h('p', { key: 'access', class: 'hint' }, 'Controllers do not let clients write it.'),
          ],
      error && h('p', { class: 'failure', role: 'alert' }, error),
      h(
        'div',
        { class: 'buttons' },
        h('button', { type: 'button', class: 'quiet', onClick: close }, 'Cancel'),
        // a separate button, so that a double click on Continue does not write
        h(
          'button',
          {
            key: asked ? 'write' : 'continue',
            class: 'main',
            disabled: busy || before === null || value.trim() === '',
          },
          asked ? 'Write' : 'Continue',
        ),
      ),
    ),
  );
}
