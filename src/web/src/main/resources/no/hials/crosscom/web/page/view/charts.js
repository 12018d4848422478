// The view of charts: variables over time and as paths, live or of a recording.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { lineColour, LINES, useColours } from '../charts/colours.js';
import { Lines, matches, MAX_ROWS } from '../charts/lines.js';
import { PlanePath, SpacePath } from '../charts/path-panel.js';
import { Recordings } from '../charts/recordings.js';
import { TimePanel } from '../charts/time-panel.js';
import { Tracks } from '../charts/tracks.js';
import { call, watch } from '../socket.js';
import { note, oldAfter, state, useSharedState, useStale } from '../state.js';
import { Search } from '../variables/search.js';

const SPANS = { 10: '10 s', 30: '30 s', 60: '1 min', 120: '2 min', 300: '5 min', 600: '10 min' };
const PERIODS = [10, 20, 50, 100, 250, 500, 1000, 5000];
const DEFAULT = { names: ['$POS_ACT', '$AXIS_ACT'], shown: new Map(), span: 30, period: 50, path: '' };
const PLANES = { XY: ['X', 'Y'], XZ: ['X', 'Z'], YZ: ['Y', 'Z'], XYZ: ['X', 'Y', 'Z'] };
const FRAME = 33; // ms between two pictures
const SHORT = 4; // ms of drawing in one frame
const TEXT_PERIOD = 200;
const SHORTEST = 0.02; // s
const SHARE = 0.02; // of the window: a step of the cursor by the keys
const MAX_FIRST = 4 * LINES; // lines of a unit that are drawn unless somebody chooses others
const MAX_PATHS = 50;
const MAX_UNITS = 1000; // as the server answers

/** The readings of each robot, which stay while another view is shown. */
const kept = new Map();

function stored() {
  try {
    const { names, shown, span, period, path } = JSON.parse(
      localStorage.getItem(`charts/${state.robot}`),
    );
    return {
      names: names.map(String),
      shown: new Map(Object.entries(shown ?? {})),
      span: Object.hasOwn(SPANS, span) ? Number(span) : DEFAULT.span,
      period: PERIODS.includes(period) ? period : DEFAULT.period,
      path: String(path),
    };
  } catch {
    return DEFAULT;
  }
}

/**
 * Returns the settings, which this browser keeps, and a function that replaces some of them: by
 * fields, or by a function from the settings to fields.
 */
function useSettings() {
  const [settings, setSettings] = useState(stored);
  const change = (fields) =>
    setSettings((old) => {
      const next = { ...old, ...(typeof fields === 'function' ? fields(old) : fields) };
      const saved = { ...next, shown: Object.fromEntries(next.shown) };
      localStorage.setItem(`charts/${state.robot}`, JSON.stringify(saved));
      return next;
    });
  return [settings, change];
}

/** Returns the units of numbers by their names; asks for those that are new. */
function useUnits(leaves) {
  const [units, setUnits] = useState(new Map());
  const missing = leaves.filter((leaf) => !units.has(leaf)).slice(0, MAX_UNITS);
  useEffect(() => {
    if (missing.length > 0) {
      call('units', { names: missing })
        .then((answer) => setUnits((old) => new Map([...old, ...Object.entries(answer.units)])))
        .catch((e) => note('error', e.message));
    }
  }, [missing.join('\n')]);
  return units;
}

