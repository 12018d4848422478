// The dialog that changes a variable: type and range, the new value, and a confirmation.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { Dialog, useChange } from '../dialog.js';
import { call } from '../socket.js';
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

/** Shown in place of an old value that the controller does not let the page read. */
const UNREADABLE = 'unreadable';

/** Asks for a new value, and then whether to write it. */
export function Edit({ name, onClose }) {
  const robot = useRobot();
  const [before, setBefore] = useState(null);
  const [value, setValue] = useState(null); // until the first reading, or the first key
  const [known, setKnown] = useState({ constants: [] });
  const [asked, setAsked] = useState(false);
  const [unread, setUnread] = useState('');
  const { busy, error, close, make } = useChange(onClose);
  const cancel = useRef(null);
  const field = useRef(null);
  useEffect(() => (asked ? cancel : field).current.focus(), [asked]);
  const read = () =>
    call('read', { robot, name })
      .then(({ text }) => {
        setBefore(text);
        return text;
      })
      .catch((e) => {
        // a variable that is only declared has no value until the first write
        setBefore(UNREADABLE);
        setUnread(`It has no value, or cannot be read: ${e.message}`);
        return null;
      });
  useEffect(() => {
    read().then((text) => setValue((typed) => typed ?? text));
    call('describe', { robot, name })
      .then((answer) => setKnown({ constants: [], ...answer }))
      .catch(() => {});
  }, [name]);
  const check = async () => {
    await call('check', { robot, name, value });
    await read();
  };
  const write = async () => {
    const fields = { robot, name, value, confirmed: true };
    const { text } = await call('write', fields);
    note('done', `${name} = ${text}`);
  };
  const submit = async (event) => {
    event.preventDefault();
    setUnread('');
    if (busy) {
      return;
    }
    if (!asked) {
      setAsked(await make(check));
    } else if (await make(write)) {
      onClose();
    } else {
      setAsked(false);
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
                ref: field,
                value: value ?? '',
                list: 'constants',
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
      (error || unread) && h('p', { class: 'failure', role: 'alert' }, error || unread),
      h(
        'div',
        { class: 'buttons' },
        h('button', { ref: cancel, type: 'button', class: 'quiet', onClick: close }, 'Cancel'),
        // a separate button, so that a double click on Continue does not write
        h(
          'button',
          {
            key: asked ? 'write' : 'continue',
            class: 'main',
            'aria-disabled': busy, // a disabled button would lose the focus
            disabled: before === null || !value?.trim(),
          },
          asked ? 'Write' : 'Continue',
        ),
      ),
    ),
  );
}
