import type { State, System } from '../dynamics/system.ts';
import { length, normalize, ZERO } from '../math/vec3.ts';
import type { ForceRows } from './forceRows.ts';
import type { SplittingStage } from './splittingStages.ts';

/**
 * Layout of the shader's structures by WGSL's rules: a vec3 takes the space of four words, unless a scalar follows it.
 */

/** 32-bit words of `Body`, `Origin`, `VelocityChange`, `Obstacle`, and of `World`. */
export const WORDS = { body: 12, origin: 8, change: 8, obstacle: 16, world: 12 } as const;
/** Stride of `SplittingStage` [bytes]: the largest alignment that a device may require. */
export const STAGE_BYTES = 256;

export function packBodies(
  { masses, charges, pinned }: System,
  { pointOfRow, rowStarts, springCounts, constantForces }: ForceRows,
): ArrayBuffer {
  const bodies = new ArrayBuffer(4 * WORDS.body * masses.length);
  const [floats, words] = [new Float32Array(bodies), new Uint32Array(bodies)];
  pointOfRow.forEach((point, place) => {
    const at = WORDS.body * place;
    floats.set(constantForces.subarray(3 * place, 3 * place + 3), at);
    floats[at + 3] = masses[point];
    floats[at + 4] = charges?.[point] ?? 0;
    words[at + 5] = rowStarts[place];
    words[at + 6] = rowStarts[place] + springCounts[place];
    words[at + 7] = rowStarts[place + 1];
    words[at + 8] = pinned[point];
  });
  return bodies;
}

export function packObstacles({ obstacles }: ForceRows): Float32Array<ArrayBuffer> {
  const all = new Float32Array(WORDS.obstacle * Math.max(1, obstacles.length));
  obstacles.forEach(({ center: middle, orientation, halfExtents: half = [-1, -1, -1] }, i) => {
    const rounded = middle.map(Math.fround);
    const rest = middle.map((value, k) => value - rounded[k]);
    all.set([...rounded, 0, ...rest, 0, ...orientation, ...half, 0], WORDS.obstacle * i);
  });
  return all;
}

/** `maxTravel`: maximum travel of each point [m]. */
export function packWorld(
  { c, magneticField = ZERO }: System,
  { pointOfRow, longRowCount, near }: ForceRows,
  maxTravel: number,
) {
  const world = new ArrayBuffer(4 * WORDS.world);
  const [floats, words] = [new Float32Array(world), new Uint32Array(world)];
  floats.set([...normalize(magneticField, ZERO), length(magneticField), 1 / (c * c)]);
  words.set([pointOfRow.length, pointOfRow.length - longRowCount, Number(near !== undefined)], 5);
  floats.set([near?.strength ?? 0, near?.cutoff ?? 0, maxTravel * maxTravel], 8);
  return world;
}

export const packStage = ({ kick, drift, damp, after, before }: SplittingStage): Float32Array<ArrayBuffer> =>
  Float32Array.of(kick, drift, damp, after, before);

/** Splits a state, by row: into origins rounded to 32 bits, and the remaining changes. */
export function splitState({ x, p }: State, pointAt: Uint32Array, origins: Float32Array, changes: Float32Array): void {
  for (let place = 0, at = 0; place < pointAt.length; place++, at += WORDS.origin) {
    const j = 3 * pointAt[place];
    for (let k = 0; k < 3; k++) {
      origins[at + k] = x[j + k];
      changes[at + k] = x[j + k] - origins[at + k];
      origins[at + 4 + k] = p[j + k];
      changes[at + 4 + k] = p[j + k] - origins[at + 4 + k];
    }
  }
}

/** The state as the sum of origins and changes, in 64 bits. */
export function joinState(origins: Float32Array, changes: Float32Array, pointAt: Uint32Array, { x, p }: State): void {
  for (let place = 0, at = 0; place < pointAt.length; place++, at += WORDS.origin) {
    const j = 3 * pointAt[place];
    for (let k = 0; k < 3; k++) {
      x[j + k] = origins[at + k] + changes[at + k];
      p[j + k] = origins[at + 4 + k] + changes[at + 4 + k];
    }
  }
}
