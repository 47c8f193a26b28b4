import { fromAxisAngle, multiply } from '../../src/math/quat.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { sphere, torus } from '../../src/scene/mesh/primitives.ts';
import type { Mesh, Scene } from '../../src/scene/types.ts';
import { at, daylight, type Part, paint, place, placePart, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, smoothRamp } from '../kit/flight.ts';
import { Canvas, checker } from '../kit/paint.ts';
import { block, column, join, moved, quad, turned } from '../kit/parts.ts';
import { poplar } from '../kit/trees.ts';

const C = 10;
const RADIUS = 1.5;
/** Time at which the moving spheres pass their rings at x = 0 [s]. */
const MEETING = 6;
const HEIGHT = 2.9;

export const scene: ExampleScene = { name: 'sphere', make };

/** Lane (z), speed along x in units of c, and the colours of the sphere. */
const flyers: readonly (readonly [name: string, z: number, beta: number, dark: string, light: string])[] = [
  ['Half', 0, 0.5, '#2e6a74', '#eadfc6'],
  ['Fast', -6, 0.8, '#b4482f', '#f2e6cf'],
  ['Fastest', -12, 0.95, '#3a3560', '#e7d9b0'],
];

function make(): Scene {
  const builder = new SceneBuilder();
  terrace(builder);
  const ring = builder.material('ring', '#c79a50', { roughness: 0.35, metallic: 0.6 });
  const stone = builder.material('stone', '#d9d1c1', { roughness: 0.8 });
  for (const [name, z, beta, dark, light] of flyers) {
    const velocity: Vec3 = [beta * C, 0, 0];
    const pose = {
      position: [-velocity[0] * MEETING, HEIGHT, z] as Vec3,
      orientation: fromAxisAngle([0, 0, 1], -0.35),
    };
    builder.object(
      `/World/${name}`,
      globe(builder, name, dark, light),
      { kind: 'uniform', pose, velocity },
      { authoredIn: 'rest' },
    );
    gate(builder, name, z, ring, stone);
  }
  garden(builder, stone);
  const [from, to] = [0, 10];
  const flight = camera({
    from,
    to,
    fovY: 46,
    position: (t) => [7.6 - 2 * smoothRamp(t / to, 0.4), 4.4, 11.5 - 2 * smoothRamp(t / to, 0.4)],
    target: (t) => [-1.2 - 1.2 * smoothRamp(t / to, 0.4), 2.7, -3],
  });
  const hints = {
    speedOfLight: C,
    title: 'Sphere',
    lookFor:
      'Three balls fly through their rings at 0.5, 0.8 and 0.95 c. In the simultaneity view they are flattened; but what you see has an exactly circular outline, always. Only the meridians tell: you see round the back. Fly past the balls at rest: the same.',
    openAt: 7.3,
  };
  return builder.finish('sphere', hints, [from, to], [flight], daylight([-0.55, 0.8, 0.45]));
}

/** A sphere with meridians and parallels; its northern and southern parts differ, so that its apparent orientation is visible. */
function globe(builder: SceneBuilder, name: string, dark: string, light: string, radius = RADIUS): Part {
  const texture = new Canvas(384, 192, light)
    .shade((u, v) => {
      const [m, p] = [(u * 12) % 1, (v * 6) % 1];
      const line = Math.abs(m - 0.5) > 0.47 || Math.abs(p - 0.5) > 0.47;
      if (line) return '#2a2622';
      const field = (Math.floor(u * 12) + Math.floor(v * 6)) % 2 === 0;
      return u < 0.08333 && field ? '#e0a93b' : field ? dark : light;
    })
    .texture(`globe_${name.toLowerCase()}`);
  const material = builder.material(`globe${name}`, '#ffffff', { texture, roughness: 0.35 });
  return [paint(sphere(radius, { segments: 40, rings: 20, axis: 'Y' }), material)];
}

/** An upright ring on a stepped foot, just large enough for the sphere. */
function gate(builder: SceneBuilder, name: string, z: number, ring: number, stone: number): void {
  const hoop = moved(torus(RADIUS + 0.3, 0.12, { segments: 40, rings: 8, axis: 'X' }), [0, HEIGHT, 0]);
  const foot = HEIGHT - RADIUS - 0.42;
  const base = turned(
    [
      [0.9, 0],
      [0.9, 0.2],
      [0.66, 0.3],
      [0.42, 0.45],
      [0.36, foot - 0.25],
      [0.5, foot - 0.1],
      [0.5, foot + 0.04],
      [0, foot + 0.04],
    ],
    20,
  );
  builder.object(`/World/Gate${name}`, placePart([paint(hoop, ring), paint(base, stone)], place([0, 0, z])));
}

