import { fromAxisAngle } from '../../src/math/quat.ts';
import { random } from '../../src/math/random.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { makeMesh } from '../../src/scene/mesh/makeMesh.ts';
import { mergeMeshes } from '../../src/scene/mesh/meshOps.ts';
import { cylinder, revolve, type SurfaceBand, sphere } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, SampledPointsMotion, Scene } from '../../src/scene/types.ts';
import { daylight, type Part, paint, place, placePart, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, sampled } from '../kit/flight.ts';
import { bricks, Canvas, tone } from '../kit/paint.ts';
import { block, flatBand, join, moved, quad, turned } from '../kit/parts.ts';
import { poplar } from '../kit/trees.ts';

const C = 10;
/** Speeds of the axle, and of the rim relative to it [m/s]. */
const SPEED = 6;
const RADIUS = 2;
const WIDTH = 0.26;
/** Time at which the axle passes the camera [s]. */
const MIDDLE = 2.9;
const END = 5.8;
const SPOKES = 10;

export const scene: ExampleScene = { name: 'wheel', make };

function make(): Scene {
  const builder = new SceneBuilder();
  road(builder);
  const iron = builder.material('iron', '#5d6266', { roughness: 0.45, metallic: 0.7 });
  const wood = builder.material('ash', '#cf9f63', { roughness: 0.55 });
  const hubWood = builder.material('hub', '#7c2f26', { roughness: 0.5 });
  const wheel: Part = [paint(felloe(), wood), paint(tyre(), iron), paint(spokes(), wood), paint(hub(), hubWood)];
  const mesh = mergeMeshes([...wheel].sort((a, b) => a.groups[0].material - b.groups[0].material));
  builder.object('/World/Rolling', wheel, rolling(mesh));
  stand(builder, wheel, iron);
  // The camera follows the observed wheel, which is 0.9 s late.
  const gaze = (t: number) => 4 * Math.tanh((t - MIDDLE - 0.9) / 1.4);
  const flight = camera({
    from: 0,
    to: END,
    fovY: 50,
    position: (t) => [3 + 0.2 * t, 2, 8.2],
    target: (t) => [0.6 + gaze(t), 1.85, 0],
  });
  const hints = {
    speedOfLight: C,
    title: 'Wheel',
    lookFor:
      'The wheel rolls at 0.6 c; its top goes 0.88 c, the place that touches the road stands still. In the simultaneity view of the road it is an ellipse and its spokes are bent: what is "now" all over the hub’s frame is not "now" here. The wheel on the stand only turns.',
    openAt: MIDDLE + 0.85,
  };
  return builder.finish('wheel', hints, [0, END], [flight], daylight([-0.4, 0.75, 0.6]));
}

/**
 * Rolling without slipping: in the axle's frame the wheel is round and rotates uniformly, its rim as fast as the road moves
 * below it. A point at (ρ, φ₀) there is at x′ = ρ cos(φ₀ − ωt′); in the road's frame x = γ(x′ + vt′) at t = γ(t′ + vx′/c²), and
 * at one t each point has its own t′ (docs/model.md). Sampled 15 times a second.
 */
function rolling(mesh: Mesh): SampledPointsMotion {
  const count = Math.round(END * 15) + 1;
  const times = Float64Array.from({ length: count }, (_, k) => (END * k) / (count - 1));
  const points = Array.from(times, (t) => {
    const out = new Float32Array(mesh.positions.length);
    for (let i = 0; i < out.length; i += 3) out.set(rolledTo(t - MIDDLE, mesh.positions.subarray(i, i + 3)), i);
    return out;
  });
  return { kind: 'sampled-points', times, origin: [0, RADIUS, 0], points };
}

