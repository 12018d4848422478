// A robot as a tree of groups, one for each axis, with generated bodies between them. The chain is
// the same as in the robot model of the server; lengths are in mm.

import {
  BoxGeometry,
  CylinderGeometry,
  ExtrudeGeometry,
  Group,
  LatheGeometry,
  Mesh,
  MeshStandardMaterial,
  Shape,
  SphereGeometry,
  TorusGeometry,
  Vector2,
} from 'three';

const RADIANS = Math.PI / 180;
const COLOURS = { body: 0xf26a1b, joint: 0x3a3f47, steel: 0xb9c0c9, base: 0x454b55 };
const LIMIT_COLOURS = { free: 0x5b626d, near: 0xf0b429, at: 0xe5283d };

/** The links of a robot; each moves with the group of its axis. */
const LINKS = ['base', 'a1', 'a2', 'a3', 'a4', 'a5', 'a6'];

/** Returns the parent's system turned and moved by a KRL frame, written into an object. */
export function place(object, frame) {
  object.position.set(frame.X, frame.Y, frame.Z);
  object.rotation.set(frame.C * RADIANS, frame.B * RADIANS, frame.A * RADIANS, 'ZYX');
}

/** An arm that can be moved. With the colour of a ghost it is translucent, without limit rings. */
export class Arm {
  constructor(model, ghost) {
    this.model = model;
    this.root = new Group();
    this.rings = [];
    const { a1, a2, b, c1, c2, c3, c4 } = model.lengths;
    const origins = [
      [0, 0, c1],
      [a1, 0, 0],
      [0, 0, c2],
      [a2, b, c3],
      [0, 0, 0],
      [0, 0, 0],
    ];
    this.groups = origins.map((origin) => {
      const group = new Group();
      group.position.set(...origin);
      return group;
    });
    this.groups.reduce((parent, group) => parent.add(group) && group, this.root);
    this.flange = new Group();
    this.flange.position.z = c4;
    this.groups[5].add(this.flange);
    this.materials = materials(ghost);
    this.bodies = new Map(LINKS.map((link) => [link, new Group()]));
    this.bodies.forEach((body, link) => this.group(link).add(body));
    addBodies(this, model.lengths, !ghost);
  }

  /** Returns the group that a link moves with. */
  group(link) {
    return link === 'base' ? this.root : this.groups[Number(link[1]) - 1];
  }

  /** Moves the axes to six angles in degrees. */
  move(angles) {
    this.model.axes.forEach(({ direction, offset }, i) => {
      const turn = direction * (angles[i] - offset) * RADIANS;
      const group = this.groups[i];
      if (i === 1 || i === 2 || i === 4) {
        group.rotation.y = turn;
      } else {
        group.rotation.z = turn;
      }
    });
  }

  /** Colours the ring of an axis: 'free', 'near' or 'at' its limit. */
  showLimit(axis, state) {
    const ring = this.rings[axis];
    ring.material.color.setHex(LIMIT_COLOURS[state]);
    ring.material.emissive.setHex(state === 'free' ? 0 : LIMIT_COLOURS[state]);
    ring.material.emissiveIntensity = 0.35;
  }

  /**
   * Replaces the generated body of a link.
   *
   * @param geometry the shape in $ROBROOT with all axes at 0
   */
  replace(link, geometry) {
    const angles = this.angles ?? [0, 0, 0, 0, 0, 0];
    this.move([0, 0, 0, 0, 0, 0]);
    this.root.updateWorldMatrix(true, true);
    const group = this.group(link);
    const toLink = group.matrixWorld.clone().invert().multiply(this.root.matrixWorld);
    this.move(angles);
    const body = this.bodies.get(link);
    body.clear();
    body.add(solid(geometry.applyMatrix4(toLink), this.materials.body));
  }

  dispose() {
    this.root.traverse((it) => {
      it.geometry?.dispose();
      it.material?.dispose();
    });
  }
}