/** Returns the numbers that are drawn by default: those with a unit, but not hundreds of lines. */
function firstChoice(leaves, units, names) {
  const result = new Set();
  const counts = new Map();
  for (const leaf of leaves) {
    const unit = units.get(leaf) ?? '';
    const count = counts.get(unit) ?? 0;
    if ((unit !== '' || !leaf.includes('.')) && count < MAX_FIRST && names.has(leaf.split(/[.[]/, 1)[0])) {
      result.add(leaf);
      counts.set(unit, count + 1);
    }
  }
  return result;
}

/** Returns the lines of each panel, by their unit. */
function panelsOf(leaves, units, isShown) {
  const panels = new Map();
  for (const leaf of leaves) {
    const unit = units.get(leaf);
    if (unit !== undefined && isShown(leaf)) {
      if (!panels.has(unit)) {
        panels.set(unit, []);
      }
      const lines = panels.get(unit);
      const dash = lines.length >= LINES ? [6, 3] : undefined;
      lines.push({ leaf, colour: lineColour(lines.length), dash });
    }
  }
  return panels;
}

/** The positions among some numbers: variables with X, Y and Z. */
function pathsOf(leaves) {
  const all = new Set(leaves);
  return leaves
    .filter((leaf) => leaf.endsWith('.X'))
    .map((leaf) => leaf.slice(0, -2))
    .filter((base) => all.has(`${base}.Y`) && all.has(`${base}.Z`));
}

/** The state of the drawing outside the components: source, window, cursor and panels. */
class Picture {
  frozen = null;

  /** Whether the live chart stands only because of the zoom, and not because of a pause. */
  frozenByZoom = false;

  zoomed = null;
  cursor = null;
  panels = new Set();
  waiting = new Set();

  constructor(changed) {
    this.changed = changed;
    this.tracks = kept.get(state.robot) ?? new Tracks();
    kept.set(state.robot, this.tracks);
    this.span = DEFAULT.span;
  }

  get player() {
    return state.replay;
  }

  get source() {
    return this.player?.recording ?? this.frozen ?? this.tracks;
  }

  /** Returns the times at the edges. */
  window() {
    if (this.zoomed) {
      return this.zoomed;
    }
    if (this.player) {
      return [0, Math.max(SHORTEST, this.player.end)];
    }
    const end = this.source.latest || Date.now() / 1000;
    return [end - this.span, end];
  }

  /** Returns the time of the numbers that are shown as text. */
  time() {
    return this.cursor ?? this.player?.time ?? this.source.latest;
  }

  freeze(value) {
    this.frozen = value ? this.tracks.copy() : null;
    this.frozenByZoom = false;
    if (!value) {
      this.zoomed = null;
    }
    this.draw();
    this.changed();
  }

  zoom(from, to) {
    if (to - from < SHORTEST) {
      return;
    }
    if (!this.player && !this.frozen) {
      this.frozen = this.tracks.copy();
      this.frozenByZoom = true;
    }
    this.zoomed = [from, to];
    this.draw();
    this.changed();
  }

  zoomBy(factor) {
    const [from, to] = this.window();
    const middle = this.cursor ?? (from + to) / 2;
    this.zoom(middle + (from - middle) * factor, middle + (to - middle) * factor);
  }

  reset() {
    if (this.frozenByZoom) {
      this.freeze(false);
    } else {
      this.zoomed = null;
      this.draw();
      this.changed();
    }
  }

  point(time) {
    this.cursor = time;
    this.changed();
  }

  choose(time) {
    this.player?.seek(time);
  }

  /** Schedules drawing the visible panels: at most 30 times a second, less often if it is slow. */
  draw() {
    this.waiting = new Set(this.panels);
    if (!this.asked) {
      this.asked = true;
      const wait = Math.max(0, (this.next ?? 0) - performance.now());
      setTimeout(() => requestAnimationFrame(() => this.frame()), wait);
    }
  }

  /** Draws some panels, and leaves the others for the next frame if that takes long. */
  frame() {
    const start = performance.now();
    const [from, to] = this.window();
    const mark = this.player ? this.player.time : null;
    for (const panel of this.waiting) {
      this.waiting.delete(panel);
      if (panel.place.isVisible) {
        panel.draw(this.source, from, to, mark);
        if (performance.now() - start > SHORT) {
          break;
        }
      }
    }
    this.used = (this.used ?? 0) + performance.now() - start;
    if (this.waiting.size > 0) {
      requestAnimationFrame(() => this.frame());
      return;
    }
    this.next = performance.now() + Math.max(FRAME - this.used, 2 * this.used);
    this.used = 0;
    this.asked = false;
  }
}

/** Returns the picture, fed by the robot or the player. */
function usePicture({ names, period, span }) {
  const [, setCount] = useState(0);
  const picture = useRef(null);
  const timer = useRef(undefined);
  picture.current ??= new Picture(() => {
    timer.current ??= setTimeout(() => {
      timer.current = undefined;
      setCount((count) => count + 1);
    }, TEXT_PERIOD);
  });
  const own = picture.current;
  const player = state.replay;
  own.span = span;
  useEffect(() => () => clearTimeout(timer.current), []);
  useEffect(() => {
    own.cursor = null;
    own.freeze(false);
    return player?.follow(() => {
      own.draw();
      own.changed();
    });
  }, [player]);
  useEffect(() => {
    own.tracks.keep(names);
    own.changed();
    return player
      ? undefined
      : watch(state.robot, 'charts', names, period, (event) => {
          own.tracks.add(event, period);
          own.draw();
          own.changed();
        });
  }, [names.join('\n'), period, player]);
  useEffect(() => own.draw(), [span]);
  useColours(() => own.panels.forEach((panel) => panel.redraw()));
  return own;
}

/** A panel that is drawn outside the components; `create` returns it, or a promise of it. */
function usePanel(picture, create, keys) {
  const element = useRef(null);
  const panel = useRef(null);
  const [failure, setFailure] = useState('');
  useEffect(() => {
    let wanted = true;
    setFailure('');
    Promise.resolve(create(element.current))
      .then((made) => {
        if (!wanted) {
          made.dispose();
          return;
        }
        panel.current = made;
        picture.panels.add(made);
        picture.draw();
      })
      .catch((e) => wanted && setFailure(e.message));
    return () => {
      wanted = false;
      picture.panels.delete(panel.current);
      panel.current?.dispose();
      panel.current = null;
    };
  }, keys);
  return [element, panel, failure];
}

function turnByKey(picture, event) {
  const [from, to] = picture.window();
  const step = { ArrowLeft: -SHARE, ArrowRight: SHARE }[event.key];
  if (event.ctrlKey || event.metaKey || event.altKey) {
    return;
  }
  if (step) {
    const at = picture.cursor ?? to;
    picture.point(Math.max(from, Math.min(to, at + step * (to - from))));
  } else if (event.key === '+' || event.key === '-') {
    picture.zoomBy(event.key === '+' ? 0.8 : 1.25);
  } else if (event.key === 'Escape') {
    picture.point(null);
    picture.reset();
  } else if (event.key === 'Enter' && picture.cursor !== null) {
    picture.choose(picture.cursor);
  } else {
    return;
  }
  event.preventDefault();
}

function TimeChart({ picture, unit, lines }) {
  const isLive = !state.replay;
  const [element] = usePanel(
    picture,
    (at) =>
      new TimePanel(at, lines, isLive, {
        zoom: (from, to) => picture.zoom(from, to),
        reset: () => picture.reset(),
        point: (time) => picture.point(time),
        choose: (time) => picture.choose(time),
      }),
    [isLive, ...lines.flatMap((line) => [line.leaf, line.colour])].join('\n').split('\0'),
  );
  const title = unit === '' ? 'without unit' : unit;
  return h(
    'figure',
    { class: 'chart' },
    h('figcaption', null, title),
    h('div', {
      class: 'plot',
      ref: element,
      role: 'img',
      tabIndex: 0,
      'aria-label': `Over time, ${title}: ${lines.map((line) => line.leaf).join(', ')}. The values are in the list of lines.`,
      'aria-describedby': 'chart-keys',
      onKeyDown: (event) => turnByKey(picture, event),
    }),
  );
}

function Path({ picture, base, plane }) {
  const leaves = PLANES[plane].map((axis) => `${base}.${axis}`);
  const [element, panel, failure] = usePanel(
    picture,
    (at) => (plane === 'XYZ' ? SpacePath.create(at, leaves) : new PlanePath(at, leaves)),
    [base, plane],
  );
  return h(
    'figure',
    { class: 'chart path' },
    h('figcaption', null, `${base}, ${plane}`, plane === 'XYZ' ? ': X red, Y green, Z blue' : ''),
    failure && h('p', { class: 'failure' }, `This browser cannot draw it: ${failure}`),
    h('div', {
      class: 'plot',
      key: plane,
      ref: element,
      role: 'img',
      tabIndex: 0,
      'aria-label': `Path of ${base}, ${plane}`,
      onKeyDown: (event) => panel.current?.turn?.(event.key) && event.preventDefault(),
    }),
  );
}

function Tools({ picture, settings, onChange, bases, filter }) {
  const { player } = picture;
  const isPaused = picture.frozen !== null;
  const isChosen = (base) => settings.path.startsWith(`${base} `);
  const path = bases.some(isChosen) ? settings.path : '';
  const found = bases.filter((base) => isChosen(base) || matches(base, filter));
  const listed = found.filter((base, i) => i < MAX_PATHS || isChosen(base));
  return h(
    'div',
    { class: 'chart-tools' },
    !player &&
      h(
        'button',
        {
          class: `pause ${isPaused ? 'main' : ''}`,
          'aria-pressed': String(isPaused),
          onClick: () => picture.freeze(!isPaused),
        },
        isPaused ? 'Resume' : 'Pause',
      ),
    !player &&
      h(
        'select',
        {
          'aria-label': 'Length of time',
          value: settings.span,
          onChange: (event) => onChange({ span: Number(event.target.value) }),
        },
        Object.entries(SPANS).map(([span, text]) => h('option', { key: span, value: span }, text)),
      ),
    !player &&
      h(
        'select',
        {
          'aria-label': 'Period of the readings',
          value: settings.period,
          onChange: (event) => onChange({ period: Number(event.target.value) }),
        },
        PERIODS.map((period) => h('option', { key: period, value: period }, `every ${period} ms`)),
      ),
    h(
      'select',
      {
        'aria-label': 'Path',
        value: path,
        onChange: (event) => onChange({ path: event.target.value }),
      },
      h('option', { value: '' }, 'No path'),
      listed.flatMap((base) =>
        Object.keys(PLANES).map((plane) =>
          h('option', { key: base + plane, value: `${base} ${plane}` }, `${base} ${plane}`),
        ),
      ),
      found.length > listed.length &&
        h('option', { disabled: true }, `${found.length - listed.length} more: filter the lines`),
    ),
    h(
      'span',
      { class: 'zoom', role: 'group', 'aria-label': 'Zoom' },
      h('button', { 'aria-label': 'Zoom in', onClick: () => picture.zoomBy(0.5) }, '+'),
      h('button', { 'aria-label': 'Zoom out', onClick: () => picture.zoomBy(2) }, '−'),
      h(
        'button',
        {
          'aria-label': 'Reset the zoom',
          disabled: !picture.zoomed,
          onClick: () => picture.reset(),
        },
        'Reset',
      ),
    ),
  );
}

export function View() {
  useSharedState();
  const [settings, change] = useSettings();
  const [filter, setFilter] = useState('');
  const picture = usePicture(settings);
  const { player } = picture;
  useEffect(() => setFilter(''), [player]);
  const names = player ? player.recording.names : settings.names;
  const leaves = [...new Set(names.flatMap((name) => picture.source.leaves(name)))];
  const asked = useUnits(player ? [] : leaves);
  const units = player ? player.recording.units : asked;
  // a recording may have more variables, for the 3-D view, than were chosen
  const chosen = settings.names.map((name) => name.split(/[.[]/, 1)[0]);
  const first = firstChoice(
    leaves,
    units,
    new Set(names.some((name) => chosen.includes(name)) ? chosen : names),
  );
  const panels = panelsOf(leaves, units, (leaf) => settings.shown.get(leaf) ?? first.has(leaf));
  const bases = pathsOf(leaves);
  const [base, plane] = settings.path.split(' ');
  const live = () => (picture.source.latest && !picture.source.isFixed ? picture.source.latest * 1000 : undefined);
  const stale = useStale(live, oldAfter(settings.period)) && !player;
  const add = (name) => {
    const key = name.toUpperCase();
    if (!settings.names.includes(key)) {
      change({ names: [...settings.names, key] });
    }
  };
  return h(
    'div',
    { class: 'charts' },
    h('h1', { class: 'unseen' }, 'Charts'),
    h(
      'div',
      { class: 'pictures' },
      h(
        'section',
        { class: 'panel', 'aria-label': 'Charts' },
        h(Tools, { picture, settings, onChange: change, bases, filter: leaves.length > MAX_ROWS ? filter : '' }),
        panels.size === 0 &&
          h(
            'p',
            { class: 'hint' },
            names.length === 0 ? 'Choose variables in the search to see them over time.' : 'Waiting for numbers …',
          ),
        h(
          'div',
          { class: stale ? 'old' : '' },
          [...panels].map(([unit, lines]) => h(TimeChart, { key: unit, picture, unit, lines })),
          bases.includes(base) && Object.hasOwn(PLANES, plane) && h(Path, { picture, base, plane }),
        ),
        h(
          'p',
          { class: 'hint', id: 'chart-keys' },
          'Drag or turn the wheel to zoom, double-click to reset; arrow keys, +, − and Escape.',
          player ? ' Click to go to a time.' : '',
        ),
      ),
      h(Recordings, { names: settings.names, period: settings.period }),
    ),
    h(
      'div',
      { class: 'choice' },
      h(Lines, {
        picture,
        names,
        leaves,
        units,
        panels,
        first,
        filter: leaves.length > MAX_ROWS ? filter : '',
        stale,
        onFilter: setFilter,
        onShow: (leaf, value) => change((old) => ({ shown: new Map(old.shown).set(leaf, value) })),
        onRemove: player ? null : (name) => change({ names: settings.names.filter((it) => it !== name) }),
      }),
      !player &&
        h(
          'details',
          { class: 'add' },
          h('summary', null, 'Add variables'),
          h(Search, { names: settings.names, onAdd: add }),
        ),
    ),
  );
}
