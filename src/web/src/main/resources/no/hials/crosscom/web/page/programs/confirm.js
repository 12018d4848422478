// The dialog before a change: the robot, the effect of the change, and its warning.

import { h } from 'preact';
import { useRef, useState } from 'preact/hooks';
import { Dialog } from '../dialog.js';
import { withdraw } from '../socket.js';
import { header, mayWrite, note, state } from '../state.js';

/**
 * Asks before a change, and makes it.
 *
 * @param asked title, action (the word of the button), facts (names and texts), warning, work (makes
 *     the change and returns a message about it)
 */
export function Confirm({ asked, onClose }) {
  const [busy, setBusy] = useState(false);
  const [error, setError] = useState('');
  const closed = useRef(false);
  const close = () => {
    closed.current = true;
    if (busy) {
      withdraw();
    }
    onClose();
  };
  const submit = async (event) => {
    event.preventDefault();
    setBusy(true);
    setError('');
    try {
      note('done', await asked.work());
      if (!closed.current) {
        onClose();
      }
    } catch (e) {
      if (closed.current) {
        note('error', e.message);
      }
      setError(e.message);
    }
    setBusy(false);
  };
  const facts = [['Robot', `${state.robot}, mode ${header().mode ?? 'unknown'}`], ...asked.facts];
  return h(
    Dialog,
    { title: asked.title, onClose: close },
    h(
      'form',
      { onSubmit: submit },
      h(
        'dl',
        { class: 'change' },
        facts.map(([name, text]) => [h('dt', { key: name }, name), h('dd', null, text)]),
      ),
      asked.warning && h('p', { class: 'warning' }, asked.warning),
      asked.details,
      error && h('p', { class: 'failure', role: 'alert' }, error),
      h(
        'div',
        { class: 'buttons' },
        h('button', { type: 'button', class: 'quiet', autofocus: true, onClick: close }, 'Cancel'),
        h('button', { class: 'main', disabled: busy || !mayWrite() }, asked.action),
      ),
    ),
  );
}
