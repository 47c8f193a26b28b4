import { add, dot, length, scale, sub, type Vec3 } from '../../src/math/vec3.ts';
import type { Scene, SceneObject } from '../../src/scene/types.ts';
import { at, daylight, paint, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { lookFrom } from '../kit/flight.ts';
import { block, quad } from '../kit/parts.ts';
import { type Field, surfaceNet } from '../kit/surfaceNet.ts';

/** How long it lasts [s], and its samples: a mesh each. */
const [END, SAMPLES] = [6, 24];
/** Reach of a drop's field [m], the value at its surface, and the size of the cells [m]. */
const [REACH, LEVEL, CELL] = [2, 0.3, 0.5];
/** Common speed of the drops [m/s]. */
const SPEED = 5.5;
/** The fastest that the surface moves relative to what it is of [m/s]; where drops part, its curvature is unbounded. */
const MOST_RELATIVE = 1.5;

export const scene: ExampleScene = { name: 'drops', make };

/** Two drops that merge and part while they pass at 0.55 c: as a cache of a fluid, a mesh per sample, each with velocities. */
function make(): Scene {
  const builder = new SceneBuilder();
  const ground = builder.material('ground', '#8b8f88', { roughness: 0.9 });
  builder.object('/World/Ground', [paint(quad([-40, 0, 30], [40, 0, 30], [40, 0, -40], [-40, 0, -40]), ground)]);
  const post = builder.material('post', '#d8d2c4', { roughness: 0.7 });
  builder.object('/World/Post', [paint(block(0.7, 6, 0.7, 1, [-20, 0, -5]), post)]);
  for (let k = 1; k <= 8; k++) builder.copy(`/World/Post${k}`, [5, 0, 0]);
  const liquid = builder.material('liquid', '#c3d2c4', { roughness: 0.25 });
  const eye: Vec3 = [0, 3.4, 15];
  const camera = { path: '/World/Camera', motion: at(eye, lookFrom(eye, [0, 3, 0])), fovY: (50 * Math.PI) / 180 };
  const hints = {
    speedOfLight: 10,
    title: 'Drops',
    lookFor:
      'A fluid as simulations write it: at every sample another mesh, with velocities. Two drops merge and part as they pass at 0.55 c. They are seen where and as they were when their light left, the far end earlier than the near one, so that one picture has parts of several meshes; they come long and blue and leave short and red.',
    openAt: 4,
  };
  const made = builder.finish('drops', hints, [0, END + 3], [camera], daylight([-0.4, 0.8, 0.5]));
  const pieces = Array.from({ length: SAMPLES }, (_, k) => piece(k, liquid));
  return { ...made, objects: [...made.objects, ...pieces] };
}

interface Drop {
  readonly position: Vec3;
  readonly velocity: Vec3;
}

/** The drops at a time [s]: they come from both sides of their common middle, are one, and part. */
function dropsAt(t: number): readonly Drop[] {
  const phase = (2 * Math.PI * t) / END;
  const [half, rate] = [1 + 0.85 * Math.cos(phase), ((-0.85 * 2 * Math.PI) / END) * Math.sin(phase)];
  const axis: Vec3 = [0.8, 0.6, 0];
  const middle: Vec3 = [SPEED * (t - END / 2), 3.2, 0];
  return [-1, 1].map((side) => ({
    position: add(middle, scale(axis, side * half)),
    velocity: add([SPEED, 0, 0], scale(axis, side * rate)),
  }));
}

/** Fields of the drops, (1 − r²/R²)² each, summed; and how the surface moves. */
class Liquid implements Field {
  private readonly drops: readonly Drop[];

  constructor(drops: readonly Drop[]) {
    this.drops = drops;
  }

  value(p: Vec3): number {
    return this.drops.reduce((sum, drop) => sum + inside(p, drop) ** 2, -LEVEL);
  }

  gradient(p: Vec3): Vec3 {
    return this.drops.map((drop) => slope(p, drop)).reduce(add);
  }

  /** Of a point of the surface: that of the drops by their shares, and along the normal what keeps it on the surface, df/dt + v·∇f = 0. */
  velocity(p: Vec3): Vec3 {
    const shares = this.drops.map((drop) => inside(p, drop) ** 2);
    const whole = shares.reduce((a, b) => a + b);
    const shared = this.drops.map(({ velocity }, i) => scale(velocity, shares[i] / whole)).reduce(add);
    const gradient = this.gradient(p);
    const change = this.drops.reduce((sum, drop) => sum + dot(slope(p, drop), sub(shared, drop.velocity)), 0);
    const own = scale(gradient, -change / Math.max(1e-6, dot(gradient, gradient)));
    return add(shared, scale(own, Math.min(1, MOST_RELATIVE / Math.max(1e-6, length(own)))));
  }
}

const inside = (p: Vec3, { position }: Drop): number => {
  const d = sub(p, position);
  return Math.max(0, 1 - dot(d, d) / REACH ** 2);
};

const slope = (p: Vec3, drop: Drop): Vec3 => scale(sub(p, drop.position), (-4 / REACH ** 2) * inside(p, drop));

/** The mesh of a sample, alive until the next. */
function piece(k: number, material: number): SceneObject {
  const [birth, death] = [(END * k) / SAMPLES, (END * (k + 1)) / SAMPLES];
  const liquid = new Liquid(dropsAt(birth));
  // Cells at rest in the world; twelve metres around the drops.
  const low: Vec3 = [CELL * Math.floor((SPEED * (birth - END / 2) - 5) / CELL), -0.75, -3];
  const net = surfaceNet(liquid, low, [21, 16, 12], CELL);
  const velocities = velocitiesOf(net.positions, liquid);
  const moved = (dt: number): Float32Array => net.positions.map((x, i) => x + velocities[i] * dt);
  const mesh = {
    ...net,
    uvs: new Float32Array((2 * net.positions.length) / 3),
    groups: [{ start: 0, count: net.indices.length, material }],
    doubleSided: false,
  };
  // Straight on a little beyond its life, as the reader has it.
  const times = Float64Array.of(birth - 1, death + 1);
  return {
    path: `/World/Drops/piece${k + 1}`,
    pieceOf: '/World/Drops',
    mesh,
    motion: { kind: 'sampled-points', times, origin: [0, 0, 0], points: [moved(-1), moved(death - birth + 1)] },
    lifetime: { birth, death },
    authoredIn: 'world',
  };
}

function velocitiesOf(positions: Float32Array, liquid: Liquid): Float32Array {
  const out = new Float32Array(positions.length);
  for (let i = 0; i < out.length; i += 3)
    out.set(liquid.velocity([positions[i], positions[i + 1], positions[i + 2]]), i);
  return out;
}
