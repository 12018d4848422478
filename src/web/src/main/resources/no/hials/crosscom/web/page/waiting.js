// The text shown instead of a view until the robot answers.

import { h } from 'preact';
import { header, staleReason, useSharedState } from './state.js';

/** Shows that a view waits, and why. */
export function Waiting({ title }) {
  useSharedState();
  const why = staleReason(header());
  return h(
    'section',
    { class: 'panel' },
    h('h1', null, title),
    h('p', null, 'Asking for the robot …'),
    why && h('p', { class: 'failure', role: 'status' }, why),
  );
}