function rolledTo(t: number, [x0, y0, z]: ArrayLike<number> & Iterable<number>): Vec3 {
  const beta = SPEED / C;
  const gamma = 1 / Math.sqrt(1 - beta * beta);
  const [rho, phi] = [Math.hypot(x0, y0), Math.atan2(y0, x0)];
  const angle = (own: number) => phi - (SPEED / RADIUS) * own;
  let own = t / gamma;
  // Each iteration reduces the error of t′ by vρω/c² < 0.37; it converges to the last digit earlier.
  for (let i = 0; i < 60; i++) own = t / gamma - (beta / C) * rho * Math.cos(angle(own));
  const places = [gamma * (rho * Math.cos(angle(own)) + SPEED * own), rho * Math.sin(angle(own)), z];
  // Rounded to 1 mm, which keeps the file short.
  const [x, y] = places.map((value) => Math.round(value * 1e3) / 1e3);
  return [x, y, z];
}

/** The wooden ring, without its outer face. */
function felloe(): Mesh {
  const [inner, z] = [RADIUS - 0.24, WIDTH / 2];
  const bands = [
    flatBand([inner, -z], [RADIUS, -z], [0, -1]),
    flatBand([RADIUS, z], [inner, z], [0, 1]),
    flatBand([inner, z], [inner, -z], [-1, 0]),
  ];
  return revolve(bands, 44, 'Z');
}

const tyre = (): Mesh => revolve([flatBand([RADIUS, -WIDTH / 2], [RADIUS, WIDTH / 2], [1, 0])], 44, 'Z');

/** Spokes, thickest near the hub, subdivided so that they can bend. */
function spokes(): Mesh {
  const steps = [0.26, 0.45, 0.85, 1.3, RADIUS - 0.22];
  const radii = [0.085, 0.085, 0.068, 0.052, 0.055];
  const sides = 5;
  const points: number[] = [];
  const faceIndices: number[] = [];
  for (let s = 0; s < SPOKES; s++) {
    const a = (2 * Math.PI * s) / SPOKES;
    const first = points.length / 3;
    steps.forEach((rho, k) => {
      for (let j = 0; j < sides; j++) {
        const b = (2 * Math.PI * j) / sides;
        const side = radii[k] * Math.cos(b);
        points.push(rho * Math.cos(a) - side * Math.sin(a), rho * Math.sin(a) + side * Math.cos(a));
        points.push(radii[k] * Math.sin(b));
      }
    });
    for (let k = 0; k + 1 < steps.length; k++)
      for (let j = 0; j < sides; j++) {
        const p = first + k * sides;
        const q = (j + 1) % sides;
        faceIndices.push(p + j, p + q, p + sides + q, p + sides + j);
      }
  }
  const faceCounts = new Array<number>(faceIndices.length / 4).fill(4);
  return makeMesh({ points, faceCounts, faceIndices, smoothAngle: Math.PI }).mesh;
}

function hub(): Mesh {
  const slant = (from: [number, number], to: [number, number]): SurfaceBand => {
    const l = Math.hypot(to[0] - from[0], to[1] - from[1]);
    return flatBand(from, to, [(to[1] - from[1]) / l, (from[0] - to[0]) / l]);
  };
  const bands = [
    slant([0, -0.32], [0.13, -0.32]),
    slant([0.13, -0.32], [0.3, -0.14]),
    slant([0.3, -0.14], [0.3, 0.14]),
    slant([0.3, 0.14], [0.13, 0.32]),
    slant([0.13, 0.32], [0, 0.32]),
  ];
  return revolve(bands, 14, 'Z');
}

/** The same wheel on a trestle behind the road: its axle is at rest. */
function stand(builder: SceneBuilder, wheel: Part, iron: number): void {
  const middle: Vec3 = [3.2, RADIUS + 0.55, -4.2];
  const motion = sampled(-2, END, 24, (t) => ({
    position: middle,
    orientation: fromAxisAngle([0, 0, 1], (-SPEED / RADIUS) * (t - MIDDLE)),
  }));
  builder.object('/World/Turning', wheel, motion);
  const leg = (x: number, z: number): Mesh =>
    join([block(0.16, RADIUS + 0.7, 0.14, 1, [x, 0, z]), block(0.5, 0.12, 0.5, 1, [x, 0, z])]);
  const oak = builder.material('oak', '#6d5138', { roughness: 0.85 });
  const axle = moved(cylinder(0.07, 1.1, { segments: 16, axis: 'Z' }), [0, RADIUS + 0.55, 0]);
  builder.object(
    '/World/Stand',
    placePart(
      [paint(join([leg(0, -0.45), leg(0, 0.45), block(1.9, 0.14, 1.2, 1)]), oak), paint(axle, iron)],
      place([middle[0], 0, middle[2]]),
    ),
  );
}

