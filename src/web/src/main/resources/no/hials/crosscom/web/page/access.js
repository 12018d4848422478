// The dialog that lets others in: a link for a role, with a QR code for phones, and the browsers
// that have a session.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { Dialog } from './dialog.js';
import { call, onEvent } from './socket.js';
import { serverTime, state } from './state.js';

const ROLES = [
  ['VIEW', 'View: changes nothing'],
  ['OPERATE', 'Operate: writes, starts programs'],
  ['JOG', 'Jog: also moves robots'],
];
const ROLE_NAMES = { VIEW: 'view', OPERATE: 'operate', JOG: 'jog' };
const QUIET_ZONE = 4;

/** Draws a QR code from its rows; dark on light even on a dark page, as cameras expect. */
function Code({ rows }) {
  const size = rows.length + 2 * QUIET_ZONE;
  const path = rows.flatMap((row, y) =>
    [...row].map((one, x) =>
      one === '1' ? `M${x + QUIET_ZONE} ${y + QUIET_ZONE}h1v1h-1z` : '',
    ),
  );
  return h(
    'svg',
    {
      class: 'qr',
      viewBox: `0 0 ${size} ${size}`,
      role: 'img',
      'aria-label': 'The link as a QR code',
      'shape-rendering': 'crispEdges',
    },
    h('rect', { width: size, height: size, fill: '#fff' }),
    h('path', { d: path.join(''), fill: '#000' }),
  );
}

function Link({ made, onBack, onError }) {
  const field = useRef(null);
  const [copied, setCopied] = useState(false);
  const copy = async () => {
    field.current.select();
    try {
      await navigator.clipboard.writeText(made.link);
      setCopied(true);
    } catch {
      onError('The browser does not let pages copy. The link is selected: copy it from there.');
    }
  };
  return h(
    'div',
    { class: 'made' },
    h(Code, { rows: made.code }),
    h(
      'label',
      null,
      `Link for one browser that may ${ROLE_NAMES[made.role]}`,
      h('input', { ref: field, readOnly: true, value: made.link, class: 'link' }),
    ),
    h(
      'p',
      { class: 'hint', role: 'status' },
      made.used
        ? 'Somebody has come in by a link.'
        : `It works once, within ${made.minutes} minutes. Anybody who has it gets in.`,
    ),
    h(
      'div',
      { class: 'buttons' },
      h('button', { type: 'button', class: 'quiet', onClick: onBack }, 'Another link'),
      h('button', { type: 'button', class: 'main', onClick: copy }, copied ? 'Copied' : 'Copy'),
    ),
  );
}

function ago(time) {
  const minutes = Math.max(0, Math.floor((serverTime() - time) / 60_000));
  if (minutes < 1) {
    return 'just now';
  }
  return minutes < 120 ? `${minutes} min ago` : `${Math.floor(minutes / 60)} h ago`;
}

function Browsers({ browsers, onError }) {
  const [sending, setSending] = useState(null);
  const sendAway = async (one) => {
    setSending(null);
    try {
      await call('send_away', { browser: one.number });
    } catch (e) {
      onError(e.message);
    }
  };
  return h(
    'ul',
    { class: 'browsers' },
    browsers.map((one) =>
      h(
        'li',
        { key: one.number },
        h(
          'span',
          { class: 'who' },
          h('strong', null, one.name),
          one.own && ' – this one',
          h(
            'span',
            { class: 'hint' },
            [
              `may ${ROLE_NAMES[one.role]}`,
              one.pages > 0 ? 'page open' : 'no page open',
              `came ${ago(one.since)}`,
              `let in by ${one.by}`,
            ].join(' · '),
          ),
        ),
        !one.own &&
          one.may_send_away &&
          (sending === one.number
            ? h('button', { class: 'main', onClick: () => sendAway(one) }, 'Really send away')
            : h(
                'button',
                { 'aria-label': `Send ${one.name} away`, onClick: () => setSending(one.number) },
                'Send away',
              )),
      ),
    ),
  );
}

/** The addresses of the page, and the fingerprint that identifies this server. */
function Reach({ access }) {
  return [
    access.loopback &&
      h(
        'p',
        { key: 'loopback', class: 'hint warning' },
        'Only browsers on this computer reach this address. For a phone start the page with',
        ' ',
        h('code', null, 'jopenshowvar web --host ADDRESS --tls'),
        '.',
      ),
    access.fingerprint &&
      h(
        'p',
        { key: 'fingerprint', class: 'hint' },
        'A browser that warns of the certificate must show this SHA-256 fingerprint:',
        h(
          'code',
          { class: 'fingerprint' },
          access.fingerprint.match(/..:?/g).map((byte) => [byte, h('wbr')]),
        ),
      ),
  ];
}

/** Shows the dialog while it is rendered. */
export function Access({ onClose }) {
  const [access, setAccess] = useState(null);
  const [role, setRole] = useState('VIEW');
  const [name, setName] = useState('');
  const [address, setAddress] = useState('');
  const [made, setMade] = useState(null);
  const [error, setError] = useState('');
  useEffect(() => {
    const load = () =>
      call('browsers')
        .then((answer) => {
          setAccess(answer);
          setAddress((before) =>
            before || !answer.addresses.includes(location.origin)
              ? before || answer.addresses[0]
              : location.origin,
          );
        })
        .catch((e) => setError(e.message));
    load();
    return onEvent('browsers', load);
  }, []);
  const allowed = ROLES.slice(0, ROLES.findIndex(([one]) => one === state.who.role) + 1);
  const make = async (event) => {
    event.preventDefault();
    setError('');
    try {
      const last = Math.max(0, ...access.browsers.map((one) => one.number));
      setMade({ ...(await call('let_in', { role, name, address })), role, last });
    } catch (e) {
      setError(e.message);
    }
  };
  const used = made && access.browsers.some((one) => one.number > made.last);
  return h(
    Dialog,
    { title: 'Let somebody in', onClose },
    made
      ? h(Link, { made: { ...made, used }, onBack: () => setMade(null), onError: setError })
      : h(
          'form',
          { class: 'let-in', onSubmit: make },
          h(
            'label',
            null,
            'The other browser may',
            h(
              'select',
              { value: role, onChange: (event) => setRole(event.target.value) },
              allowed.map(([one, text]) => h('option', { key: one, value: one }, text)),
            ),
          ),
          h(
            'label',
            null,
            'Its name, for the list and the audit log (optional)',
            h('input', {
              value: name,
              maxLength: 40,
              autocomplete: 'off',
              onInput: (event) => setName(event.target.value),
            }),
          ),
          access?.addresses.length > 1 &&
            h(
              'label',
              null,
              'Address',
              h(
                'select',
                { value: address, onChange: (event) => setAddress(event.target.value) },
                access.addresses.map((one) => h('option', { key: one, value: one }, one)),
              ),
            ),
          h(
            'div',
            { class: 'buttons' },
            h('button', { class: 'main', disabled: !access }, 'Make a link'),
          ),
        ),
    error && h('p', { class: 'failure', role: 'alert' }, error),
    access && h(Reach, { access }),
    h('h3', null, 'Browsers that are in'),
    access && h(Browsers, { browsers: access.browsers, onError: setError }),
    h(
      'div',
      { class: 'buttons' },
      h('button', { type: 'button', class: 'quiet', onClick: onClose }, 'Close'),
    ),
  );
}
