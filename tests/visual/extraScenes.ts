import type { Mat3 } from '../../src/math/mat3.ts';
import { fromParts } from '../../src/math/mat4.ts';
import { fromAxisAngle, IDENTITY, multiply, type Quat } from '../../src/math/quat.ts';
import { normalize, type Vec3 } from '../../src/math/vec3.ts';
import { makeMaterial, makeObject, makeScene, restingAt } from '../../src/scene/defaults.ts';
import { transformMesh } from '../../src/scene/mesh/meshOps.ts';
import { box, capsule, cone, cylinder, grid, plane, sphere } from '../../src/scene/mesh/primitives.ts';
import { withoutQuadric } from '../../src/scene/mesh/quadric.ts';
import { parabolaVelocities } from '../../src/scene/motion/cubicPoints.ts';
import { isListed } from '../../src/scene/streaming/samplePoints.ts';
import type { Mesh, Motion, Scene, SceneObject, Texture } from '../../src/scene/types.ts';

/** A scene designed to reveal one kind of error, and its view. */
export interface ExtraScene {
  readonly scene: Scene;
  /** The observer's event: world time [s], position [m]. */
  readonly t: number;
  readonly eye: Vec3;
  /** The world point in the middle of the picture at any speed, and the height of the visible region around it [m]. */
  readonly subject: Vec3;
  readonly extent: number;
  /** Unit vector of the observer's velocity. */
  readonly towards: Vec3;
}

const C = 10;
const AHEAD: Vec3 = [0, 0, -1];

/** 8 × 8 squares of two colours, to reveal shifted textures. */
const CHECKER: Texture = {
  name: 'checker',
  width: 64,
  height: 64,
  data: Uint8Array.from({ length: 4 * 64 * 64 }, (_, i) => {
    const [x, y] = [(i >> 2) & 63, i >> 8];
    return i % 4 === 3 ? 255 : ((x >> 3) + (y >> 3)) % 2 === 0 ? 60 : 210;
  }),
  colorSpace: 'linear',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'repeat',
};

const scene = (name: string, objects: readonly SceneObject[]): Scene =>
  makeScene({
    name,
    objects,
    materials: [makeMaterial({ name: 'checker', baseColor: [1, 1, 1], baseColorTexture: CHECKER })],
    hints: { speedOfLight: C },
  });
const at = (path: string, mesh: Mesh, position: Vec3): SceneObject =>
  makeObject({ path, mesh, motion: restingAt(position) });

/** The minimum of triangles: 12 and 2. */
const cube: ExtraScene = {
  scene: scene('cube on a floor', [
    at('/Floor', plane(60, 60, 'Y'), [0, 0, 0]),
    at('/Cube', box([1, 1, 1]), [0.6, 0.5, -4]),
  ]),
  t: 0,
  eye: [0, 1.6, 0],
  subject: [0.6, 0.5, -4],
  extent: 2.4,
  towards: normalize([1, 0, -0.5]),
};

/** Bars on all sides of the observer, walls behind, a lid close above: at high speed all of it is seen ahead. */
const behind: ExtraScene = {
  scene: scene('from behind into view', [
    at('/Left', box([0.2, 0.2, 80]), [-0.7, -0.3, 0]),
    at('/Right', box([0.2, 0.2, 80]), [0.9, 0.4, 0]),
    at('/Lid', plane(6, 80, 'Y'), [0, 0.15, 0]),
    at('/WallBehind', box([12, 8, 0.5]), [1, 0, 9]),
    at('/PostBeside', box([0.3, 5, 0.3]), [1.6, 0, 0.02]),
    at('/PostBehind', box([0.3, 5, 0.3]), [-1.3, 0, 2.5]),
  ]),
  t: 0,
  eye: [0, 0, 0],
  subject: [0, 0, -10],
  // At 14 times the distance, at 0.99 c: a wide view, in which objects behind the observer are visible.
  extent: 190,
  towards: AHEAD,
};

/** Two slanted walls about a pixel's width apart; the front one covers half of the other. Viewed with a long lens, so that only depth decides. */
const touching = (name: string, distance: number, gap: number): ExtraScene => ({
  scene: scene(name, [
    slanted('/Behind', [80 * gap, 80 * gap, 0.1 * gap], [-20 * gap, 0, -distance - gap]),
    slanted('/Front', [40 * gap, 80 * gap, 0.1 * gap], [0, 0, -distance]),
  ]),
  t: 0,
  eye: [0, 0, 0],
  subject: [0, 0, -distance],
  extent: 90 * gap,
  towards: normalize([0.5, 0.2, 1]),
});
const near = touching('walls 1 cm apart at 10 m', 10, 0.01);
const far = touching('walls 1 m apart at 10 km', 10_000, 1);

function slanted(path: string, size: Vec3, position: Vec3): SceneObject {
  const orientation = fromAxisAngle([1, 0, 0], -0.2);
  return makeObject({ path, mesh: box(size), motion: { kind: 'static', pose: { position, orientation } } });
}