/** A country road with milestones, a wall of old bricks, and poplars. */
function road(builder: SceneBuilder): void {
  const dirt = builder.material('dirt', '#ffffff', { texture: gravel('#b9a486', 'dirt'), roughness: 1 });
  const grass = builder.material('grass', '#ffffff', {
    texture: gravel('#7c9358', 'grass'),
    roughness: 1,
    like: 'leaf',
  });
  const stone = builder.material('stone', '#d9d4c7', { roughness: 0.85 });
  const red = builder.material('band', '#b5412f', { roughness: 0.7 });
  const wall = builder.material('wall', '#ffffff', { texture: bricks('#a5654c', '#c6b9a6', 'wall'), roughness: 0.95 });
  const long = 45;
  const strip = (z0: number, z1: number, y: number, scale: number) =>
    quad([-long, y, z0], [long, y, z0], [long, y, z1], [-long, y, z1], (2 * long) / scale, (z0 - z1) / scale);
  builder.object('/World/Road', [paint(strip(2, -1.6, 0, 2), dirt)]);
  builder.object('/World/Grass', [paint(strip(16, -60, -0.02, 3), grass)]);

  const milestone: Part = [
    paint(
      turned(
        [
          [0.16, 0],
          [0.16, 0.62],
          [0.13, 0.72],
          [0.06, 0.79],
          [0, 0.81],
        ],
        12,
      ),
      stone,
    ),
    paint(
      turned(
        [
          [0.165, 0.42],
          [0.165, 0.56],
        ],
        12,
      ),
      red,
    ),
  ];
  for (let k = -6; k <= 6; k++)
    builder.object(`/World/Milestone${k + 6}`, placePart(milestone, place([3 * k, 0, 1.7])));

  const z = -7.4;
  builder.object('/World/Wall', [
    paint(block(2 * long, 1.5, 0.4, 0.5, [0, 0, z]), wall),
    paint(join([block(2 * long, 0.12, 0.6, 0.5, [0, 1.5, z]), ...pillars(long, z)]), stone),
  ]);
  trees(builder, z - 4);
}

const pillars = (long: number, z: number): Mesh[] =>
  Array.from({ length: 2 * Math.floor(long / 9) + 1 }, (_, i) => {
    const x = 9 * (i - Math.floor(long / 9));
    return join([
      block(0.7, 1.75, 0.7, 1, [x, 0, z]),
      moved(sphere(0.3, { segments: 14, rings: 8, axis: 'Y' }), [x, 2, z]),
    ]);
  });

function trees(builder: SceneBuilder, z: number): void {
  const bark = builder.material('bark', '#6a5340', { roughness: 1 });
  const leaf = builder.material('leaf', '#55803f', { roughness: 0.95, like: 'leaf' });
  const next = random(17);
  for (let k = 0; k < 12; k++) {
    const [x, depth] = [6 * (k - 7) + next(), z - 3 * next()];
    builder.object(
      `/World/Poplar${k}`,
      placePart(poplar(7.5 + 3 * next(), bark, leaf, k), place([x, -0.02, depth], k)),
    );
  }
}

function gravel(color: string, name: string) {
  const next = random(name.length);
  const canvas = new Canvas(128, 128, color).grain(0.08, 1, 2);
  for (let i = 0; i < 260; i++) {
    const [x, y, s] = [next() * 126, next() * 126, 1 + next() * 2];
    canvas.rect(x, y, x + s, y + s, tone(color, 0.8 + 0.45 * next()));
  }
  return canvas.texture(name);
}
