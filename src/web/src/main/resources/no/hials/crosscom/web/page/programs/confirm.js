// The dialog before a change: the robot, the effect of the change, and its warning.

import { h } from 'preact';
import { Dialog, useChange } from '../dialog.js';
import { header, mayWrite, note, state } from '../state.js';

/**
 * Asks before a change, and makes it.
 *
 * @param asked title, action (the word of the button), facts (names and texts), warning, work (makes
 *     the change and returns a message about it)
 */
export function Confirm({ asked, onClose }) {
  const { busy, error, close, make } = useChange(onClose);
  const submit = async (event) => {
    event.preventDefault();
    if (await make(async () => note('done', await asked.work()))) {
      onClose();
    }
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
        h('button', { class: 'main', 'aria-disabled': busy, disabled: !mayWrite() }, asked.action),
      ),
    ),
  );
}
