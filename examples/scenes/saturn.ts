import { fromAxisAngle, multiply, rotate } from '../../src/math/quat.ts';
import { random } from '../../src/math/random.ts';
import { normalize, type Vec3 } from '../../src/math/vec3.ts';
import { revolve, type SurfaceBand, sphere } from '../../src/scene/mesh/primitives.ts';
import { brightStars } from '../../src/scene/stars/brightStars.ts';
import { EQUATORIAL } from '../../src/scene/stars/equatorial.ts';
import type { Light, Mesh, Scene } from '../../src/scene/types.ts';
import { paint, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, sampled, smoothRamp } from '../kit/flight.ts';
import { Canvas, linear, rgb } from '../kit/paint.ts';
import { sized } from '../kit/parts.ts';

/** Equatorial radius of the model [m]; the rings keep Saturn's proportions. */
const R = 5;
const TILT = fromAxisAngle([0.25, 0, 1], 0.42);

/** Inner and outer radius in planet radii, and colour, of the main rings (after the Voyager profiles). */
const rings: readonly (readonly [number, number, string])[] = [
  [1.24, 1.34, '#6f675c'],
  [1.34, 1.42, '#8a8072'],
  [1.42, 1.52, '#a3967f'],
  [1.53, 1.66, '#d6c6a4'],
  [1.66, 1.8, '#e8dab8'],
  [1.8, 1.94, '#d9c9a6'],
  [2.03, 2.12, '#b9ad97'],
  [2.12, 2.21, '#c4b8a0'],
  [2.225, 2.27, '#a89d8a'],
];

export const scene: ExampleScene = { name: 'saturn', make };

function make(): Scene {
  const builder = new SceneBuilder();
  planet(builder);
  moons(builder);
  const [from, to] = [0, 20];
  const way = (t: number) => 62 - 118 * smoothRamp(t / to, 0.32);
  const flight = camera({
    from,
    to,
    fovY: 50,
    position: (t) => [-15.5, 4.2 + 1.2 * Math.cos(0.2 * t), way(t)],
    target: (t) => [-5 * smoothRamp(t / to, 0.4), 1.2, way(t) - 34],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Saturn',
    lookFor:
      'A model as wide as a house, in a world where light walks. Passing at nearly 0.9 c, the globe keeps its round outline, hardly changed, while the rings are drawn askew, their far side running ahead of the near one, and the stars crowd ahead of you.',
    openAt: 5,
  };
  const [r, g, b] = linear('#fff4e2');
  const lights: Light[] = [
    { kind: 'distant', path: '/World/Sun', direction: normalize([0.72, -0.3, -0.45]), color: [r * 4, g * 4, b * 4] },
    { kind: 'stars', path: '/World/Stars', stars: brightStars(), orientation: EQUATORIAL, gain: 40 },
  ];
  return builder.finish('saturn', hints, [from, to], [flight], lights);
}

function planet(builder: SceneBuilder): void {
  const cloud = builder.material('cloud', '#ffffff', { texture: clouds(), roughness: 0.9 });
  const ball = sized(sphere(R, { segments: 72, rings: 36, axis: 'Y' }), [1, 0.902, 1]);
  const spin = sampled(0, 20, 24, (t) => ({
    position: [0, 0, 0],
    orientation: multiply(TILT, fromAxisAngle([0, 1, 0], 0.9 * t)),
  }));
  builder.object('/World/Planet', [paint(ball, cloud)], spin);
  const bands = rings.map(([inner, outer, color], i) =>
    paint(ring(inner * R, outer * R), builder.material(`ring${i}`, color, { roughness: 0.95 })),
  );
  builder.object('/World/Rings', bands, { kind: 'static', pose: { position: [0, 0, 0], orientation: TILT } });
}

function ring(inner: number, outer: number): Mesh {
  const middle = (inner + outer) / 2;
  const flat = (a: number, b: number): SurfaceBand => ({
    from: [a, 0],
    to: [b, 0],
    fromNormal: [0, 1],
    toNormal: [0, 1],
    v: [0, 1],
  });
  // From the outside inwards, so that the lit face is the upper one; double-sided.
  return { ...revolve([flat(outer, middle), flat(middle, inner)], 160, 'Y'), doubleSided: true };
}

/** Belts, zones and a few ovals, so that its rotation is visible. */
function clouds() {
  const belts = [
    '#c9b48c',
    '#e6d5ab',
    '#d8c091',
    '#efe2bf',
    '#cfb382',
    '#e3cf9f',
    '#b89f76',
    '#dcc79a',
    '#9c8b72',
    '#b6aa90',
  ];
  const next = random(3);
  const ovals = Array.from({ length: 9 }, () => ({ u: next(), v: 0.25 + 0.5 * next(), r: 0.012 + 0.02 * next() }));
  const mix = (a: string, b: string, s: number) =>
    `#${rgb(a)
      .map((x, i) =>
        Math.round(x + (rgb(b)[i] - x) * s)
          .toString(16)
          .padStart(2, '0'),
      )
      .join('')}`;
  return new Canvas(384, 192, '#e6d5ab')
    .shade((u, v) => {
      const wave = 0.006 * Math.sin(2 * Math.PI * (5 * u + 3 * v)) + 0.004 * Math.sin(2 * Math.PI * (11 * u - 7 * v));
      const latitude = Math.abs(v + wave - 0.5) * 2 * (belts.length - 1);
      const i = Math.min(belts.length - 2, Math.floor(latitude));
      const s = latitude - i;
      const base = mix(belts[i], belts[i + 1], s * s * (3 - 2 * s));
      const spot = ovals.some(
        (o) => Math.hypot(Math.min(Math.abs(u - o.u), 1 - Math.abs(u - o.u)), (v - o.v) * 1.6) < o.r,
      );
      return spot ? mix(base, '#fff6e0', 0.75) : base;
    })
    .grain(0.012, 2)
    .texture('clouds');
}

function moons(builder: SceneBuilder): void {
  const moon = (name: string, color: string, radius: number, orbit: number, rate: number, phase: number) => {
    const material = builder.material(name, '#ffffff', { texture: craters(color, name), roughness: 1 });
    const motion = sampled(0, 20, 24, (t) => {
      const a = phase + rate * t;
      const position: Vec3 = rotate(TILT, [orbit * Math.cos(a), 0, orbit * Math.sin(a)]);
      return { position, orientation: fromAxisAngle([0, 1, 0], -a) };
    });
    builder.object(`/World/${name}`, [paint(sphere(radius, { segments: 32, rings: 16, axis: 'Y' }), material)], motion);
  };
  moon('Rhea', '#b9b2a6', 0.5, 14, 0.5, 2.1);
  moon('Titan', '#d9a860', 0.85, 18.5, -0.42, 3.9);
  moon('Tethys', '#cfd2d4', 0.36, 12.4, 0.6, 0.4);
}

function craters(color: string, name: string) {
  const next = random(name.length);
  const pits = Array.from({ length: 40 }, () => ({ u: next(), v: next(), r: 0.01 + 0.03 * next() }));
  const [r, g, b] = rgb(color);
  return new Canvas(96, 48, color)
    .shade((u, v) => {
      const pit = pits.find((p) => Math.hypot(u - p.u, (v - p.v) / 2) < p.r);
      const k = pit ? 0.78 : 1;
      return `#${[r, g, b]
        .map((x) =>
          Math.round(x * k)
            .toString(16)
            .padStart(2, '0'),
        )
        .join('')}`;
    })
    .grain(0.05, 2)
    .texture(name);
}
