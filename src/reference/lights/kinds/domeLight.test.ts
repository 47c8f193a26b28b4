import { describe, expect, it } from 'vitest';
import { lambert, lit, look, mirror } from '../../../../tests/support/lightKit.ts';
import { toHalf } from '../../../math/half.ts';
import { fromAxisAngle, rotate } from '../../../math/quat.ts';
import { random } from '../../../math/random.ts';
import { addScaled, dot, negate, normalize, type Vec3, ZERO } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { aberrate } from '../../../physics/optics/aberration.ts';
import { observerDoppler } from '../../../physics/optics/doppler.ts';
import { makeMaterial } from '../../../scene/defaults.ts';
import { directionFromLatLong, domeAxes, latLongFromDirection } from '../../../scene/lights/latLong.ts';
import { plane } from '../../../scene/mesh/primitives.ts';
import type { DomeLight, Material } from '../../../scene/types.ts';
import { filterFromRgb } from '../../../spectrum/reflectance/spectralFilter.ts';
import { brdfOf, evaluateBrdf } from '../../materials/brdf.ts';
import { skySampler } from './skySampler.ts';

const [W, H] = [64, 32];
const options = { bounces: 1, mirrors: false, glass: false };

/** A dome with a grey radiance per texel. */
const domeOf = (radiance: (column: number, row: number) => number, given: Partial<DomeLight> = {}): DomeLight => ({
  kind: 'dome',
  path: '/dome',
  color: [1, 1, 1],
  texture: {
    name: 'dome',
    width: W,
    height: H,
    data: Uint16Array.from({ length: 4 * W * H }, (_, i) =>
      toHalf(i % 4 === 3 ? 1 : radiance((i >> 2) % W, Math.floor((i >> 2) / W))),
    ),
    colorSpace: 'linear',
    filter: 'linear',
    wrapS: 'repeat',
    wrapT: 'clamp',
  },
  ...given,
});

/** A sun of one texel, at column and row, in a dim sky. */
const [COLUMN, ROW] = [41, 7];
const [SUN, DIM] = [40_000, 0.25];
const sunny = (given: Partial<DomeLight> = {}): DomeLight =>
  domeOf((x, y) => (x === COLUMN && y === ROW ? SUN : DIM), given);

/** Its radiance from the direction n on the dome's axes: bilinear between texel centres. */
function sunAt(n: Vec3): number {
  const [u, v] = latLongFromDirection(n);
  const across = Math.max(1 - Math.abs(u * W - COLUMN - 0.5), 0);
  const down = Math.max(1 - Math.abs((1 - v) * H - ROW - 0.5), 0);
  return DIM + (SUN - DIM) * across * down;
}

/** ∫ f(n) dΩ on the dome's axes, with finer steps near the sun. */
function integral(f: (n: Vec3) => number): number {
  let sum = 0;
  const part = (left: number, right: number, top: number, bottom: number, steps: number): void => {
    for (let j = 0; j < steps; j++)
      for (let i = 0; i < steps; i++) {
        const longitude = Math.PI * (1 - (2 * (left + ((right - left) * (i + 0.5)) / steps)) / W);
        const angle = (Math.PI * (top + ((bottom - top) * (j + 0.5)) / steps)) / H;
        const n: Vec3 = [Math.sin(angle) * Math.sin(longitude), Math.cos(angle), Math.sin(angle) * Math.cos(longitude)];
        const cell = (((2 * Math.PI * (right - left)) / W) * (Math.PI * (bottom - top))) / H / steps ** 2;
        sum += f(n) * Math.sin(angle) * cell;
      }
  };
  for (let y = 0; y < H; y++)
    for (let x = 0; x < W; x++) part(x, x + 1, y, y + 1, Math.abs(x - COLUMN) < 2 && Math.abs(y - ROW) < 2 ? 24 : 3);
  return sum;
}

