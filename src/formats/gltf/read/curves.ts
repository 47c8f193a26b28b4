import type { AnimationSampler } from '@gltf-transform/core';
import { normalizeQuat, type Quat, slerp } from '../../../math/quat.ts';
import { type LocalizedText, msg } from '../../../messages/message.ts';
import { gltfError } from '../context.ts';
import { floatsOf } from './accessors.ts';

/** One animated quantity: `width` numbers at any time; constant before the first and after the last key. */
export interface AnimationCurve {
  /** Key times [s], rising. */
  readonly times: Float64Array;
  /** Times at which the value jumps [s]. */
  readonly jumps: readonly number[];
  at(t: number): number[];
}

/** Evaluates a sampler, as in glTF 2.0 appendix C ("Animation sampler interpolation modes"). */
export function makeCurve(
  entry: string,
  what: LocalizedText,
  sampler: AnimationSampler,
  width: number,
  isRotation: boolean,
): AnimationCurve {
  const times = Float64Array.from(floatsOf(sampler.getInput()!));
  const values = Float64Array.from(floatsOf(sampler.getOutput()!));
  const kind = sampler.getInterpolation();
  const isCubic = kind === 'CUBICSPLINE';
  if (isRotation && !isCubic) normalizeQuats(values);
  const needed = times.length * width * (isCubic ? 3 : 1);
  if (times.length === 0 || values.length < needed) {
    const message = msg`${values.length} values for ${times.length} keys, ${needed} are needed; export it again`;
    throw gltfError(entry, 'gltf.bad-animation', what, message);
  }
  times.forEach((t, i) => {
    if (Number.isFinite(t) && (i === 0 || t >= times[i - 1])) return;
    throw gltfError(
      entry,
      'gltf.bad-animation',
      what,
      msg`key ${i} is at ${t} s after ${times[i - 1] ?? '–'} s; keys must rise`,
    );
  });
  const value = (key: number, part = 0): number[] => {
    const from = (isCubic ? key * 3 + part : key) * width;
    const out = new Array<number>(width);
    for (let i = 0; i < width; i++) out[i] = values[from + i];
    return out;
  };
  const between = isCubic ? cubic(value, isRotation) : linear(value, isRotation);
  const own = isCubic ? 1 : 0;
  const tidy = (v: number[]): number[] => (isRotation ? [...normalizeQuat(asQuat(v))] : v);
  const at = (t: number): number[] => {
    const key = keyBefore(times, t);
    const span = key >= 0 ? times[key + 1] - times[key] : Number.NaN;
    if (key < 0) return tidy(value(0, own));
    if (kind === 'STEP' || !(span > 0)) return tidy(value(key, own));
    return between(key, (t - times[key]) / span, span);
  };
  return { times, jumps: jumpsOf(times, kind === 'STEP', (key) => tidy(value(key, own))), at };
}

function normalizeQuats(values: Float64Array): void {
  for (let i = 0; i + 3 < values.length; i += 4)
    values.set(normalizeQuat([values[i], values[i + 1], values[i + 2], values[i + 3]]), i);
}

const asQuat = (v: readonly number[]): Quat => [v[0], v[1], v[2], v[3]];

/** The last key at or before `t`; −1 before the first. */
function keyBefore(times: Float64Array, t: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/** Steps, and keys that share a time, where the value changes. */
function jumpsOf(times: Float64Array, isStepped: boolean, value: (key: number) => number[]): number[] {
  const jumps: number[] = [];
  for (let key = 1; key < times.length; key++) {
    if (!isStepped && times[key] > times[key - 1]) continue;
    const before = value(key - 1);
    if (value(key).some((x, i) => x !== before[i])) jumps.push(times[key]);
  }
  return jumps;
}

type KeyInterpolation = (key: number, s: number, span: number) => number[];
type KeyValue = (key: number, part?: number) => number[];

const linear = (value: KeyValue, isRotation: boolean): KeyInterpolation => {
  return (key, s) => {
    const [a, b] = [value(key), value(key + 1)];
    if (isRotation) return slerp(asQuat(a), asQuat(b), s) as unknown as number[];
    return a.map((x, i) => x + (b[i] - x) * s);
  };
};

/** Hermite: p(s) = (2s³−3s²+1) v₀ + (s³−2s²+s) Δt b₀ + (3s²−2s³) v₁ + (s³−s²) Δt a₁; parts of a key: a (in), v, b (out). */
const cubic = (value: KeyValue, isRotation: boolean): KeyInterpolation => {
  return (key, s, span) => {
    const [v0, b0, v1, a1] = [value(key, 1), value(key, 2), value(key + 1, 1), value(key + 1, 0)];
    const [s2, s3] = [s * s, s * s * s];
    const h = [2 * s3 - 3 * s2 + 1, (s3 - 2 * s2 + s) * span, 3 * s2 - 2 * s3, (s3 - s2) * span];
    const p = v0.map((x, i) => h[0] * x + h[1] * b0[i] + h[2] * v1[i] + h[3] * a1[i]);
    return isRotation ? [...normalizeQuat(asQuat(p))] : p;
  };
};
