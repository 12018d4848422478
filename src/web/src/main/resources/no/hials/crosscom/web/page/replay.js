// The replay of a recording: its numbers, and the player whose time all views follow.

import { useEffect, useState } from 'preact/hooks';
import { rowAt } from './charts/tracks.js';
import { changed, state } from './state.js';

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10];

/** The longest step of the player in s, so that the time does not jump after a hidden page. */
export const LONGEST_STEP = 0.5;

const TEXT_PERIOD = 100;

/** The numbers of a recording, by names such as $AXIS_ACT.A1; times are in s since its start. */
class Recording {
  isFixed = true;

  constructor(file, data) {
    const length = new DataView(data).getInt32(0, true);
    const head = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length)));
    const column = (i) => new Float64Array(data, 4 + length + 8 * head.rows * i, head.rows);
    this.file = file;
    this.start = head.start;
    this.texts = head.texts;
    this.times = column(0);
    this.end = head.rows;
    this.latest = this.times[head.rows - 1];
    this.units = new Map();
    this.columns = new Map();
    this.leavesOf = new Map();
    head.columns.forEach(({ name, unit }, i) => {
      this.columns.set(name, column(i + 1));
      this.units.set(name, unit);
      const variable = variableOf(name);
      if (!this.leavesOf.has(variable)) {
        this.leavesOf.set(variable, []);
      }
      this.leavesOf.get(variable).push(name);
    });
    this.names = [...this.leavesOf.keys()];
  }

  leaves(name) {
    return this.leavesOf.get(name) ?? [];
  }

  track(leaf) {
    const values = this.columns.get(leaf);
    return values && { times: this.times, values, first: 0, end: this.end };
  }

  /** Returns the structures at a time, by their names, as `watch` reads them. */
  readings(time) {
    const row = rowAt({ times: this.times, first: 0, end: this.end }, time);
    const result = Object.create(null); // a recording may name a column __proto__
    for (const [leaf, values] of this.columns) {
      const dot = leaf.indexOf('.');
      if (dot > 0 && row >= 0 && !Number.isNaN(values[row])) {
        const one = (result[leaf.slice(0, dot)] ??= { type: '', value: Object.create(null) });
        one.value[leaf.slice(dot + 1)] = values[row];
      }
    }
    return result;
  }
}

function variableOf(leaf) {
  return leaf.split(/[.[]/, 1)[0];
}

/** Plays a recording: a time in s since its start, which advances with the clock. */
class Player {
  time = 0;
  speed = 1;
  playing = false;
  listeners = new Set();

  constructor(recording) {
    this.recording = recording;
    this.end = recording.latest;
  }

  play() {
    if (this.time >= this.end) {
      this.time = 0;
    }
    this.playing = true;
    let before = performance.now();
    const step = (now) => {
      if (this.playing) {
        const passed = Math.max(0, Math.min(LONGEST_STEP, (now - before) / 1000));
        before = now;
        this.seek(this.time + passed * this.speed);
        if (this.time >= this.end) {
          this.pause();
        } else {
          requestAnimationFrame(step);
        }
      }
    };
    requestAnimationFrame(step);
    changed();
  }

  pause() {
    this.playing = false;
    changed();
  }

  seek(time) {
    this.time = Math.max(0, Math.min(this.end, time));
    this.listeners.forEach((listener) => listener());
  }

  /** Calls a function when the time has changed; returns a function that stops the calls. */
  follow(listener) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

/** Opens a recording of the server in all views. */
export async function openReplay(file) {
  const answer = await fetch(`/recordings/${encodeURIComponent(file)}/columns`);
  if (!answer.ok) {
    throw new Error((await answer.text()).trim());
  }
  closeReplay();
  state.replay = new Player(new Recording(file, await answer.arrayBuffer()));
  changed();
}

export function closeReplay() {
  if (state.replay) {
    state.replay.pause();
    state.replay.listeners.clear();
    state.replay = null;
    changed();
  }
}

/** Renders the component several times a second while the time changes. */
export function usePlayerTime(player) {
  const [, setTime] = useState(0);
  useEffect(() => {
    let timer;
    const stop = player?.follow(() => {
      timer ??= setTimeout(() => {
        timer = undefined;
        setTime(player.time);
      }, TEXT_PERIOD);
    });
    return () => {
      clearTimeout(timer);
      stop?.();
    };
  }, [player]);
}
