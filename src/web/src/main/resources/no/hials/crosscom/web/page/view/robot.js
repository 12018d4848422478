// The view of the robot in 3-D, and the same as text: pose, axes and their limits.

import { h } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { LONGEST_STEP } from '../replay.js';
import { oldestTime, timed } from '../readings.js';
import { call, watch } from '../socket.js';
import { header, note, oldAfter, state, staleReason, useSharedState, useStale } from '../state.js';
import { numberText } from '../value.js';
import { Waiting } from '../waiting.js';

const AXES = ['A1', 'A2', 'A3', 'A4', 'A5', 'A6'];
const POSE = ['X', 'Y', 'Z', 'A', 'B', 'C'];
const FRAME_PERIOD = 500;
const TEXT_PERIOD = 150;
const NEAR = 10; // degrees before a limit
const AT = 0.1;
const SAME = 0.05; // degrees; a nearer target counts as reached
const STATES = { free: '', near: 'near its limit', at: 'at its limit' };
const VIEWS = { oblique: 'Oblique', front: 'Front', side: 'Side', top: 'Top' };

/** Returns whether an axis is 'free', 'near' or 'at' a limit. */
function limitOf({ minimum, maximum }, angle) {
  const left = Math.min(angle - minimum, maximum - angle);
  return left <= AT ? 'at' : left <= NEAR ? 'near' : 'free';
}

/** Returns a structure as read; null if there is none. */
function structure(values, name) {
  const value = values[name]?.value;
  return value !== null && typeof value === 'object' ? value : null;
}

/** Returns the axes if all of them are numbers; null if there is no such pose. */
function pose(values) {
  const axes = structure(values, '$AXIS_ACT');
  return axes && AXES.every((name) => Number.isFinite(axes[name])) ? axes : null;
}

/** Watches the robot live: calls a function with values by name. Returns a function to end it. */
function live(model, listener) {
  const period = header().simulated ? 20 : 50;
  const moving = ['$AXIS_ACT', '$POS_ACT', ...(model.target ? [model.target] : [])];
  const seen = (event) => event.missed || listener(timed(event));
  const stops = [
    watch(state.robot, '3d', moving, period, seen),
    watch(state.robot, '3d-frames', ['$BASE', '$TOOL'], FRAME_PERIOD, seen),
  ];
  return () => stops.forEach((stop) => stop());
}

/**
 * Follows the player of a recording, as `live` follows the robot.
 *
 * @param jumped called before the values of a time that does not follow the previous one
 */
function replayed(player, jumped, listener) {
  let before = player.time;
  const show = () => {
    if (player.time < before || player.time > before + LONGEST_STEP * player.speed) {
      jumped();
    }
    before = player.time;
    listener(player.recording.readings(player.time));
  };
  show();
  return player.follow(show);
}

/** Shows the model of the server; asks again with each connection: it may be another robot. */
function useModel() {
  const [model, setModel] = useState(null);
  const { socket } = useSharedState();
  const { connection, connections } = header();
  useEffect(() => {
    if (connection !== 'connected') {
      return undefined; // the robot cannot answer, and other commands would wait for it
    }
    let wanted = true;
    call('model', { robot: state.robot })
      .then((answer) => {
        if (wanted) {
          // the same robot keeps its picture and path
          setModel((old) => (JSON.stringify(old) === JSON.stringify(answer) ? old : answer));
        }
      })
      .catch((e) => wanted && note('error', e.message));
    return () => (wanted = false);
  }, [socket, connection, connections]);
  return model;
}

/** Loads the shapes of links from the folder of the server; `failed` is told of each that fails. */
async function loadShapes(scene, model, failed) {
  if (model.shapes.length === 0) {
    return;
  }
  const { readShape } = await import('../robot/shape.js');
  for (const link of model.shapes) {
    try {
      const answer = await fetch(`/shapes/${link}.stl`);
      if (!answer.ok) {
        throw new Error((await answer.text()).trim());
      }
      scene.setShape(link, readShape(await answer.arrayBuffer()));
    } catch (e) {
      failed(`${link}.stl is not shown: ${e.message}`); // the others are
    }
  }
}

/**
 * Draws the picture. The module is loaded when needed, since it is the largest of the page.
 *
 * @param latest the reference to the last values
 */
