// Why does it not move? The server reads the causes one after the other.

import { h } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { onEvent, tell } from '../socket.js';
import { state, useSharedState, useStale } from '../state.js';

const MARKS = { ok: '✓', problem: '!', unknown: '?' };
const OLD = 5000; // ms

/** The last checks; the server computes them while this is visible. */
function useChecks() {
  const { socket } = useSharedState();
  const [event, setEvent] = useState(null);
  useEffect(() => {
    const robot = state.robot;
    const stop = onEvent('checks', (one) => one.robot === robot && setEvent(one));
    const look = () => tell('checks', { robot, on: !document.hidden });
    look();
    document.addEventListener('visibilitychange', look);
    return () => {
      stop();
      document.removeEventListener('visibilitychange', look);
      tell('checks', { robot, on: false });
    };
  }, [socket]);
  return event;
}

function Check({ check, isFirst }) {
  return h(
    'li',
    { class: `check ${check.state} ${isFirst ? 'first' : ''}` },
    h('span', { class: 'mark', 'aria-hidden': 'true' }, MARKS[check.state]),
    h(
      'div',
      null,
      h('strong', null, check.name),
      h('span', { class: 'unseen' }, `: ${check.state}`),
      h('span', { class: 'variable reading' }, check.read),
      check.advice && h('p', null, check.advice),
    ),
  );
}

/** Shows the checks, and the first problem above them. */
export function Checks() {
  const event = useChecks();
  const [open] = useState(() => matchMedia('(min-width: 1001px)').matches); // at first
  const checks = event?.checks ?? [];
  const first = checks.find((one) => one.state === 'problem');
  const unknown = checks.filter((one) => one.state === 'unknown').length;
  const old = useStale(() => event?.time, OLD);
  const moving = event?.moving && !old;
  const words = !event
    ? 'Reading …'
    : first && (old || !event.moving)
      ? `${old ? 'Not up to date. ' : ''}First problem: ${first.name}. ${first.advice}`
      : old
        ? 'Nothing can be said now: what was read is not up to date.'
        : event.moving
          ? 'The robot moves.'
          : unknown === checks.length
          ? 'Nothing could be checked.'
          : `No problem found${unknown ? `, but ${unknown} of ${checks.length} checks are unknown` : ''}. See the running line: the program may compute or wait.`;
  return h(
    'section',
    { class: `panel checks ${old ? 'stale' : ''}`, 'aria-label': 'Why does it not move?' },
    h('h2', null, 'Why does it not move?'),
    h('p', { class: `verdict ${old || !event ? 'old' : !moving && (first || unknown === checks.length) ? 'problem' : 'ok'}`, 'aria-live': 'polite' }, words),
    h(
      'details',
      { open },
      h('summary', null, 'All checks'),
      h(
        'ol',
        { class: 'check-list' },
        checks.map((one) => h(Check, { key: one.name, check: one, isFirst: one === first })),
      ),
    ),
  );
}
