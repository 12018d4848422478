// Who jogs the robot: one page at a time, and the question of another page.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { call } from '../socket.js';
import { jogging, note, state } from '../state.js';

/** Sends a command for the chosen robot and shows why it was refused. */
export async function jog(name, fields = {}) {
  try {
    return await call(`jog-${name}`, { robot: state.robot, ...fields });
  } catch (e) {
    note('error', e.message);
    return null;
  }
}

/** Returns whether this page has the robot. */
export function isMine() {
  return jogging().owner?.id === state.who.id;
}

/** Returns the remaining time for an answer in s, which passes without events. */
function useSecondsLeft({ asker, answer_ms }) {
  const [end, setEnd] = useState(0);
  const [now, setNow] = useState(0);
  useEffect(() => {
    setEnd(performance.now() + answer_ms);
    setNow(performance.now());
    if (asker) {
      const timer = setInterval(() => setNow(performance.now()), 250);
      return () => clearInterval(timer);
    }
    return undefined;
  }, [asker?.id, answer_ms]);
  return Math.ceil((end - now) / 1000);
}

/** The owner for people, and what this page can do about it. */
export function Owner() {
  const { owner, asker } = jogging();
  const left = useSecondsLeft(jogging());
  const asked = asker && left > 0;
  if (isMine() && asked) {
    const answer = (yes) => jog('answer', { to: asker.id, yes });
    return h(
      'section',
      { class: 'panel question', role: 'alertdialog', 'aria-label': 'Question of another page' },
      h('p', null, `${asker.name} asks for this robot. Without an answer you keep it.`),
      h(
        'div',
        { class: 'buttons' },
        h('button', { onClick: () => answer(true) }, 'Hand over'),
        h('button', { class: 'main', onClick: () => answer(false) }, `Keep (${left} s)`),
      ),
    );
  }
  if (!owner || isMine()) {
    return null;
  }
  return h(
    'section',
    { class: 'panel question', 'aria-label': 'Another page jogs' },
    h('p', { role: 'status' }, asked && asker.id === state.who.id ? `${owner.name} is asked (${left} s) …` : `${owner.name} jogs this robot.`),
    state.who.role === 'JOG' &&
      h(
        'div',
        { class: 'buttons' },
        h('button', { disabled: Boolean(asked), onClick: () => jog('ask') }, 'Ask to take over'),
      ),
  );
}
