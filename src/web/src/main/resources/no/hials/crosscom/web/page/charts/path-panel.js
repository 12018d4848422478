// The path of a position: two of its coordinates, or all three.

import uPlot from 'uplot';
import { colour } from './colours.js';
import { Place } from './place.js';
import { rowAt } from './tracks.js';
import { withRoom } from './time-panel.js';

const NEAREST = 0.5; // pixels between two points of a line

/** Returns the coordinates of a path between two times, and the row of a time or of the end. */
function coordinates(source, leaves, from, to, mark) {
  const tracks = leaves.map((leaf) => source.track(leaf));
  if (tracks.some((track) => !track)) {
    return null;
  }
  const [track] = tracks;
  const first = Math.max(track.first, rowAt(track, from) + 1);
  return { tracks, first, end: rowAt(track, to) + 1, at: rowAt(track, mark ?? to) };
}

/** Returns the least and the greatest number of some rows; null without numbers. */
function extent(values, first, end) {
  let least = Infinity;
  let greatest = -Infinity;
  for (let row = first; row < end; row++) {
    least = values[row] < least ? values[row] : least;
    greatest = values[row] > greatest ? values[row] : greatest;
  }
  return least <= greatest ? [least, greatest] : null;
}

/** Two coordinates, with the same scale on both axes. */
export class PlanePath {
  constructor(element, leaves) {
    this.element = element;
    this.leaves = leaves;
    this.shown = null;
    const axis = (leaf) => ({
      stroke: () => colour('--soft'),
      grid: { stroke: () => colour('--line'), width: 1 },
      ticks: { stroke: () => colour('--line'), width: 1 },
      font: '12px system-ui, sans-serif',
      labelFont: '12px system-ui, sans-serif',
      label: `${leaf.split('.').pop()} in mm`,
      labelSize: 18,
    });
    this.plot = new uPlot(
      {
        mode: 2,
        ...this.size(),
        legend: { show: false },
        cursor: { show: false },
        padding: [8, 12, 0, 0],
        scales: {
          x: { time: false, auto: false, range: () => this.ranges()[0] },
          y: { auto: false, range: () => this.ranges()[1] },
        },
        axes: [axis(leaves[0]), { ...axis(leaves[1]), size: 62 }],
        series: [null, { paths: () => null, facets: [{ scale: 'x' }, { scale: 'y' }] }],
        hooks: { draw: [(plot) => this.drawLine(plot)] },
      },
      [null, [[], []]],
      element,
    );
    this.place = new Place(element, (width, height) => {
      if (width !== this.plot.width || height !== this.plot.height) {
        this.plot.setSize({ width, height });
      }
    });
  }

  size() {
    return { width: this.element.clientWidth, height: this.element.clientHeight };
  }

  /** Returns the ranges of both axes, of the same length for each pixel. */
  ranges() {
    const ranges = [0, 1].map((i) => {
      const { tracks, first, end } = this.shown ?? { first: 0, end: 0 };
      return withRoom(...(extent(tracks?.[i].values ?? [], first, end) ?? []));
    });
    const { width, height } = this.plot?.bbox ?? { width: 1, height: 1 };
    const [perX, perY] = [(ranges[0][1] - ranges[0][0]) / width, (ranges[1][1] - ranges[1][0]) / height];
    const wider = ([least, greatest], factor) => {
      const middle = (least + greatest) / 2;
      const half = ((greatest - least) / 2) * factor;
      return [middle - half, middle + half];
    };
    return perX < perY
      ? [wider(ranges[0], perY / perX), ranges[1]]
      : [ranges[0], wider(ranges[1], perX / perY)];
  }

  drawLine(plot) {
    if (!this.shown) {
      return;
    }
    const { tracks, first, end, at } = this.shown;
    const [across, up] = tracks.map((track) => track.values);
    const { ctx } = plot;
    const { left, top, width, height } = plot.bbox;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.strokeStyle = colour('--line-0');
    ctx.lineWidth = 1.5 * devicePixelRatio;
    ctx.lineJoin = 'round';
    ctx.beginPath();
    let before = null;
    for (let row = first; row < end; row++) {
      if (Number.isNaN(across[row]) || Number.isNaN(up[row])) {
        before = null;
        continue;
      }
      const x = plot.valToPos(across[row], 'x', true);
      const y = plot.valToPos(up[row], 'y', true);
      if (before === null) {
        ctx.moveTo(x, y);
        before = [x, y];
      } else if (Math.hypot(x - before[0], y - before[1]) > NEAREST) {
        ctx.lineTo(x, y);
        before = [x, y];
      }
    }
    ctx.stroke();
    if (at >= first && !Number.isNaN(across[at])) {
      ctx.fillStyle = colour('--accent');
      ctx.beginPath();
      const [x, y] = [plot.valToPos(across[at], 'x', true), plot.valToPos(up[at], 'y', true)];
      ctx.arc(x, y, 4 * devicePixelRatio, 0, 2 * Math.PI);
      ctx.fill();
    }
    ctx.restore();
  }

