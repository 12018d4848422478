// The line that is always at the top: robot, connection, mode, program, override, stop and lock.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { Access } from './access.js';
import { call } from './socket.js';
import {
  ageOf,
  chooseRobot,
  header,
  isStale,
  jogging,
  mayOperate,
  note,
  useSharedState,
} from './state.js';
import { percentText } from './value.js';

// without a prototype, since a robot may answer with any word
const MODES = { __proto__: null, '#T1': 'T1', '#T2': 'T2', '#AUT': 'AUT', '#EX': 'EXT' };
const PROGRAM_STATES = {
  __proto__: null,
  '#P_FREE': 'no program',
  '#P_RESET': 'at its start',
  '#P_ACTIVE': 'running',
  '#P_STOP': 'stopped',
  '#P_END': 'at its end',
};
const PROGRAM_KINDS = { __proto__: null, '#P_ACTIVE': 'good', '#P_STOP': 'warn' };

const STOPS = { __proto__: null, TRUE: 'message waits', FALSE: 'none' };

/** Renders the component several times a second, since ages grow without any event. */
function useTicks(period) {
  const [, setCount] = useState(0);
  useEffect(() => {
    const timer = setInterval(() => setCount((count) => count + 1), period);
    return () => clearInterval(timer);
  }, [period]);
}

function age(ms) {
  if (!Number.isFinite(ms)) {
    return 'no value yet';
  }
  return ms < 10_000 ? `${(ms / 1000).toFixed(1)} s old` : `${Math.round(ms / 1000)} s old`;
}

function Item({ name, kind = '', title, children }) {
  return h(
    'div',
    { class: `item ${kind}`, title },
    h('span', { class: 'name' }, name),
    h('span', { class: 'value' }, children),
  );
}

function Connection({ one, stale }) {
  const words =
    one.connection === 'connected' ? (stale ? 'stale' : 'live') : (one.connection ?? 'connecting');
  const detail =
    one.connection === 'connected' && !stale
      ? `${one.access_ms?.toFixed(1)} ms`
      : age(ageOf(one));
  return h(
    Item,
    { name: one.server || 'Server', kind: `connection ${stale ? 'bad' : 'good'}`, title: one.reason },
    h('span', { class: 'dot', 'aria-hidden': 'true' }),
    `${words} · ${detail}`,
  );
}

function Program({ name, program, programState }) {
  const words = PROGRAM_STATES[programState] ?? programState ?? '–';
  const kind = PROGRAM_KINDS[programState] ?? '';
  // a narrow page truncates the name, but not the state
  return program
    ? h(Item, { name, kind: `${kind} program` }, h('span', null, program), h('span', null, ` · ${words}`))
    : h(Item, { name, kind }, words);
}

function Padlock({ open }) {
  const line = { fill: 'none', stroke: 'currentColor', 'stroke-width': 2 };
  return h(
    'svg',
    { viewBox: '0 0 16 16', 'aria-hidden': 'true' },
    h('rect', { x: 2, y: 7, width: 12, height: 8, rx: 1.5, fill: 'currentColor' }),
    h('path', { d: open ? 'M4.5 7V4.5a3.5 3.5 0 0 1 6.8-1' : 'M4.5 7V4.5a3.5 3.5 0 0 1 7 0V7', ...line }),
  );
}

function Lock({ one }) {
  const [busy, setBusy] = useState(false);
  const lock = one.lock;
  if (!lock) {
    return null;
  }
  if (lock.read_only_by || !mayOperate()) {
    const reason = lock.read_only_by ?? 'this browser may only view';
    return h(Item, { name: 'Access', title: reason }, 'read-only');
  }
  const change = async () => {
    setBusy(true);
    try {
      await call('lock', { robot: one.robot, locked: lock.open });
    } catch (e) {
      note('error', e.message);
    }
    setBusy(false);
  };
  return h(
    'button',
    {
      class: `lock ${lock.open ? 'open' : ''}`,
      disabled: busy,
      'aria-pressed': String(lock.open),
      title: lock.open ? `Unlocked by ${lock.by}. Press to lock.` : 'Press to allow changes.',
      onClick: change,
    },
    h(Padlock, { open: lock.open }),
    lock.open ? 'Unlocked' : 'Locked',
  );
}