function materials(ghost) {
  if (ghost) {
    const one = new MeshStandardMaterial({
      color: ghost,
      transparent: true,
      opacity: 0.28,
      depthWrite: false,
      roughness: 0.9,
    });
    return { body: one, joint: one, steel: one, base: one };
  }
  const paint = { roughness: 0.45, metalness: 0.05 };
  return {
    body: new MeshStandardMaterial({ color: COLOURS.body, ...paint }),
    joint: new MeshStandardMaterial({ color: COLOURS.joint, roughness: 0.6 }),
    steel: new MeshStandardMaterial({ color: COLOURS.steel, roughness: 0.35, metalness: 0.55 }),
    base: new MeshStandardMaterial({ color: COLOURS.base, roughness: 0.7 }),
  };
}

function solid(geometry, material) {
  const mesh = new Mesh(geometry, material);
  mesh.castShadow = !material.transparent;
  mesh.receiveShadow = !material.transparent;
  return mesh;
}

/** A cylinder along Z from one height to another. */
function upright(radius, from, to, top = radius) {
  return new CylinderGeometry(top, radius, to - from, 40)
    .rotateX(Math.PI / 2)
    .translate(0, 0, (from + to) / 2);
}

/** A cylinder along Y. */
function across(radius, from, to) {
  return new CylinderGeometry(radius, radius, to - from, 40).translate(0, (from + to) / 2, 0);
}

/** A body of revolution about Z: pairs of a radius and a height. */
function turned(...profile) {
  return new LatheGeometry(
    profile.map(([radius, height]) => new Vector2(radius, height)),
    48,
  ).rotateX(Math.PI / 2);
}

/**
 * A plate around two circles in the XZ plane, with rounded edges.
 *
 * @param one, two the circles: x, z and radius
 * @param from, to its sides along Y
 */
function strap(one, two, from, to) {
  const [x1, z1, r1] = one;
  const [x2, z2, r2] = two;
  const distance = Math.hypot(x2 - x1, z2 - z1);
  const along = Math.atan2(z2 - z1, x2 - x1);
  const lean = Math.acos(Math.max(-1, Math.min(1, (r1 - r2) / distance)));
  const shape = new Shape();
  shape.absarc(x1, z1, r1, along + lean, along - lean + 2 * Math.PI, false);
  shape.absarc(x2, z2, r2, along - lean, along + lean, false);
  shape.closePath();
  const bevel = Math.min(0.18 * Math.min(r1, r2), 0.3 * (to - from));
  const geometry = new ExtrudeGeometry(shape, {
    depth: to - from - 2 * bevel,
    bevelSize: bevel,
    bevelOffset: -bevel,
    bevelThickness: bevel,
    bevelSegments: 3,
    curveSegments: 28,
  });
  // the plane XY of the shape becomes XZ, and its depth runs against Y
  return geometry.rotateX(Math.PI / 2).translate(0, to - bevel, 0);
}

/** A ring about Z or Y that shows how near an axis is to its limits. */
function ring(arm, axis, radius, at) {
  const geometry = new TorusGeometry(radius, radius * 0.075, 14, 56);
  if (axis === 1 || axis === 2 || axis === 4) {
    geometry.rotateX(Math.PI / 2).translate(0, at, 0);
  } else {
    geometry.translate(0, 0, at);
  }
  const material = new MeshStandardMaterial({ color: LIMIT_COLOURS.free, roughness: 0.4 });
  arm.rings[axis] = new Mesh(geometry, material);
  arm.groups[axis].add(arm.rings[axis]);
}

/**
 * Adds bodies whose proportions follow the lengths. The arm is to the left of the shoulder, as in
 * most robots of this kind.
 */
