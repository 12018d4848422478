// The frame of the page: header, navigation and the chosen view.

import { h, render } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { Boundary } from './boundary.js';
import { Header } from './header.js';
import { ReplayBar } from './replay-bar.js';
import { connect } from './socket.js';
import { ageOf, header, state, useSharedState, watchAges } from './state.js';

/** The views by their addresses: the title, and the module, which is loaded when needed. */
const VIEWS = {
  variables: ['Variables', () => import('./view/variables.js')],
  robot: ['3-D', () => import('./view/robot.js')],
  charts: ['Charts', () => import('./view/charts.js')],
  jog: ['Jog', () => import('./view/jog.js')],
  programs: ['Programs', () => import('./view/programs.js')],
  io: ['In/Out', () => import('./view/io.js')],
  teach: ['Teach', () => import('./view/teach.js')],
};

function currentView() {
  const name = location.hash.replace(/^#\/?/, '').split('/')[0];
  return Object.hasOwn(VIEWS, name) ? name : 'variables';
}

function Navigation({ view }) {
  return h(
    'nav',
    { class: 'navigation', 'aria-label': 'Views' },
    Object.entries(VIEWS).map(([name, [title]]) =>
      h(
        'a',
        { key: name, href: `#/${name}`, 'aria-current': name === view ? 'page' : undefined },
        title,
      ),
    ),
  );
}

function Notes() {
  const { notes } = useSharedState();
  return h(
    'div',
    { class: 'notes', role: 'status', 'aria-live': 'polite' },
    notes.map((one) => h('p', { class: `note ${one.kind}` }, one.text)),
  );
}

/** Shown on top of everything while the server, or its connection to the robot, is lost. */
function Connection() {
  const { socket } = useSharedState();
  if (socket === 'open') {
    const one = header();
    // a short loss is not shown
    return one.reason && one.connection !== 'connected' && ageOf(one) > 1000
      ? h('p', { class: 'banner lost', role: 'alert' }, `No connection to ${one.robot}: ${one.reason}`)
      : null;
  }
  const texts = {
    connecting: 'Connecting to the server …',
    lost: 'The connection to the server is lost. Nothing on this page is up to date. Trying again …',
    ended:
      "This browser has no session any more: it was sent away, or 'jopenshowvar web' was started" +
      ' again. Open the link that it has printed, or ask somebody with an open page for a link.',
  };
  return h('p', { class: `banner ${socket}`, role: 'alert' }, texts[socket]);
}

function App() {
  const shared = useSharedState();
  const [view, setView] = useState(currentView());
  const [Content, setContent] = useState(null);
  useEffect(() => {
    const follow = () => setView(currentView());
    addEventListener('hashchange', follow);
    return () => removeEventListener('hashchange', follow);
  }, []);
  useEffect(() => {
    let wanted = true;
    const [title, load] = VIEWS[view];
    document.title = `${title} – JOpenShowVar`;
    load().then((module) => wanted && setContent(() => module.View));
    return () => (wanted = false);
  }, [view]);
  return h(
    'div',
    { class: `frame ${shared.socket === 'open' ? '' : 'cut'} ${shared.replay ? 'replaying' : ''}` },
    h(Header),
    h(Connection),
    h(ReplayBar),
    h(Navigation, { view }),
    // another robot starts a new view
    h('main', { id: 'main' }, Content && state.robot && h(Boundary, { key: view + state.robot }, h(Content))),
    h(Notes),
  );
}

const theme = localStorage.getItem('theme');
if (theme) {
  document.documentElement.dataset.theme = theme;
}
render(h(App), document.getElementById('app'));
watchAges();
connect();