function Theme() {
  const root = document.documentElement;
  const dark = () =>
    root.dataset.theme
      ? root.dataset.theme === 'dark'
      : matchMedia('(prefers-color-scheme: dark)').matches;
  const change = () => {
    root.dataset.theme = dark() ? 'light' : 'dark';
    localStorage.setItem('theme', root.dataset.theme);
    dispatchEvent(new Event('themechange'));
  };
  return h(
    'button',
    { class: 'theme', 'aria-label': 'Light or dark', title: 'Light or dark', onClick: change },
    '◐',
  );
}

function LetIn() {
  const [open, setOpen] = useState(false);
  return [
    h(
      'button',
      {
        key: 'button',
        class: 'let-in-button',
        'aria-label': 'Let somebody in',
        title: 'Let somebody in',
        onClick: () => setOpen(true),
      },
      h(
        'svg',
        { viewBox: '0 0 16 16', 'aria-hidden': 'true' },
        h('circle', { cx: 6, cy: 4.5, r: 3, fill: 'currentColor' }),
        h('path', { d: 'M0.5 15a5.5 5.5 0 0 1 11 0z', fill: 'currentColor' }),
        h('path', {
          d: 'M13 3.5v5M10.5 6h5',
          fill: 'none',
          stroke: 'currentColor',
          'stroke-width': 1.6,
        }),
      ),
    ),
    open && h(Access, { key: 'dialog', onClose: () => setOpen(false) }),
  ];
}

function RobotName({ state, one }) {
  const robots = state.who.robots;
  if (robots.length > 1) {
    return h(
      'select',
      {
        class: 'robot',
        'aria-label': 'Robot',
        value: state.robot,
        onChange: (event) => chooseRobot(event.target.value),
      },
      robots.map((name) => h('option', { key: name, value: name }, name)),
    );
  }
  return h('strong', { class: 'robot' }, one.robot ?? '…');
}

/** Sets the height of the header in the style sheets, since other parts stick below it. */
function useHeight() {
  const element = useRef(null);
  useEffect(() => {
    const { style } = document.documentElement;
    const observer = new ResizeObserver(() =>
      style.setProperty('--top-height', `${element.current?.offsetHeight ?? 0}px`),
    );
    observer.observe(element.current);
    return () => observer.disconnect();
  }, []);
  return element;
}

export function Header() {
  const state = useSharedState();
  const element = useHeight();
  useTicks(250);
  const one = header();
  const stale = isStale(one);
  const { owner } = jogging();
  const mode = MODES[one.mode] ?? one.mode ?? '–';
  return h(
    'header',
    { class: `top ${stale ? 'stale' : ''}`, ref: element },
    h(
      'div',
      { class: 'identity' },
      h(RobotName, { state, one }),
      one.simulated && h('span', { class: 'badge' }, 'simulated'),
    ),
    h(
      'div',
      { class: 'items', 'aria-label': 'State of the robot' },
      h(Connection, { one, stale }),
      h(Item, { name: 'Mode', kind: `mode ${mode === 'T1' ? '' : 'warn'}` }, mode),
      h(Program, { name: 'Program', program: one.robot_program, programState: one.robot_state }),
      h(Program, { name: 'Submit', program: one.submit_program, programState: one.submit_state }),
      h(Item, { name: 'Override' }, percentText(one.override)),
      h(
        Item,
        { name: 'Stop', kind: one.stop === 'TRUE' ? 'bad' : '' },
        STOPS[one.stop] ?? '–',
      ),
      one.audit_failure &&
        h(
          Item,
          { name: 'Audit log', kind: 'bad', title: one.audit_failure },
          `cannot be written: ${one.audit_failure}`,
        ),
      owner && h(Item, { name: 'Jog', kind: 'warn' }, owner.id === state.who.id ? 'this page' : owner.name),
    ),
    h('div', { class: 'actions' }, h(Lock, { one }), h(LetIn), h(Theme)),
  );
}