function addBodies(arm, { a1, a2, b, c1, c2, c3, c4 }, withRings) {
  const { body, joint, steel, base } = arm.materials;
  const add = (link, geometry, material) => arm.bodies.get(link).add(solid(geometry, material));
  const forearm = Math.hypot(a2, c3);
  // half of the thickness at the shoulder
  const t = Math.min(0.078 * (c2 + forearm), 0.3 * c1);
  const w = Math.min(0.6 * t, 0.6 * c4, 0.16 * c3); // and at the wrist
  const column = 1.28 * t;

  // foot, up to the seam of A1
  const seam = c1 - 1.35 * t;
  const plate = 0.22 * t;
  add('base', new BoxGeometry(3.6 * t, 3.6 * t, plate).translate(0, 0, plate / 2), base);
  const waist = Math.max(plate, Math.min(0.55 * seam, seam - 0.3 * t));
  add(
    'base',
    turned([1.75 * t, plate], [1.62 * t, 0.3 * waist + plate], [1.3 * t, waist], [column, seam], [0, seam]),
    base,
  );

  // column with the shoulder
  const shoulder = a1 === 0 ? 0.01 : a1;
  add('a1', turned([column, -1.35 * t], [column, -0.95 * t], [1.1 * t, -0.7 * t], [0, -0.7 * t]), body);
  add('a1', strap([0, -0.75 * t, 1.08 * t], [shoulder, 0, 0.98 * t], -1.05 * t, 0.28 * t), body);
  add('a1', across(0.78 * t, -1.3 * t, -1.0 * t).translate(a1, 0, 0), joint);

  // upper arm
  const left = 0.3 * t;
  add('a2', strap([0, 0, 0.95 * t], [0, c2, 0.72 * t], left, 1.12 * t), body);
  add('a2', across(0.62 * t, 1.1 * t, 1.24 * t), joint);
  add('a2', across(0.5 * t, 1.1 * t, 1.22 * t).translate(0, 0, c2), joint);

  // elbow and forearm
  const elbow = Math.min(0.3 * c3, 1.1 * t);
  const neck = 0.52 * c3; // where A4 turns
  add('a3', strap([0, 0, 0.74 * t], [a2, elbow, 0.66 * t], -0.78 * t, 0.26 * t), body);
  add('a3', across(0.5 * t, -1.0 * t, -0.74 * t), joint);
  const hull = turned(
    [0, -0.75 * t],
    [0.44 * t, -0.75 * t],
    [0.6 * t, -0.55 * t],
    [0.66 * t, elbow],
    [0.56 * t, neck],
    [0, neck],
  ).translate(a2, b, 0);
  add('a3', hull, body);

  // wrist: tube and fork, hand, flange
  const back = -(c3 - neck);
  const fork = -1.5 * w;
  add('a4', turned([0.53 * t, back], [1.12 * w, fork], [1.05 * w, fork + 0.5 * w], [0, fork + 0.5 * w]), body);
  add('a4', strap([0, fork + 0.3 * w, 0.78 * w], [0, 0, 0.72 * w], 0.62 * w, 1.06 * w), body);
  add('a4', strap([0, fork + 0.3 * w, 0.78 * w], [0, 0, 0.72 * w], -1.06 * w, -0.62 * w), body);
  const disc = Math.min(0.25 * w, 0.2 * c4);
  add('a5', across(0.6 * w, -0.6 * w, 0.6 * w), joint);
  add('a5', new SphereGeometry(0.66 * w, 32, 20), joint);
  add('a5', upright(0.6 * w, 0, c4 - disc, 0.52 * w), joint);
  add('a6', upright(0.68 * w, c4 - disc, c4), steel);
  // a mark that shows how A6 is turned
  add('a6', new BoxGeometry(0.3 * w, 0.16 * w, disc).translate(0.66 * w, 0, c4 - disc / 2), joint);

  if (withRings) {
    ring(arm, 0, 1.29 * t, -1.33 * t);
    ring(arm, 1, 0.72 * t, 1.13 * t);
    ring(arm, 2, 0.56 * t, 1.13 * t);
    ring(arm, 3, 0.55 * t, back);
    ring(arm, 4, 0.6 * w, 1.07 * w);
    ring(arm, 5, 0.6 * w, c4 - disc);
  }
}
