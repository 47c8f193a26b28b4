import type { Vec3 } from '../../../math/vec3.ts';
import type { AttributeSpec, NumberArray, PrimSpec, Value } from './layer.ts';

/** A time code, or `undefined` for the default value, which has no time. */
export type TimeCode = number | undefined;

export function attributeOf(prim: PrimSpec, name: string): AttributeSpec | undefined {
  const property = prim.properties.get(name);
  return property?.kind === 'attribute' ? property : undefined;
}

/** Time codes of an attribute's samples; empty if constant. */
export const sampleTimes = (attribute: AttributeSpec | undefined): Float64Array =>
  attribute?.timeSamples && attribute.timeSamples.times.length > 1 ? attribute.timeSamples.times : NO_TIMES;
const NO_TIMES = new Float64Array(0);

/**
 * The value at a time code, as UsdAttribute::Get: between samples linear where the type allows it (quaternions along
 * the arc), else held; outside them the nearest; none where the sample in force is blocked.
 */
export function valueAt(attribute: AttributeSpec | undefined, time: TimeCode): Value | undefined {
  if (!attribute) return undefined;
  const samples = attribute.timeSamples;
  if (time === undefined || !samples || samples.times.length === 0) return unblocked(attribute.value);
  const i = lowerSample(samples.times, time);
  const a = unblocked(samples.values[i]);
  const next = samples.times[i + 1];
  if (a === undefined || next === undefined || time <= samples.times[i]) return a;
  const b = samples.values[i + 1];
  return interpolate(a, b, (time - samples.times[i]) / (next - samples.times[i]));
}

const unblocked = (value: Value | undefined): Value | undefined =>
  value?.type === 'blocked' || value?.type === 'animationBlock' ? undefined : value;

/** The last sample at or before `time`; 0 before all. */
export function lowerSample(times: Float64Array, time: number): number {
  let low = 0;
  let high = times.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return low;
}

/** Linearly interpolated types; others are held. */
export const LINEAR_TYPES = /^(half|float|double|timecode|matrix|quat)/;

function interpolate(a: Value, b: Value, s: number): Value {
  if (a.type !== b.type || !LINEAR_TYPES.test(a.type)) return a;
  const [p, q] = [numberOf(a), numberOf(b)];
  if (p !== undefined && q !== undefined) {
    const mixed = (1 - s) * p + s * q;
    return { type: a.type, data: a.type === 'double' || a.type === 'timecode' ? mixed : Math.fround(mixed) } as Value;
  }
  const [x, y] = [numbersOf(a), numbersOf(b)];
  if (!x || !y || x.length !== y.length) return a;
  const out = x.slice();
  if (a.type.startsWith('quat')) for (let i = 0; i < x.length; i += 4) slerpInto(out, x, y, i, s);
  else for (let i = 0; i < x.length; i++) out[i] = (1 - s) * x[i] + s * y[i];
  return { type: a.type, data: out } as Value;
}

/** GfSlerp of OpenUSD: the shorter arc, linear where the two are close; the result is not made unit. */
function slerpInto(out: NumberArray, a: NumberArray, b: NumberArray, at: number, s: number): void {
  let cosine = 0;
  for (let k = at; k < at + 4; k++) cosine += a[k] * b[k];
  const sign = cosine < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  const close = 1 - Math.abs(cosine) <= 1e-5;
  const wa = close ? 1 - s : Math.sin((1 - s) * angle) / Math.sin(angle);
  const wb = sign * (close ? s : Math.sin(s * angle) / Math.sin(angle));
  for (let k = at; k < at + 4; k++) out[k] = wa * a[k] + wb * b[k];
}

/** The numbers of a tuple or of an array of numbers. */
export function numbersOf(value: Value | undefined): NumberArray | undefined {
  if (value === undefined || !('data' in value)) return undefined;
  const { data } = value;
  return ArrayBuffer.isView(data) && !(data instanceof BigInt64Array) && !(data instanceof BigUint64Array)
    ? data
    : undefined;
}

export function numbersAt(prim: PrimSpec, name: string, time: TimeCode): NumberArray | undefined {
  return numbersOf(valueAt(attributeOf(prim, name), time));
}

export function numberAt(prim: PrimSpec, name: string, time: TimeCode): number | undefined {
  return numberOf(valueAt(attributeOf(prim, name), time));
}

export const numberOf = (value: Value | undefined): number | undefined =>
  value && 'data' in value && typeof value.data === 'number' ? value.data : undefined;

export function textAt(prim: PrimSpec, name: string, time: TimeCode): string | undefined {
  return textOf(valueAt(attributeOf(prim, name), time));
}

export const textOf = (value: Value | undefined): string | undefined =>
  value && 'data' in value && typeof value.data === 'string' ? value.data : undefined;

export function boolAt(prim: PrimSpec, name: string, time: TimeCode): boolean | undefined {
  const value = valueAt(attributeOf(prim, name), time);
  return value?.type === 'bool' ? value.data : undefined;
}

export function vec3At(prim: PrimSpec, name: string, time: TimeCode): Vec3 | undefined {
  return vec3Of(valueAt(attributeOf(prim, name), time));
}

export function vec3Of(value: Value | undefined): Vec3 | undefined {
  const numbers = numbersOf(value);
  return numbers && numbers.length >= 3 ? [numbers[0], numbers[1], numbers[2]] : undefined;
}

export function tokensAt(prim: PrimSpec, name: string, time: TimeCode): readonly string[] | undefined {
  const value = valueAt(attributeOf(prim, name), time);
  return value?.type === 'token[]' || value?.type === 'string[]' ? value.data : undefined;
}