function usePicture(canvas, model, latest) {
  const picture = useRef(null);
  const [failure, setFailure] = useState('');
  const [unshown, setUnshown] = useState([]);
  useEffect(() => {
    setUnshown([]);
    if (!model) {
      return undefined;
    }
    let wanted = true;
    const theme = () => {
      const style = getComputedStyle(document.documentElement);
      const probe = document.createElement('i');
      document.body.append(probe);
      const colour = (name) => {
        probe.style.color = style.getPropertyValue(name);
        return getComputedStyle(probe).color;
      };
      picture.current?.setColours(colour('--line'), colour('--soft'));
      probe.remove();
    };
    const dark = matchMedia('(prefers-color-scheme: dark)');
    const observer = new MutationObserver(theme);
    import('../robot/scene.js')
      .then(({ RobotScene }) => {
        if (wanted) {
          picture.current = new RobotScene(canvas.current, model);
          theme();
          dark.addEventListener('change', theme);
          observer.observe(document.documentElement, { attributeFilter: ['data-theme'] });
          show(picture.current, model, latest.current);
          // not as notes, of which only a few are visible, and not for long
          const failed = (text) => wanted && setUnshown((old) => [...old, text]);
          loadShapes(picture.current, model, failed).catch((e) => failed(e.message));
        }
      })
      .catch((e) => wanted && setFailure(e.message));
    return () => {
      wanted = false;
      dark.removeEventListener('change', theme);
      observer.disconnect();
      picture.current?.dispose();
      picture.current = null;
    };
  }, [model]);
  return [picture, failure, unshown];
}

/** Shows values in the picture. */
function show(scene, model, values) {
  const axes = pose(values);
  if (!scene || !axes) {
    return;
  }
  scene.setFrames(structure(values, '$BASE'), structure(values, '$TOOL'));
  const angles = AXES.map((name) => axes[name]);
  const limits = angles.map((angle, i) => limitOf(model.axes[i], angle));
  const external = (one) => (Number.isFinite(one?.E1) ? one.E1 : 0);
  scene.move(angles, external(axes), limits);
  const target = structure(values, model.target);
  const aim = target && AXES.every((name) => Number.isFinite(target[name])) && AXES.map((name) => target[name]);
  const differs = aim && aim.some((angle, i) => Math.abs(angle - angles[i]) > SAME);
  scene.aim(differs ? aim : null, external(target));
}

function Axis({ name, axis, angle, target }) {
  const known = Number.isFinite(angle);
  const limit = known ? limitOf(axis, angle) : 'free';
  const part = (value) =>
    `${Math.max(0, Math.min(1, (value - axis.minimum) / (axis.maximum - axis.minimum))) * 100}%`;
  const differs = typeof target === 'number' && Math.abs(target - angle) > SAME;
  return h(
    'tr',
    { class: limit },
    h('th', { scope: 'row' }, name),
    h('td', { class: 'reading' }, numberText(angle, 2)),
    h(
      'td',
      null,
      h(
        'span',
        { class: 'range', title: `${axis.minimum} to ${axis.maximum}` },
        differs && h('span', { class: 'aim', style: { left: part(target) } }),
        known && h('span', { class: 'mark', style: { left: part(angle) } }),
      ),
    ),
    h('td', { class: 'ends' }, `${numberText(axis.minimum, 0)} … ${numberText(axis.maximum, 0)}`),
    h('td', { class: 'limit' }, STATES[limit]),
  );
}

/** The pose and the axes as text, also for screen readers. */
function Numbers({ model, values, stale }) {
  const tcp = structure(values, '$POS_ACT');
  const axes = structure(values, '$AXIS_ACT');
  const target = structure(values, model.target);
  const poseError = values.$POS_ACT?.error;
  return h(
    'div',
    { class: `numbers ${stale ? 'stale' : ''}` },
    h(
      'section',
      { class: 'panel', 'aria-label': 'Pose' },
      h('h2', null, 'TCP in $BASE'),
      poseError && h('p', { class: 'failure' }, poseError),
      h(
        'dl',
        { class: 'pose' },
        POSE.map((name, i) =>
          h(
            'div',
            { key: name },
            h('dt', null, name),
            h('dd', { class: 'reading' }, numberText(tcp?.[name], i < 3 ? 1 : 2)),
            h('dd', { class: 'unit' }, i < 3 ? 'mm' : '°'),
          ),
        ),
      ),
    ),
    h(
      'section',
      { class: 'panel', 'aria-label': 'Axes' },
      h('h2', null, 'Axes'),
      h(
        'table',
        { class: 'axes' },
        h(
          'thead',
          { class: 'unseen' },
          h('tr', null, ['Axis', 'Degrees', 'In its range', 'Limits', 'State'].map((it) =>
            h('th', { scope: 'col' }, it))),
        ),
        h(
          'tbody',
          null,
          AXES.map((name, i) =>
            h(Axis, {
              key: name,
              name,
              axis: model.axes[i],
              angle: axes?.[name],
              target: target?.[name],
            }),
          ),
          model.rail &&
            h(Axis, { name: 'E1', axis: model.rail, angle: axes?.E1, target: target?.E1 }),
        ),
      ),
    ),
  );
}