  draw(source, from, to, mark) {
    this.shown = coordinates(source, this.leaves, from, to, mark);
    this.plot.batch(() => {
      this.plot.setScale('x', { min: 0, max: 1 }); // the ranges above replace these
      this.plot.setScale('y', { min: 0, max: 1 });
    });
    this.plot.redraw(false, true);
  }

  redraw() {
    this.plot.redraw(false, true);
  }

  dispose() {
    this.place.dispose();
    this.plot.destroy();
  }
}

/** All three coordinates, turned by the mouse, a finger or the arrow keys. */
export class SpacePath {
  /** Creates the panel; the library for 3-D is loaded when needed. */
  static async create(element, leaves) {
    const [three, { OrbitControls }] = await Promise.all([
      import('three'),
      import('three/orbit-controls'),
    ]);
    return new SpacePath(element, leaves, three, OrbitControls);
  }

  constructor(element, leaves, three, OrbitControls) {
    this.element = element;
    this.leaves = leaves;
    this.three = three;
    this.canvas = document.createElement('canvas');
    this.scale = document.createElement('span');
    this.scale.className = 'scale';
    element.append(this.canvas, this.scale);
    this.renderer = new three.WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene = new three.Scene();
    this.camera = new three.PerspectiveCamera(35, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(1.7, -1.9, 1.3);
    this.line = new three.Line(
      new three.BufferGeometry(),
      new three.LineBasicMaterial(),
    );
    this.line.frustumCulled = false;
    this.point = new three.Mesh(
      new three.SphereGeometry(0.02, 16, 12),
      new three.MeshBasicMaterial(),
    );
    this.box = new three.LineSegments(
      new three.EdgesGeometry(new three.BoxGeometry(1, 1, 1)),
      new three.LineBasicMaterial(),
    );
    this.axes = new three.AxesHelper(0.25);
    this.axes.setColors(0xe5484d, 0x30a46c, 0x3e7bfa);
    this.axes.position.set(-0.5, -0.5, -0.5);
    this.scene.add(this.line, this.point, this.box, this.axes);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener('change', () => this.render());
    this.place = new Place(element, (width, height) => this.resize(width, height));
    this.redraw();
  }

  resize(width, height) {
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  draw(source, from, to, mark) {
    const shown = coordinates(source, this.leaves, from, to, mark);
    this.line.visible = this.point.visible = false;
    if (shown) {
      const { tracks, first, end, at } = shown;
      const extents = tracks.map((track) => extent(track.values, first, end) ?? [0, 0]);
      const size = Math.max(1, ...extents.map(([least, greatest]) => greatest - least));
      const middles = extents.map(([least, greatest]) => (least + greatest) / 2);
      const coordinate = (i, row) => (tracks[i].values[row] - middles[i]) / size;
      const points = [];
      let before = null;
      for (let row = first; row < end; row++) {
        const point = [coordinate(0, row), coordinate(1, row), coordinate(2, row)];
        const moved = before && Math.hypot(...point.map((it, i) => it - before[i]));
        if (!point.some(Number.isNaN) && (before === null || moved > 0.002)) {
          points.push(...point);
          before = point;
        }
      }
      this.line.geometry.dispose();
      this.line.geometry = new this.three.BufferGeometry().setAttribute(
        'position',
        new this.three.Float32BufferAttribute(points, 3),
      );
      this.line.visible = points.length > 3;
      if (at >= first && !Number.isNaN(tracks[0].values[at])) {
        this.point.visible = true;
        this.point.position.set(coordinate(0, at), coordinate(1, at), coordinate(2, at));
      }
      this.scale.textContent = `Box: ${size.toPrecision(3)} mm wide`;
    }
    this.render();
  }

  /** Turns the picture by keys; returns whether the key was one of them. */
  turn(key) {
    const turns = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, -0.12], ArrowDown: [0, 0.12] };
    if (!turns[key]) {
      return false;
    }
    const [across, up] = turns[key];
    const { x, y, z } = this.camera.position;
    const length = Math.hypot(x, y, z);
    const round = Math.atan2(y, x) + across;
    const height = Math.max(-1.5, Math.min(1.5, Math.asin(z / length) - up));
    this.camera.position.set(
      length * Math.cos(height) * Math.cos(round),
      length * Math.cos(height) * Math.sin(round),
      length * Math.sin(height),
    );
    this.controls.update();
    this.render();
    return true;
  }

  render() {
    this.camera.lookAt(0, 0, 0);
    this.renderer.render(this.scene, this.camera);
  }

  redraw() {
    this.line.material.color.set(colour('--line-0'));
    this.point.material.color.set(colour('--accent'));
    this.box.material.color.set(colour('--line'));
    this.render();
  }

  dispose() {
    this.place.dispose();
    this.controls.dispose();
    this.scene.traverse((it) => {
      it.geometry?.dispose();
      it.material?.dispose();
    });
    this.renderer.dispose();
    this.renderer.forceContextLoss(); // browsers have few contexts, and free them late
    this.canvas.remove();
    this.scale.remove();
  }
}
