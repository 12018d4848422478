// The picture of a robot: arm, target, frames, path and floor. It is drawn only when
// something has changed. Z is up, lengths are in mm, and the origin is that of the world.

import {
  AmbientLight,
  BoxGeometry,
  CanvasTexture,
  Color,
  ConeGeometry,
  CylinderGeometry,
  DirectionalLight,
  DynamicDrawUsage,
  GridHelper,
  Group,
  HemisphereLight,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PCFSoftShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  Quaternion,
  Scene,
  ShadowMaterial,
  Spherical,
  Sprite,
  SpriteMaterial,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/orbit-controls';
import { Arm, place } from './arm.js';

const MAX_SEGMENTS = 2000;
const UP = new Vector3(0, 1, 0);
const TURN_MILLIS = 350;

/** Directions from which the robot is seen: x, y, z. */
const VIEWS = {
  oblique: [1, -0.95, 0.62],
  front: [1, 0, 0],
  side: [0, -1, 0],
  top: [0, -1e-3, 1],
};

/** Kinds of pictures, the best one first; the next one is tried while drawing is slow. */
const QUALITIES = [
  { ratio: 2, shadows: true },
  { ratio: 1, shadows: true },
  { ratio: 1, shadows: false },
  { ratio: 0.75, shadows: false },
];
const SLOW = 32; // ms
const STILL = 400; // ms without a change until the best picture is drawn
const WAITING = -1;

const reduced = matchMedia('(prefers-reduced-motion: reduce)');

export class RobotScene {
  /**
   * @param canvas where it is drawn
   * @throws Error if the browser cannot draw in 3-D
   */
  constructor(canvas, model) {
    this.model = model;
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFSoftShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    const { a1, a2, c1, c2, c3, c4 } = model.lengths;
    this.reach = a1 + c2 + Math.hypot(a2, c3) + c4;
    this.height = c1 + 0.14 * this.reach;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, this.reach / 40, this.reach * 40);
    this.camera.up.set(0, 0, 1);
    this.foot = new Group();
    this.arm = new Arm(model);
    this.ghost = new Arm(model, 0x2f9bff);
    this.ghost.root.visible = false;
    this.ghost.bodies.get('base').visible = false;
    this.foot.add(this.arm.root);
    this.ghostFoot = new Group().add(this.ghost.root);
    this.scene.add(this.foot, this.ghostFoot);
    this.addLight();
    this.quality = 0;
    this.addFrames();
    this.addPath();
    if (model.rail) {
      this.addRail();
    }
    for (const foot of [this.foot, this.ghostFoot]) {
      place(foot, model.rail ? model.rail.from : model.root);
    }
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.minDistance = this.reach * 0.3;
    this.controls.maxDistance = this.reach * 12;
    this.controls.enableDamping = !reduced.matches;
    this.controls.dampingFactor = 0.15;
    this.controls.addEventListener('change', () => this.redraw());
    this.see('oblique', true);
    this.resized = new ResizeObserver(() => this.resize());
    this.resized.observe(canvas.parentElement);
    this.resize();
  }

  addLight() {
    const sun = new DirectionalLight(0xffffff, 2.4);
    sun.position.set(0.7 * this.reach, -1.2 * this.reach, 2.6 * this.reach);
    sun.castShadow = true;
    sun.shadow.mapSize.set(1024, 1024);
    sun.shadow.radius = 4;
    sun.shadow.normalBias = this.reach / 300;
    const wide = 1.5 * this.reach;
    Object.assign(sun.shadow.camera, {
      left: -wide,
      right: wide,
      top: wide,
      bottom: -wide,
      near: this.reach / 10,
      far: 6 * this.reach,
    });
    const fill = new DirectionalLight(0xdfe8ff, 0.9);
    fill.position.set(-this.reach, this.reach, this.reach);
    this.sun = sun;
    this.foot.add(sun, sun.target);
    const sky = new HemisphereLight(0xffffff, 0x8a8f99, 1.1);
    sky.position.set(0, 0, 1);
    this.scene.add(fill, sky, new AmbientLight(0xffffff, 0.35));
    this.floor = new Group();
    this.shade = new Mesh(
      new PlaneGeometry(8 * this.reach, 8 * this.reach),
      new ShadowMaterial({ opacity: 0.22 }),
    );
    this.shade.receiveShadow = true;
    this.floor.add(this.shade);
    this.scene.add(this.floor);
  }

  /** Draws the floor in the colours of the page. */
  setColours(line, text) {
    if (this.grid) {
      this.floor.remove(this.grid);
      this.grid.dispose();
    }
    const cell = this.reach > 1500 ? 500 : 250;
    const cells = 2 * Math.ceil((1.5 * this.reach) / cell);
    this.grid = new GridHelper(cells * cell, cells, new Color(text), new Color(line));
    this.grid.material.transparent = true;
    this.grid.material.opacity = 0.55;
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.z = -this.reach / 2000;
    this.floor.add(this.grid);
    this.redraw();
  }

  addFrames() {
    const size = 0.17 * this.reach;
    this.base = frame(size, 'BASE');
    this.tool = frame(size, 'TOOL');
    this.base.visible = false;
    this.shaft = new Mesh(
      new CylinderGeometry(1, 1, 1, 16),
      new MeshStandardMaterial({ color: 0x8d96a3, roughness: 0.5 }),
    );
    this.shaft.visible = false;
    this.arm.flange.add(this.shaft, this.tool);
    this.scene.add(this.base);
  }

  addPath() {
    const radius = this.reach / 320;
    this.path = new InstancedMesh(
      new CylinderGeometry(radius, radius, 1, 6, 1, true),
      new MeshBasicMaterial({ color: 0x12a594 }),
      MAX_SEGMENTS,
    );
    this.path.instanceMatrix.setUsage(DynamicDrawUsage);
    this.path.frustumCulled = false;
    this.scene.add(this.path);
    this.clearPath();
  }

  addRail() {
    const { from, to } = this.model.rail;
    const start = new Vector3(from.X, from.Y, from.Z);
    const way = new Vector3(to.X, to.Y, to.Z).sub(start);
    const length = way.length() + 0.6 * this.reach;
    const width = 0.36 * this.reach;
    const rail = new Group();
    const height = 0.07 * this.reach;
    const body = new MeshStandardMaterial({ color: 0x7d8692, roughness: 0.7 });
    const track = new MeshStandardMaterial({ color: 0x3a3f47, roughness: 0.5 });
    const box = (x, y, z, material) => {
      const mesh = new Mesh(new BoxGeometry(x, y, z), material);
      mesh.castShadow = true;
      mesh.receiveShadow = true;
      rail.add(mesh);
      return mesh;
    };
    box(length, width, height, body).position.z = -height / 2 - 1;
    for (const side of [-1, 1]) {
      box(length, 0.05 * width, 0.2 * height, track).position.set(0, side * 0.42 * width, 0);
    }
    rail.position.copy(start).addScaledVector(way, 0.5);
    rail.quaternion.setFromUnitVectors(new Vector3(1, 0, 0), way.clone().normalize());
    this.scene.add(rail);
  }

  /**
   * Moves the robot.
   *
   * @param angles A1 to A6 in degrees
   * @param external E1
   * @param limits 'free', 'near' or 'at' for each axis
   */
  move(angles, external, limits) {
    const key = `${angles.map((it) => it.toFixed(3))} ${external} ${limits}`;
    if (key === this.moved) {
      return;
    }
    this.moved = key;
    this.arm.angles = angles;
    this.arm.move(angles);
    limits.forEach((state, axis) => this.arm.showLimit(axis, state));
    this.placeFoot(this.foot, external);
    this.follow();
    this.renderer.shadowMap.needsUpdate = true;
    this.redraw();
  }

  placeFoot(foot, external) {
    const { rail } = this.model;
    if (rail) {
      const part = (external - rail.minimum) / (rail.maximum - rail.minimum);
      for (const axis of ['x', 'y', 'z']) {
        const name = axis.toUpperCase();
        foot.position[axis] = rail.from[name] + part * (rail.to[name] - rail.from[name]);
      }
    }
  }

  /** Shows the target of the axes and E1; null for no target. */
  aim(angles, external) {
    const key = `${angles} ${external}`;
    if (key !== this.aimed) {
      this.aimed = key;
      this.ghost.root.visible = angles !== null;
      if (angles) {
        this.ghost.move(angles);
        this.placeFoot(this.ghostFoot, external);
      }
      this.redraw();
    }
  }

  /** Shows the frames $BASE and $TOOL; null for an unknown frame. */
  setFrames(base, tool) {
    const key = JSON.stringify([base, tool]);
    if (key === this.framed) {
      return;
    }
    this.framed = key;
    this.base.visible = base !== null;
    if (base) {
      place(this.base, base);
    }
    place(this.tool, tool ?? { X: 0, Y: 0, Z: 0, A: 0, B: 0, C: 0 });
    const length = this.tool.position.length();
    this.shaft.visible = length > 1 && !this.hasToolShape;
    if (this.shaft.visible) {
      const radius = this.reach / 110;
      this.shaft.scale.set(radius, length, radius);
      this.shaft.position.copy(this.tool.position).multiplyScalar(0.5);
      this.shaft.quaternion.setFromUnitVectors(UP, this.tool.position.clone().normalize());
    }
    this.breakPath();
    this.renderer.shadowMap.needsUpdate = true;
    this.redraw();
  }

  /** Returns the TCP in the world, mm. */
  tcp() {
    this.tool.updateWorldMatrix(true, false);
    return new Vector3().setFromMatrixPosition(this.tool.matrixWorld);
  }

  follow() {
    const end = this.tcp();
    const start = this.end;
    if (!start) {
      this.end = end;
      return;
    }
    const way = end.clone().sub(start);
    const length = way.length();
    if (length < this.reach / 500) {
      return;
    }
    if (length > this.reach / 4) {
      this.end = end; // readings are missing, so the path in between is unknown
      return;
    }
    const turn = new Quaternion().setFromUnitVectors(UP, way.divideScalar(length));
    const middle = start.clone().add(end).multiplyScalar(0.5);
    const matrix = new Matrix4().compose(middle, turn, new Vector3(1, length, 1));
    this.path.setMatrixAt(this.segments % MAX_SEGMENTS, matrix); // replaces the oldest segment
    this.segments++;
    this.path.count = Math.min(this.segments, MAX_SEGMENTS);
    this.path.instanceMatrix.needsUpdate = true;
    this.end = end;
  }

  /** Begins the path again at the next position. */
  breakPath() {
    this.end = null;
  }

  clearPath() {
    this.segments = 0;
    this.path.count = 0;
    this.breakPath();
    this.redraw();
  }

  showPath(visible) {
    this.path.visible = visible;
    this.redraw();
  }

  /** Shows a link in a shape from a file; see Arm.replace. */
  setShape(link, geometry) {
    geometry.computeVertexNormals(); // many files have no normals
    if (link === 'tool') {
      this.hasToolShape = true;
      this.shaft.visible = false;
      this.arm.flange.add(new Mesh(geometry, this.arm.materials.steel));
    } else {
      this.arm.replace(link, geometry);
    }
    this.renderer.shadowMap.needsUpdate = true;
    this.redraw();
  }

  /** Turns the camera to one of the views. */
  see(name, atOnce = reduced.matches) {
    const { rail } = this.model;
    const centre = this.foot.position.clone();
    let extent = this.reach;
    if (rail) {
      const end = new Vector3(rail.to.X, rail.to.Y, rail.to.Z);
      centre.set(rail.from.X, rail.from.Y, rail.from.Z);
      extent += 0.35 * centre.distanceTo(end);
      centre.lerp(end, 0.5);
    }
    centre.z += this.height;
    const direction = new Vector3(...VIEWS[name]).normalize();
    const narrow = Math.min(1, this.camera.aspect);
    const distance = (1.12 * extent) / Math.tan((this.camera.fov * Math.PI) / 360) / narrow;
    this.turn(direction.multiplyScalar(distance * 0.68), centre, atOnce);
  }

  /** Turns the camera around the robot by angles in radians, and moves it nearer or away. */
  orbit(across, up, nearer) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    // three.js counts about Y
    const round = new Spherical().setFromCartesianCoords(offset.x, offset.z, -offset.y);
    round.theta += across;
    round.phi = Math.max(0.01, Math.min(Math.PI - 0.01, round.phi - up));
    round.radius *= nearer;
    const to = new Vector3().setFromSpherical(round);
    this.turn(new Vector3(to.x, -to.z, to.y), this.controls.target.clone(), true);
  }

  turn(offset, centre, atOnce) {
    this.turning = {
      fromOffset: this.camera.position.clone().sub(this.controls.target),
      fromCentre: this.controls.target.clone(),
      offset,
      centre,
      start: atOnce ? -Infinity : performance.now(),
    };
    this.redraw();
  }

  /** Makes one step of a turn of the camera. */
  step() {
    if (!this.turning) {
      return;
    }
    const { fromOffset, fromCentre, offset, centre, start } = this.turning;
    const part = Math.min(1, (performance.now() - start) / TURN_MILLIS);
    const eased = part * part * (3 - 2 * part);
    const length = fromOffset.length() + eased * (offset.length() - fromOffset.length());
    this.controls.target.lerpVectors(fromCentre, centre, eased);
    const between =
      part === 1 ? offset.clone() : fromOffset.clone().lerp(offset, eased).setLength(length);
    this.camera.position.copy(this.controls.target).add(between);
    if (part === 1) {
      this.turning = null;
    } else {
      this.redraw();
    }
  }

  /** Draws with the next frame of the screen, once for many changes. */
  redraw() {
    this.again = true;
    if (this.asked === undefined) {
      this.asked = requestAnimationFrame(() => this.draw());
    }
  }

  /** Draws now; with the best quality if nothing moves. */
  draw(best = false) {
    clearTimeout(this.still);
    this.asked = WAITING;
    const start = performance.now();
    this.again = false;
    this.step();
    this.controls.update();
    this.setQuality(best ? 0 : this.quality);
    this.renderer.render(this.scene, this.camera);
    // the browser composes the picture after this task
    setTimeout(() => this.drawn(best ? 0 : performance.now() - start));
    if (!best && this.quality > 0) {
      this.still = setTimeout(() => this.asked === undefined && this.draw(true), STILL);
    }
  }

  /** Draws more coarsely if it takes long, as without a graphics processor. */
  drawn(millis) {
    if (this.asked !== WAITING) {
      return;
    }
    this.slow = 0.7 * (this.slow ?? 0) + 0.3 * Math.min(millis, 5 * SLOW);
    if (this.slow > SLOW && this.quality < QUALITIES.length - 1) {
      this.quality++;
      this.slow = 0;
    }
    // leaves the page time for other work
    setTimeout(() => {
      if (this.asked === WAITING) {
        this.asked = undefined;
        if (this.again) {
          this.redraw();
        }
      }
    }, millis > SLOW ? millis : 0);
  }

  setQuality(quality) {
    if (quality !== this.used) {
      this.used = quality;
      const { ratio, shadows } = QUALITIES[quality];
      this.renderer.setPixelRatio(Math.min(devicePixelRatio, ratio)); // which clears the picture
      this.shade.visible = shadows;
      this.sun.castShadow = shadows;
      this.renderer.shadowMap.needsUpdate = true;
    }
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (clientWidth > 0 && clientHeight > 0) {
      const before = this.camera.aspect;
      this.renderer.setSize(clientWidth, clientHeight, false);
      this.camera.aspect = clientWidth / clientHeight;
      this.camera.updateProjectionMatrix();
      if (before === 1) {
        this.see('oblique', true); // now that the shape of the window is known
      }
      this.redraw();
    }
  }

  dispose() {
    cancelAnimationFrame(this.asked);
    clearTimeout(this.still);
    this.asked = null; // stops drawing
    this.resized.disconnect();
    this.controls.dispose();
    this.scene.traverse((it) => {
      it.geometry?.dispose();
      it.material?.map?.dispose();
      // three.js shares this texture, which otherwise keeps each renderer that has used it
      this.renderer.properties.get(it.material ?? it).uniforms?.dfgLUT?.value?.dispose();
      it.material?.dispose();
    });
    this.renderer.dispose();
    this.renderer.forceContextLoss(); // browsers have few contexts, and free them late
  }
}