/** Returns why the picture is not current; an empty text if it is. */
function missing(player, values) {
  if (player === null) {
    const axes = values.$AXIS_ACT;
    return axes === undefined || pose(values) ? '' : `No axes: ${axes.error ?? '$AXIS_ACT has other values'}`;
  }
  if (!player.recording.track('$AXIS_ACT.A1')) {
    return 'The recording has no $AXIS_ACT';
  }
  return pose(values) ? '' : 'No values at this time';
}

export function View() {
  const model = useModel();
  const player = useSharedState().replay;
  const canvas = useRef(null);
  const latest = useRef({});
  const [values, setValues] = useState({});
  const [withPath, setWithPath] = useState(true);
  const [picture, failure, unshown] = usePicture(canvas, model, latest);
  useEffect(() => {
    if (!model) {
      return undefined;
    }
    let timer;
    latest.current = {};
    picture.current?.clearPath();
    setValues({});
    const source = (follow) =>
      player
        ? replayed(player, () => picture.current?.clearPath(), follow)
        : live(model, follow);
    const stop = source((changes) => {
      latest.current = player ? changes : Object.assign(latest.current, changes);
      show(picture.current, model, latest.current);
      // nobody can read numbers as fast as the picture changes
      timer ??= setTimeout(() => {
        timer = undefined;
        setValues({ ...latest.current });
      }, TEXT_PERIOD);
    });
    return () => {
      clearTimeout(timer);
      stop();
    };
  }, [model, player]);
  const stale = useStale(() => oldestTime(values), oldAfter(FRAME_PERIOD)) && player === null;
  if (!model) {
    return h(Waiting, { title: '3-D' });
  }
  const without = missing(player, values);
  const scene = (work) => () => picture.current && work(picture.current);
  return h(
    'div',
    { class: 'robot-view' },
    h(
      'section',
      { class: 'panel picture', 'aria-label': 'Picture of the robot' },
      h(
        'div',
        { class: 'tools' },
        h('h1', null, model.name),
        h(
          'div',
          { class: 'views', role: 'group', 'aria-label': 'Views' },
          Object.entries(VIEWS).map(([name, title]) =>
            h('button', { key: name, onClick: scene((it) => it.see(name)) }, title),
          ),
        ),
        h(
          'label',
          { class: 'switch' },
          h('input', {
            type: 'checkbox',
            checked: withPath,
            onChange: (event) => {
              setWithPath(event.target.checked);
              picture.current?.showPath(event.target.checked);
            },
          }),
          'Path',
        ),
        h('button', { onClick: scene((it) => it.clearPath()) }, 'Clear path'),
      ),
      model.note && h('p', { class: 'hint guess' }, `Not this robot: ${model.note}.`),
      h(
        'div',
        {
          class: `stage ${stale || without ? 'old' : ''} ${player ? 'recorded' : ''}`,
          hidden: failure !== '',
        },
        h('canvas', {
          ref: canvas,
          tabIndex: 0,
          role: 'img',
          'aria-label': `${model.name} in 3-D. Its pose and its axes are in the tables that follow.`,
          'aria-describedby': 'picture-keys',
          onKeyDown: (event) => turnByKey(picture.current, event),
        }),
        stale && h('p', { class: 'old-mark' }, `Not up to date. ${staleReason(header())}`.trim()),
        player && h('p', { class: 'replay-mark' }, 'Recording, not the robot'),
        !stale && without && h('p', { class: 'old-mark' }, without),
      ),
      failure &&
        h('p', { class: 'failure' }, `This browser cannot draw the robot: ${failure}`),
      h(
        'p',
        { class: 'legend', id: 'picture-keys' },
        h('span', { class: 'key near' }, `within ${NEAR}° of a limit`),
        h('span', { class: 'key at' }, 'at a limit'),
        model.target && h('span', { class: 'key target' }, `target, ${model.target}`),
        h('span', { class: 'key path' }, 'path of the tool'),
        h('span', { class: 'keys' }, 'Drag to turn, two fingers or the wheel to zoom; arrow keys, + and −.'),
      ),
      h(
        'div',
        { class: 'unshown', role: 'status' },
        unshown.map((text) => h('p', { key: text, class: 'failure' }, text)),
      ),
    ),
    h(Numbers, { model, values, stale }),
  );
}

function turnByKey(scene, event) {
  const turns = {
    ArrowLeft: [-0.12, 0, 1],
    ArrowRight: [0.12, 0, 1],
    ArrowUp: [0, 0.12, 1],
    ArrowDown: [0, -0.12, 1],
    '+': [0, 0, 0.88],
    '-': [0, 0, 1 / 0.88],
  };
  if (scene && turns[event.key] && !event.ctrlKey && !event.metaKey && !event.altKey) {
    event.preventDefault();
    scene.orbit(...turns[event.key]);
  }
}