/**
 * Two long bars that decelerate, reverse and accelerate along +X. Of the one authored in the world each point has its own horizon: the observer sees
 * its rear, its front not yet, and in between the bar extends to infinity. The other is Born rigid, with one horizon for all points.
 */
const horizon: ExtraScene = {
  scene: scene('horizon', [
    bar('/World', 'world', [0, -1.2, -6]),
    bar('/Rest', 'rest', [0, 1.2, -6]),
    at('/Wall', box([60, 12, 0.5]), [10, 0, -14]),
  ]),
  t: 0.35,
  eye: [-6, 0, 0],
  subject: [2, 0, -6],
  extent: 8,
  towards: [0.6, 0, -0.8],
};

function bar(path: string, authoredIn: SceneObject['authoredIn'], position: Vec3): SceneObject {
  const motion: Motion = {
    kind: 'hyperbolic',
    pose: { position, orientation: IDENTITY },
    properAcceleration: [30, 0, 0],
    t0: 0,
  };
  return makeObject({ path, mesh: box([5, 0.8, 0.8]), motion, authoredIn });
}

/** A wheel of six triangulated spokes whose rim rotates at 0.8 c while its axle moves at 0.15 c. */
const wheel: ExtraScene = {
  scene: scene('turning wheel', [
    ...[0, 1, 2].map((k) => turning(`/Spoke${k}`, box([0.25, 3.6, 0.2]), (k * Math.PI) / 3)),
    turning('/Rim', cylinder(1.8, 0.15, { segments: 24 }), 0.1),
    at('/Floor', plane(40, 40, 'Y'), [0, -2.2, 0]),
  ]),
  t: 1,
  eye: [0, 0.5, 4.5],
  subject: [0, 0, 0],
  extent: 5,
  towards: normalize([-0.7, 0, -1]),
};

function turning(path: string, mesh: Mesh, phase: number): SceneObject {
  const count = 400;
  const times = Float64Array.from({ length: count }, (_, k) => -2 + (4 * k) / (count - 1));
  const poses = new Float64Array(7 * count);
  times.forEach((t, k) => {
    const turn: Quat = multiply(fromAxisAngle([0, 1, 0], 0.5), fromAxisAngle([0, 0, 1], phase + ((0.8 * C) / 1.8) * t));
    poses.set([0.15 * C * (t - 0.5), 0, path === '/Rim' ? -0.3 : 0, ...turn], 7 * k);
  });
  return makeObject({ path, mesh, motion: { kind: 'sampled', times, poses } });
}

/** A cloth of few large triangles in a travelling wave, partly faster than 0.5 c. */
const cloth = clothOf('cloth', waving(80));
/** The same with so few samples that chords would be pixels off, interpolated by cubics: velocities are continuous. */
const cubicCloth = clothOf('cloth along cubics', cubically(waving(22)));

function clothOf(name: string, object: SceneObject): ExtraScene {
  return {
    scene: scene(name, [object, at('/Wall', box([14, 9, 0.5]), [0, 0, -9])]),
    t: 1,
    eye: [0, 0.3, 0],
    subject: [0, 0, -5],
    extent: 5,
    towards: [0.6, 0, -0.8],
  };
}

function waving(samples: number): SceneObject {
  const mesh = grid(5, 4, 6, 5);
  const times = Float64Array.from({ length: samples }, (_, k) => -2 + (4 * k) / (samples - 1));
  const points = Array.from(times, (t) => {
    const out = new Float32Array(mesh.positions);
    for (let i = 0; i < out.length; i += 3) {
      const [x, y] = [out[i], out[i + 1]];
      out[i + 2] += 0.7 * Math.sin(1.5 * x - 7 * t) + 0.2 * Math.cos(2 * y + 5 * t);
      out[i] += 0.3 * Math.sin(4 * t + y);
    }
    return out;
  });
  return makeObject({ path: '/Cloth', mesh, motion: { kind: 'sampled-points', times, origin: [0, 0, -5], points } });
}

function cubically(object: SceneObject): SceneObject {
  const { motion } = object;
  if (motion.kind !== 'sampled-points' || !isListed(motion.points)) return object;
  return { ...object, motion: { ...motion, velocities: parabolaVelocities(motion.times, motion.points) } };
}

/**
 * Instances of one mesh: at rest, at 0.9 c as authored in the world and in their rest frames, and rotating in motion; near enough that some are only
 * partly tessellated. Each has its own orientation, and one of two materials.
 */
const crowd: ExtraScene = {
  scene: makeScene({
    name: 'crowd',
    objects: [
      ...wearers('Resting', 18, (place, orientation) => ({ kind: 'static', pose: { position: place, orientation } })),
      ...wearers('World', 12, flying),
      ...wearers('Rest', 12, flying).map((object): SceneObject => ({ ...object, authoredIn: 'rest' })),
      ...wearers('Turning', 12, tumbling),
      at('/Floor', plane(80, 80, 'Y'), [0, -3.5, 0]),
    ],
    materials: [
      makeMaterial({ name: 'checker', baseColor: [1, 1, 1], baseColorTexture: CHECKER }),
      makeMaterial({ name: 'red checker', baseColor: [1, 0.3, 0.2], baseColorTexture: CHECKER }),
    ],
    hints: { speedOfLight: C },
  }),
  t: 0.1,
  eye: [0, 0.2, 0],
  subject: [0, 0, -6],
  extent: 6,
  towards: [0.6, 0, -0.8],
};

