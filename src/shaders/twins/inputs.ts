import type { Random } from '../../math/random.ts';
import { addScaled, cross, dot, length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import type { Stratum } from './twin.ts';

export type Aim = 'anywhere' | 'ahead' | 'behind';

const GAMMAS = [1, 1.0000001, 1.001, 1.05, 2, 7, 22, 100, 1000];
export const AIMS: readonly Aim[] = ['anywhere', 'ahead', 'behind'];
/** Speeds of objects [c]; 0.999999 (γ = 707) is the fastest that is supported. */
export const SPEEDS = [0, 0.1, 0.5, 0.9, 0.999, 0.999999];

export interface ObserverStratum extends Stratum {
  readonly aim: Aim;
}

/** Observers from rest to γ = 1000, looking anywhere, near the forward axis, and near the backward axis. */
export const observers: readonly ObserverStratum[] = GAMMAS.flatMap((gamma) =>
  AIMS.map((aim) => ({ name: `γ ${gamma}, ${aim}`, gamma, aim })),
);

export function unitVector(random: Random): Vec3 {
  const z = 2 * random() - 1;
  const phi = 2 * Math.PI * random();
  const s = Math.sqrt(1 - z * z);
  return [s * Math.cos(phi), s * Math.sin(phi), z];
}

/** A random number from `least` to `most`, uniform in the logarithm. */
export const logUniform = (random: Random, least: number, most: number): number => least * (most / least) ** random();

/** A random unit vector, or one at 1.5e-5 … 1.5 rad (uniform in the logarithm) from `axis` or −`axis`. */
export function aimedDirection(random: Random, axis: Vec3, aim: Aim): Vec3 {
  if (aim === 'anywhere') return unitVector(random);
  const angle = logUniform(random, 1.5e-5, 1.5);
  const side = unitVector(random);
  const across = normalize(cross(axis, side), [1, 0, 0]);
  return addScaled(scale(axis, aim === 'ahead' ? Math.cos(angle) : -Math.cos(angle)), across, Math.sin(angle));
}

/** γβ of the observer and a point 0.1 m to 100 km away, sometimes at distance 0. */
export function observerInput(random: Random, { gamma, aim }: ObserverStratum): { u: Vec3; n: Vec3; dx: Vec3 } {
  const axis = unitVector(random);
  const n = aimedDirection(random, axis, aim);
  return {
    u: scale(axis, Math.sqrt((gamma - 1) * (gamma + 1))),
    n,
    dx: scale(n, random() < 0.05 ? 0 : logUniform(random, 0.1, 1e5)),
  };
}

/** (v, 1 − v²) for the speed β. */
export const velocityInput = (direction: Vec3, beta: number): readonly number[] => [
  ...scale(direction, beta),
  (1 - beta) * (1 + beta),
];

export const gammaOf = (u: Vec3): number => Math.sqrt(1 + dot(u, u));
export const withLength = (v: Vec3): readonly number[] => [...v, length(v)];
export const vec3At = (input: readonly number[], texel: number): Vec3 => [
  input[4 * texel],
  input[4 * texel + 1],
  input[4 * texel + 2],
];

/** `each` cases per stratum. */
export function casesOf<S extends Stratum>(
  strata: readonly S[],
  each: number,
  make: (stratum: S) => readonly number[],
): { stratum: S; input: readonly number[] }[] {
  return strata.flatMap((stratum) => Array.from({ length: each }, () => ({ stratum, input: make(stratum) })));
}