describe('the sampler of a dome', () => {
  const turned = sunny({ orientation: fromAxisAngle(normalize([1, 2, 3]), 1.3) });

  it('has a density of integral 1 and samples directions by it', () => {
    const bright = skySampler(turned)!;
    const [x, y, z] = domeAxes(turned);
    const inWorld = (n: Vec3): Vec3 => addScaled(addScaled(addScaled([0, 0, 0], x, n[0]), y, n[1]), z, n[2]);
    expect(integral((n) => bright.pdf(inWorld(n)))).toBeCloseTo(1, 3);
    // The fraction of samples on one side of a plane is the integral of the density there.
    const numbers = random(5);
    const side = (n: Vec3): number => (dot(n, normalize([0.4, -0.3, 0.2])) > 0.2 ? 1 : 0);
    const soft = skySampler(domeOf((column, row) => 2 + Math.sin(column / 5) * Math.cos(row / 9)))!;
    let counted = 0;
    for (let i = 0; i < 40_000; i++) counted += side(soft.sample(numbers)) / 40_000;
    expect(Math.abs(counted - integral((n) => soft.pdf(n) * side(n)))).toBeLessThan(0.01);
  });

  it('is undefined for a uniform sky, and has a probability of at most ½', () => {
    expect(skySampler(domeOf(() => 3))).toBeUndefined();
    expect(skySampler(turned)!.probability).toBe(0.5);
    expect(skySampler(domeOf((_, row) => (row < H / 2 ? 1.1 : 1)))!.probability).toBeLessThan(0.03);
  });
});

const floor = (material: Material) =>
  ({
    mesh: plane(1e3, 1e3),
    material,
    motion: { kind: 'static', pose: { position: [0, 0, 0], orientation: fromAxisAngle([1, 0, 0], -Math.PI / 2) } },
  }) as const;

describe('a small sun in a dome texture', () => {
  it('lights a matt floor with its irradiance/π, with little noise', () => {
    const scene = lit([floor(lambert(1))], [sunny()]);
    const expected = integral((n) => sunAt(n) * Math.max(n[1], 0)) / Math.PI;
    const seen = (seed: number, samples: number): number =>
      look(scene, { position: [0, 1, 0] }, [0, -1, 0], options, samples, { seed })[0];
    expect(Math.abs(seen(1, 4096) / expected - 1)).toBeLessThan(2e-3);
    const errors = Array.from({ length: 60 }, (_, seed) => seen(seed, 16) / expected - 1);
    expect(Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0) / 60)).toBeLessThan(0.04);
    expect(Math.abs(errors.reduce((sum, e) => sum + e, 0) / 60)).toBeLessThan(0.02);
  });

  it.each([
    ['a rough metal', mirror({ roughness: 0.5 }), 0],
    ['a glossy metal', mirror({ roughness: 0.15 }), 0],
    ['rough plastic', makeMaterial({ name: 'plastic', baseColor: [0.5, 0.5, 0.5], roughness: 0.6 }), 0],
    ['a moving matt surface', lambert(0.8), 0.6],
    ['a moving rough metal', mirror({ roughness: 0.4 }), -0.5],
  ] as const)('lights %s like the integral over all directions', (_, material, speed) => {
    const turn = fromAxisAngle(normalize([0.2, 1, 0.4]), 0.7);
    const dome = sunny({ orientation: turn });
    const motion = { kind: 'uniform', pose: floor(material).motion.pose, velocity: [speed, 0, 0] } as const;
    const scene = lit([{ ...floor(material), motion }], [dome]);
    // Seen from near the mirror direction of the sun.
    const sun = rotate(turn, directionFromLatLong((COLUMN + 0.5) / W, 1 - (ROW + 0.5) / H));
    const toward = normalize([sun[0] + 0.1, -sun[1], sun[2] - 0.1]);
    const u = properVelocity([speed, 0, 0]);
    const V = negate(aberrate(toward, u));
    const surface = {
      filter: filterFromRgb(material.baseColor),
      metallic: material.metallic,
      roughness: material.roughness,
      ior: material.ior ?? 1.5,
      normal: [0, 1, 0],
    } as const;
    const seenFrom = brdfOf(
      { ...surface, albedo: material.baseColor, opacity: 1, occlusion: 1, emissive: ZERO, uv: [0, 0] },
      V,
    );
    const sent = integral((local) => {
      const n = rotate(turn, local);
      // L′ dΩ′ = D⁴ L dΩ/D².
      const reflected = evaluateBrdf(seenFrom, aberrate(n, u));
      return reflected ? reflected.rgb[0] * observerDoppler(n, u) ** 2 * sunAt(local) : 0;
    });
    const D = 1 / observerDoppler(toward, u);
    const position: Vec3 = [-toward[0], -toward[1], -toward[2]];
    const seen = look(scene, { position }, toward, options, 4096)[0];
    expect(Math.abs(seen / (sent * D ** 4) - 1)).toBeLessThan(0.004);
  });
});
