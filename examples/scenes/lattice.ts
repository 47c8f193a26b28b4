import { normalize, type Vec3 } from '../../src/math/vec3.ts';
import { makeMesh } from '../../src/scene/mesh/makeMesh.ts';
import { box } from '../../src/scene/mesh/primitives.ts';
import type { Light, Mesh, Scene } from '../../src/scene/types.ts';
import { paint, SceneBuilder, sky } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, smoothRamp } from '../kit/flight.ts';
import { checker, linear } from '../kit/paint.ts';
import { join, moved, quad } from '../kit/parts.ts';

/** Distance between joints [m], and how many there are. */
const STEP = 4;
const COUNT: Vec3 = [5, 5, 11];
const FIRST: Vec3 = [-8, -8, 0];
const last = (axis: number): number => (COUNT[axis] - 1) * STEP;
/** Position of joint (i, j, k); k increases away from the start of the flight. */
const joint = (i: number, j: number, k: number): Vec3 => [FIRST[0] + i * STEP, FIRST[1] + j * STEP, -k * STEP];

export const scene: ExampleScene = { name: 'lattice', make };

function make(): Scene {
  const builder = new SceneBuilder();
  bars(builder);
  joints(builder);
  const tiles = builder.material('tiles', '#ffffff', {
    texture: checker('#6f7780', '#454d59', 'tiles', 2, 32),
    roughness: 0.9,
  });
  const y = FIRST[1] - 3;
  builder.object('/World/Ground', [paint(quad([-20, y, 14], [20, y, 14], [20, y, -58], [-20, y, -58], 5, 9), tiles)]);

  const [from, to] = [0, 8.9];
  const way = (t: number) => 8 - 45.5 * smoothRamp(t / to, 0.45);
  const eye = (t: number): Vec3 => [2 + 0.35 * Math.sin(0.5 * t), 2 + 0.3 * Math.cos(0.4 * t), way(t)];
  const target = (t: number): Vec3 => [2, 2, way(t) - 20];
  const hints = {
    speedOfLight: 10,
    title: 'Lattice',
    lookFor:
      'Bars along your way stay straight; the red and cream ones across it bend into hyperbolas, and the joints stay round. At 0.9 c even bars that are already behind you come into view in front.',
    openAt: 3.7,
  };
  // Late dusk: at 0.9 c light from ahead has 4.4 times the frequency and is hundreds of times brighter.
  const [r, g, b] = linear('#ffe2bd');
  const lights: Light[] = [
    {
      kind: 'distant',
      path: '/World/Sun',
      direction: normalize([-0.5, -0.6, -0.62]),
      color: [2 * r, 2 * g, 2 * b],
    },
    sky('#2c3d60', '#4a5872', '#2b323f'),
  ];
  const flight = camera({ from, to, fovY: 66, position: eye, target });
  return builder.finish('lattice', hints, [from, to], [flight], lights);
}

/** Bars as long as the lattice, with a colour per direction. */
function bars(builder: SceneBuilder): void {
  const looks: readonly (readonly [name: string, color: string])[] = [
    ['Across', '#b4503a'],
    ['Upright', '#e6dcc4'],
    ['Along', '#2f6f73'],
  ];
  looks.forEach(([name, color], axis) => {
    const material = builder.material(name.toLowerCase(), color, { roughness: 0.45 });
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    const size = [0.16, 0.16, 0.16].map((x, k) => (k === axis ? last(axis) + 1.2 : x)) as [number, number, number];
    const rod = chamfered(size, axis);
    const rods: Mesh[] = [];
    for (let a = 0; a < COUNT[u]; a++)
      for (let b = 0; b < COUNT[v]; b++) {
        const place = [0, 0, 0];
        [place[axis], place[u], place[v]] = [(COUNT[axis] - 1) / 2, a, b];
        rods.push(moved(rod, joint(place[0], place[1], place[2])));
      }
    builder.object(`/World/Bars${name}`, [paint(join(rods), material)]);
  });
}

/** A closed bar of octagonal cross-section along an axis. */
function chamfered(size: Vec3, axis: number): Mesh {
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  const [r, s] = [size[u] / 2, size[u] * 0.2];
  const section = [
    [r, s],
    [s, r],
    [-s, r],
    [-r, s],
    [-r, -s],
    [-s, -r],
    [s, -r],
    [r, -s],
  ];
  const points = [-1, 1].flatMap((end) =>
    section.flatMap(([a, b]) => {
      const p = [0, 0, 0];
      [p[axis], p[u], p[v]] = [(end * size[axis]) / 2, a, b];
      return p;
    }),
  );
  const sides = section.flatMap((_, i) => [i, (i + 1) % 8, 8 + ((i + 1) % 8), 8 + i]);
  const caps = [7, 6, 5, 4, 3, 2, 1, 0, 8, 9, 10, 11, 12, 13, 14, 15];
  const faceCounts = [...section.map(() => 4), 8, 8];
  return makeMesh({ points, faceCounts, faceIndices: [...sides, ...caps], smoothAngle: 1 }).mesh;
}

function joints(builder: SceneBuilder): void {
  const brass = builder.material('joint', '#d2a24c', { roughness: 0.3, metallic: 0.5 });
  const ball = globule(0.3);
  const all: Mesh[] = [];
  for (let i = 0; i < COUNT[0]; i++)
    for (let j = 0; j < COUNT[1]; j++) for (let k = 0; k < COUNT[2]; k++) all.push(moved(ball, joint(i, j, k)));
  builder.object('/World/Joints', [paint(join(all), brass)]);
}

/** A sphere of few points: an inflated cube with 2 × 2 faces per side. */
function globule(radius: number): Mesh {
  const cube = box([2, 2, 2]);
  const points: number[] = [];
  const faceIndices: number[] = [];
  for (let face = 0; face < 6; face++) {
    const corner = (k: number): Vec3 => [
      cube.positions[3 * (4 * face + k)],
      cube.positions[3 * (4 * face + k) + 1],
      cube.positions[3 * (4 * face + k) + 2],
    ];
    const [a, b, d] = [corner(0), corner(1), corner(3)];
    const first = points.length / 3;
    for (let j = 0; j < 3; j++)
      for (let i = 0; i < 3; i++) {
        // Equal angles, so that the faces have similar sizes.
        const [s, t] = [i, j].map((x) => (Math.tan((Math.PI / 4) * (x - 1)) + 1) / 2);
        points.push(
          ...normalize([0, 1, 2].map((k) => a[k] + (b[k] - a[k]) * s + (d[k] - a[k]) * t) as unknown as Vec3),
        );
      }
    for (const q of [0, 1, 3, 4]) faceIndices.push(first + q, first + q + 1, first + q + 4, first + q + 3);
  }
  const normals = { per: 'point' as const, values: points };
  const scaled = points.map((x) => x * radius);
  return makeMesh({ points: scaled, faceCounts: new Array<number>(24).fill(4), faceIndices, normals }).mesh;
}
