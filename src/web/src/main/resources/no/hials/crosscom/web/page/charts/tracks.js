// The numbers of variables over time: those of live readings, which are kept for some minutes. A
// track is {times, values, first, end}: arrays of numbers, of which [first, end) is in use; NaN is
// a gap. Times are in s.

const MAX_SECONDS = 600;
const SMALLEST = 1024;
const LARGEST = 1e30; // the axes of charts end at 1E32
const LONGEST_SILENCE = 1; // s without a reading, which becomes a gap

/** Calls a function with each number within a value: its name and the number. */
function eachNumber(name, value, visit) {
  if (typeof value === 'number') {
    visit(name, value);
  } else if (typeof value === 'boolean') {
    visit(name, value ? 1 : 0);
  } else if (Array.isArray(value)) {
    const base = name.replace(/\[\]$/, '');
    value.forEach((one, i) => eachNumber(`${base}[${i + 1}]`, one, visit));
  } else if (value !== null && typeof value === 'object') {
    Object.entries(value).forEach(([field, one]) => eachNumber(`${name}.${field}`, one, visit));
  }
}

/** The numbers of one variable, which are read at the same times. */
class Variable {
  first = 0;
  end = 0;
  times = new Float64Array(SMALLEST);
  columns = new Map();

  /** Why the last reading failed; undefined if it did not. */
  error = undefined;

  add(time, name, value, longest) {
    if (this.end > this.first) {
      const last = this.times[this.end - 1];
      if (time <= last) {
        return; // a reading that arrived twice
      }
      if (time - last > longest) {
        this.next(last + 1e-3);
      }
    }
    const row = this.next(time);
    eachNumber(name, value, (leaf, number) => {
      this.column(leaf)[row] = number;
    });
  }

  /** Adds a row without values. */
  next(time) {
    while (this.first < this.end && time - this.times[this.first] > MAX_SECONDS + 5) {
      this.first++;
    }
    if (this.end === this.times.length) {
      this.makeRoom();
    }
    this.times[this.end] = time;
    for (const values of this.columns.values()) {
      values[this.end] = NaN;
    }
    return this.end++;
  }

  makeRoom() {
    const { first, end } = this;
    if (first > end / 2) {
      this.times.copyWithin(0, first, end);
      this.columns.forEach((values) => values.copyWithin(0, first, end));
      this.end -= first;
      this.first = 0;
      return;
    }
    const grown = (old) => {
      const result = new Float64Array(2 * old.length);
      result.set(old);
      return result;
    };
    this.times = grown(this.times);
    this.columns.forEach((values, leaf) => this.columns.set(leaf, grown(values)));
  }

  column(leaf) {
    let values = this.columns.get(leaf);
    if (!values) {
      values = new Float64Array(this.times.length).fill(NaN);
      this.columns.set(leaf, values);
    }
    return values;
  }

  copy() {
    const result = new Variable();
    result.times = this.times.slice(this.first, this.end);
    result.end = result.times.length;
    result.error = this.error;
    this.columns.forEach((values, leaf) =>
      result.columns.set(leaf, values.slice(this.first, this.end)),
    );
    return result;
  }
}

/** The live readings of a list of variables. */
export class Tracks {
  variables = new Map();

  /** The time of the last reading. */
  latest = 0;

  /** Whether no more readings are added. */
  isFixed = false;

  /** Adds an event of `watch`; one without values is a gap. */
  add(event, period) {
    const time = event.time / 1000;
    const longest = Math.max(LONGEST_SILENCE, (5 * period) / 1000);
    for (const [name, reading] of Object.entries(event.values)) {
      if (!this.variables.has(name)) {
        this.variables.set(name, new Variable());
      }
      const variable = this.variables.get(name);
      variable.add(time, name, reading.value ?? null, longest);
      variable.error = reading.error;
    }
    this.latest = Math.max(this.latest, time);
  }

  /** Forgets variables that are not in a list. */
  keep(names) {
    for (const name of this.variables.keys()) {
      if (!names.includes(name)) {
        this.variables.delete(name);
      }
    }
  }

  /** Returns the names of the numbers of a variable. */
  leaves(name) {
    return [...(this.variables.get(name)?.columns.keys() ?? [])];
  }

  /** Returns why the last reading of a variable failed; undefined if it did not. */
  error(name) {
    return this.variables.get(name)?.error;
  }

  /** Returns the track of a number; undefined if it was never read. */
  track(leaf) {
    for (const variable of this.variables.values()) {
      const values = variable.columns.get(leaf);
      if (values) {
        return { times: variable.times, values, first: variable.first, end: variable.end };
      }
    }
    return undefined;
  }

  /** Returns the numbers as they are now. */
  copy() {
    const result = new Tracks();
    result.latest = this.latest;
    result.isFixed = true;
    this.variables.forEach((variable, name) => result.variables.set(name, variable.copy()));
    return result;
  }
}

/** Returns the index of the last row that is not after a time; first - 1 if there is none. */
export function rowAt({ times, first, end }, time) {
  let low = first;
  let high = end;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low - 1;
}

/** Returns the number that a chart draws: one that is too large for an axis is at its end. */
export function drawn(value) {
  return Math.max(-LARGEST, Math.min(LARGEST, value));
}

/** Returns the number at a time: that of the last reading before it; NaN in a gap. */
export function valueAt(track, time) {
  const row = track ? rowAt(track, time) : -1;
  return row < (track?.first ?? 0) ? NaN : track.values[row];
}

/**
 * Returns the points that a chart draws of tracks between two times: an array of times, and one of each track
 * with null for a gap and undefined between readings. Many readings in one of the slots become
 * the least and the greatest of them.
 */
export function slots(tracks, from, to, count) {
  const width = (to - from) / count;
  // at multiples of the width, so that the same readings stay together while the window moves
  const start = Math.floor(from / width) - 1;
  const length = count + 3;
  const times = new Array(2 * length);
  for (let i = 0; i < length; i++) {
    times[2 * i] = (start + i + 0.25) * width;
    times[2 * i + 1] = (start + i + 0.75) * width;
  }
  return [times, ...tracks.map((track) => fill(track, start, width, length))];
}

function fill(track, start, width, length) {
  const result = new Array(2 * length).fill(undefined);
  if (!track) {
    return result;
  }
  const { times, values } = track;
  const last = (start + length) * width;
  let row = Math.max(track.first, rowAt(track, start * width));
  while (row < track.end && times[row] < last) {
    const slot = Math.floor(times[row] / width) - start;
    const slotEnd = (start + slot + 1) * width;
    let least = Infinity;
    let greatest = -Infinity;
    let leastRow = -1;
    let greatestRow = -1;
    let gapRow = -1;
    do {
      const value = drawn(values[row]);
      if (Number.isNaN(value)) {
        gapRow = row;
      } else {
        if (value < least) {
          least = value;
          leastRow = row;
        }
        if (value > greatest) {
          greatest = value;
          greatestRow = row;
        }
      }
      row++;
    } while (row < track.end && times[row] < slotEnd);
    if (slot < 0) {
      continue;
    }
    const i = 2 * slot;
    if (leastRow < 0) {
      result[i] = null;
    } else if (gapRow >= 0) {
      const after = gapRow > Math.max(leastRow, greatestRow);
      result[i] = after ? greatest : null;
      result[i + 1] = after ? null : greatest;
    } else if (leastRow === greatestRow) {
      result[i] = least;
    } else {
      result[i] = leastRow < greatestRow ? least : greatest;
      result[i + 1] = leastRow < greatestRow ? greatest : least;
    }
  }
  return result;
}