/** Three arrows: X red, Y green, Z blue. */
function frame(size, name) {
  const group = new Group();
  const colours = [0xe5484d, 0x30a46c, 0x3e7bfa];
  colours.forEach((colour, axis) => {
    // seen through the robot, which often stands on the base
    const material = new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true });
    const arrow = new Group();
    const shaft = new CylinderGeometry(size / 45, size / 45, 0.8 * size, 10);
    const tip = new ConeGeometry(size / 16, 0.2 * size, 16);
    arrow.add(new Mesh(shaft.translate(0, 0.4 * size, 0), material));
    arrow.add(new Mesh(tip.translate(0, 0.9 * size, 0), material));
    if (axis === 0) {
      arrow.rotation.z = -Math.PI / 2;
    } else if (axis === 2) {
      arrow.rotation.x = Math.PI / 2;
    }
    group.add(arrow);
  });
  group.add(label(name, size));
  return group;
}

function label(text, size) {
  const canvas = document.createElement('canvas');
  canvas.width = 192;
  canvas.height = 64;
  const pen = canvas.getContext('2d');
  pen.fillStyle = 'rgb(22 24 29 / 82%)';
  pen.roundRect(12, 8, 168, 48, 24);
  pen.fill();
  pen.fillStyle = '#fff';
  pen.font = '600 30px system-ui, sans-serif';
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.fillText(text, 96, 34);
  const material = new SpriteMaterial({ map: new CanvasTexture(canvas), depthTest: false });
  const sprite = new Sprite(material);
  sprite.scale.set(0.72 * size, 0.24 * size, 1);
  sprite.position.set(0.25 * size, 0.25 * size, 1.2 * size);
  sprite.renderOrder = 1;
  return sprite;
}
