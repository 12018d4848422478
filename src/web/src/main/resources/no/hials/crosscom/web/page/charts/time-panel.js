// A chart of some numbers of one unit over time.

import uPlot from 'uplot';
import { colour } from './colours.js';
import { Place } from './place.js';
import { drawn, slots } from './tracks.js';

const STEPS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600];
const MAX_SLOTS = 600;
const SLOT = 2; // pixels for the least and the greatest value
const ZOOM = 1.25;

/** Returns the time of day, with parts of a second if the steps are short. */
function clock(time, step) {
  const date = new Date(time * 1000);
  const two = (number) => String(number).padStart(2, '0');
  const seconds = `${two(date.getHours())}:${two(date.getMinutes())}:${two(date.getSeconds())}`;
  const digits = step < 0.01 ? 3 : step < 0.1 ? 2 : step < 1 ? 1 : 0;
  const part = String(date.getMilliseconds()).padStart(3, '0').slice(0, digits);
  return digits === 0 ? seconds : `${seconds}.${part}`;
}

/** Returns the range of an axis with some margin; a constant is in its middle. */
export function withRoom(least, greatest) {
  if (least === null || least === undefined) {
    return [0, 1];
  }
  const [low, high] = [drawn(least), drawn(greatest)];
  const range = high - low;
  const room = range > 1e-9 * Math.abs(high) ? 0.06 * range : Math.max(0.5, 0.02 * Math.abs(low));
  return [low - room, high + room];
}

export class TimePanel {
  /**
   * @param element the place of the chart
   * @param lines {leaf, colour, dash} of each number
   * @param isLive whether the times are those of a clock, or seconds
   * @param events zoom(from, to), reset(), point(time) with null for none, choose(time)
   */
  constructor(element, lines, isLive, events) {
    this.element = element;
    this.lines = lines;
    this.events = events;
    const axis = {
      stroke: () => colour('--soft'),
      grid: { stroke: () => colour('--line'), width: 1 },
      ticks: { stroke: () => colour('--line'), width: 1 },
      font: '12px system-ui, sans-serif',
    };
    this.plot = new uPlot(
      {
        ...this.size(),
        legend: { show: false },
        padding: [8, 34, 0, 0],
        scales: {
          x: { time: false, auto: false },
          y: { range: (plot, least, greatest) => withRoom(least, greatest) },
        },
        axes: [
          {
            ...axis,
            size: 32,
            incrs: STEPS,
            space: isLive ? 76 : 56,
            values: (plot, times) => {
              const step = times.length > 1 ? times[1] - times[0] : 1;
              return times.map((time) => (isLive ? clock(time, step) : `${Number(time.toFixed(3))} s`));
            },
          },
          { ...axis, size: 62 },
        ],
        series: [
          {},
          ...lines.map((line) => ({
            stroke: () => colour(line.colour),
            width: 1.5,
            dash: line.dash,
            points: { show: false },
          })),
        ],
        cursor: {
          y: false,
          points: { show: false },
          sync: { key: 'charts' },
          drag: { x: true, y: false, setScale: false },
          bind: { dblclick: () => () => events.reset() },
        },
        hooks: {
          setSelect: [(plot) => this.selected(plot)],
          setCursor: [(plot) => this.pointed(plot)],
          draw: [(plot) => this.drawMark(plot)],
        },
      },
      [[], ...lines.map(() => [])],
      element,
    );
    this.plot.over.addEventListener('wheel', (event) => this.wheeled(event), { passive: false });
    this.plot.over.addEventListener('click', (event) => this.clicked(event));
    this.plot.over.addEventListener('mouseleave', () => events.point(null));
    this.place = new Place(element, (width, height) => {
      if (width !== this.plot.width || height !== this.plot.height) {
        this.plot.setSize({ width, height });
      }
    });
  }

  size() {
    return { width: this.element.clientWidth, height: this.element.clientHeight };
  }

  selected(plot) {
    const { left, width } = plot.select;
    if (width > 4) {
      this.dragged = performance.now();
      this.events.zoom(plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x'));
    }
    if (width > 0) {
      plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    }
  }

  pointed(plot) {
    // the others follow this one, and report nothing
    if (plot.cursor.event) {
      const { left } = plot.cursor;
      this.events.point(left >= 0 ? plot.posToVal(left, 'x') : null);
    }
  }

  clicked(event) {
    if (!(performance.now() - this.dragged < 300)) {
      this.events.choose(this.plot.posToVal(event.offsetX, 'x'));
    }
  }

  wheeled(event) {
    event.preventDefault();
    const at = this.plot.posToVal(event.offsetX, 'x');
    const { min, max } = this.plot.scales.x;
    const factor = event.deltaY < 0 ? 1 / ZOOM : ZOOM;
    this.events.zoom(at + (min - at) * factor, at + (max - at) * factor);
  }

  drawMark(plot) {
    if (this.mark === null || this.mark === undefined) {
      return;
    }
    const x = Math.round(plot.valToPos(this.mark, 'x', true));
    const { left, top, width, height } = plot.bbox;
    if (x >= left && x <= left + width) {
      plot.ctx.save();
      plot.ctx.fillStyle = colour('--accent');
      plot.ctx.fillRect(x - 1, top, 2, height);
      plot.ctx.restore();
    }
  }

  /** Draws a source between two times, with a line at the time of the replay or null. */
  draw(source, from, to, mark) {
    this.mark = mark;
    const key = `${from} ${to} ${this.plot.width}`;
    if (source.isFixed && source === this.source && key === this.key) {
      this.plot.redraw(false, false); // only the mark has moved
      return;
    }
    this.source = source;
    this.key = key;
    const count = Math.max(50, Math.min(MAX_SLOTS, Math.round(this.plot.width / SLOT)));
    const data = slots(this.lines.map(({ leaf }) => source.track(leaf)), from, to, count);
    this.plot.batch(() => {
      this.plot.setData(data, false);
      this.plot.setScale('x', { min: from, max: to });
    });
  }

  /** Draws again in other colours. */
  redraw() {
    this.plot.redraw(false, true);
  }

  dispose() {
    this.place.dispose();
    this.plot.destroy();
  }
}