/** Spheres at rest on plinths along both sides. */
function garden(builder: SceneBuilder, stone: number): void {
  const looks: readonly (readonly [string, string])[] = [
    ['#8a3f3a', '#eadfc6'],
    ['#4d6b4f', '#eadfc6'],
  ];
  const plinth = join([
    block(1.5, 0.25, 1.5),
    block(1.1, 0.75, 1.1, 1, [0, 0.25, 0]),
    block(1.4, 0.18, 1.4, 1, [0, 1, 0]),
  ]);
  looks.forEach(([dark, light], side) => {
    const ball = globe(builder, side === 0 ? 'Left' : 'Right', dark, light, 0.9);
    for (let k = 0; k < 3; k++) {
      const [x, z] = side === 0 ? [-8.5 - 4 * k, 2.8 - 6 * k] : [5.2 + 4.4 * k, 2.8 - 6 * k];
      const name = `${side === 0 ? 'Left' : 'Right'}${k}`;
      builder.object(`/World/Plinth${name}`, placePart([paint(plinth, stone)], place([x, 0, z])));
      const turn = multiply(fromAxisAngle([0, 0, 1], 0.4), fromAxisAngle([0, 1, 0], 1.3 * k));
      builder.object(`/World/Ball${name}`, ball, at([x, 1.18 + 0.88, z], turn));
    }
  });
}

/** A paved terrace with three lanes, steps, and a colonnade at the back. */
function terrace(builder: SceneBuilder): void {
  const paving = builder.material('paving', '#ffffff', {
    texture: checker('#d3cab8', '#b3a692', 'paving', 2, 32),
    roughness: 0.85,
  });
  const lane = builder.material('lane', '#5b6f78', { roughness: 0.5 });
  const border = builder.material('border', '#e8e1d1', { roughness: 0.7 });
  const marble = builder.material('marble', '#ece6da', { roughness: 0.55 });
  const lawn = builder.material('lawn', '#7f955f', { roughness: 1, like: 'leaf' });
  const long = 60;
  const strip = (z0: number, z1: number, y: number, x = long): Mesh =>
    quad([-x, y, z0], [x, y, z0], [x, y, z1], [-x, y, z1], x / 2, (z0 - z1) / 4);
  builder.object('/World/Paving', [paint(strip(16, -18, 0), paving)]);
  builder.object('/World/Lanes', [
    paint(join(flyers.map(([, z]) => strip(z + 0.8, z - 0.8, 0.012))), lane),
    paint(join(flyers.flatMap(([, z]) => [strip(z + 0.95, z + 0.8, 0.016), strip(z - 0.8, z - 0.95, 0.016)])), border),
  ]);
  builder.object('/World/Lawn', [paint(strip(90, -140, -0.3, 140), lawn)]);
  const steps = [0, 1, 2].map((k) => block(2 * long, 0.22, 4.4 - 0.5 * k, 0.5, [0, 0.22 * k, -20.2 - 0.25 * k]));
  const beam = [block(2 * long, 0.5, 1.1, 0.5, [0, 5.86, -21]), block(2 * long, 0.24, 1.5, 0.5, [0, 6.36, -21])];
  builder.object('/World/Steps', [paint(join([...steps, ...beam]), marble)]);
  const bark = builder.material('bark', '#6a5340', { roughness: 1 });
  const leaf = builder.material('leaf', '#4f7448', { roughness: 0.95, like: 'leaf' });
  for (let k = 0; k < 15; k++) {
    const part = placePart(
      poplar(8.5 + 1.5 * ((k * 0.618) % 1), bark, leaf, k),
      place([5.4 * (k - 9) + 2.7, -0.3, -27]),
    );
    builder.object(`/World/Cypress${k}`, part);
  }
  const pillar = column(5.2, 0.4);
  for (let k = 0; k < 9; k++)
    builder.object(`/World/Column${k}`, placePart([paint(pillar, marble)], place([5.4 * (k - 4), 0.66, -21])));
}