function wearers(group: string, count: number, motionOf: (place: Vec3, turn: Quat) => Motion): SceneObject[] {
  const sharedMesh = cylinder(0.45, 1.4, { axis: 'Y', segments: 48 });
  const meshes = [0, 1].map((material) => ({
    ...sharedMesh,
    groups: sharedMesh.groups.map((g) => ({ ...g, material })),
  }));
  const row = ['Resting', 'World', 'Rest', 'Turning'].indexOf(group);
  return Array.from({ length: count }, (_, i) => {
    const place: Vec3 = [1.7 * ((i % 6) - 2.5) + 0.3 * row, 1.3 * row - 2, -2.2 - 2.1 * Math.floor(i / 6) - 0.5 * row];
    const turn = fromAxisAngle(normalize([1, i % 3, (i % 5) - 2]), 0.7 * i);
    return makeObject({ path: `/${group}${i}`, mesh: meshes[i % 2], motion: motionOf(place, turn) });
  });
}

function flying(place: Vec3, orientation: Quat): Motion {
  return { kind: 'uniform', pose: { position: place, orientation }, velocity: [9, 0, 0] };
}

function tumbling(place: Vec3, first: Quat): Motion {
  const times = Float64Array.from({ length: 60 }, (_, k) => -2 + k / 15);
  const poses = Array.from(times, (t) => {
    const turn = multiply(fromAxisAngle([0, 0, 1], 3 * t), first);
    return [place[0] + 2 * Math.sin(2 * t), place[1], place[2] - 2 * t, ...turn];
  });
  return { kind: 'sampled', times, poses: Float64Array.from(poses.flat()) };
}

/** Round solids of the fewest segments, near the observer: their polygons would be off by pixels. One is stretched, one mirrored, two overlap. */
const round: ExtraScene = {
  scene: scene('round solids', [
    at('/Ball', sphere(1.2, { segments: 20 }), [-1.5, -0.4, -3]),
    at('/Egg', stretched(sphere(0.8, { segments: 20 }), [0.5, 1.4, 0.7]), [-0.2, 1.2, -3]),
    at('/Mirrored', stretched(cone(0.7, 1.4, { segments: 20, axis: 'Y' }), [-1, -1, -1]), [0.2, 1.2, -2.8]),
    makeObject({
      path: '/Can',
      mesh: cylinder(0.5, 1.6, { segments: 20, axis: 'Y' }),
      authoredIn: 'rest',
      motion: flying([1, -0.6, -2.6], fromAxisAngle([0, 0, 1], 0.6)),
    }),
    makeObject({
      path: '/Pill',
      mesh: capsule(0.35, 0.9, { segments: 20 }),
      motion: tumbling([1, 0.9, -2.4], IDENTITY),
    }),
    makeObject({
      path: '/Hat',
      mesh: cone(0.7, 1.2, { segments: 20 }),
      authoredIn: 'rest',
      motion: {
        kind: 'hyperbolic',
        pose: { position: [-0.6, -1.6, -3], orientation: IDENTITY },
        properAcceleration: [20, 0, 5],
        t0: -0.5,
      },
    }),
    at('/Floor', plane(20, 20, 'Y'), [0, -2.2, 0]),
  ]),
  t: 0.1,
  eye: [0, 0.2, 0],
  subject: [0, 0, -3],
  extent: 4,
  towards: [0.6, 0, -0.8],
};

/** One mesh in bodies of other sizes and proportions, sheared too: at rest, moving, and turning, which are drawn from copies of it. */
const proportions: ExtraScene = {
  scene: {
    ...crowd.scene,
    name: 'one mesh in many proportions',
    objects: crowd.scene.objects.map((object, i) =>
      object.path === '/Floor' ? object : { ...object, mesh: withoutQuadric(object.mesh), stretch: proportion(i) },
    ),
  },
  t: crowd.t,
  eye: crowd.eye,
  subject: crowd.subject,
  extent: crowd.extent,
  towards: crowd.towards,
};

function proportion(i: number): Mat3 {
  return [0.6 + 0.1 * (i % 7), 0.15 * (i % 3), 0, 0, 1.3 - 0.1 * (i % 5), 0, 0.1, 0, 0.7];
}

function stretched(mesh: Mesh, [x, y, z]: Vec3): Mesh {
  return transformMesh(mesh, fromParts([x, 0, 0, 0, y, 0, 0, 0, z], [0, 0, 0]));
}

export const EXTRA_SCENES: readonly ExtraScene[] = [
  cube,
  behind,
  near,
  far,
  horizon,
  wheel,
  cloth,
  cubicCloth,
  crowd,
  round,
  proportions,
];
