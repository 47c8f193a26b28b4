import { type AngularState, hermite, hermiteRotation, logarithm, slopeRule } from '../../../../math/hermite.ts';
import * as mat4 from '../../../../math/mat4.ts';
import { conjugate, multiply, normalizeQuat, type Quat, toMatrix } from '../../../../math/quat.ts';
import { lerp, scale, type Vec3 } from '../../../../math/vec3.ts';
import { samplesUntil } from '../../../../physics/worldLines/samples.ts';
import { numberOf, numbersOf, type TimeCode } from '../../layer/attributes.ts';
import type { AttributeSpec, TimeSamples } from '../../layer/layer.ts';

/** Values that are interpolated: numbers individually, and optionally an orientation. */
interface OpSample {
  readonly numbers: readonly number[];
  readonly orientation?: Quat;
}

/**
 * The value of a transform op by cubic interpolation of its samples: vectors, angles and scales per number, quaternions along a curve of
 * rotations, matrices by translation, rotation and stretch. Undefined outside the samples or between samples of different kinds: USD's own rule applies.
 */
export function cubicOpValues(
  kind: string,
  { timeSamples }: AttributeSpec,
  time: TimeCode,
): readonly number[] | undefined {
  if (time === undefined || !timeSamples || timeSamples.times.length < 3) return undefined;
  const { times } = timeSamples;
  const i = samplesUntil(times, time) - 1;
  if (i < 0 || i === times.length - 1 || time === times[i]) return undefined;
  const at = (k: number): OpSample | undefined => sampleOf(kind, timeSamples, k);
  const [a, b] = [at(i), at(i + 1)];
  if (!a || !b || a.numbers.length !== b.numbers.length) return undefined;
  const span = times[i + 1] - times[i];
  const w = (time - times[i]) / span;
  const [from, to] = [slopeAt(times, i, i, at), slopeAt(times, i + 1, i, at)];
  const numbers = a.numbers.map((x, n) => hermite(x, from.numbers[n], b.numbers[n], to.numbers[n], span, w));
  return authoredNumbers(kind, numbers, interpolatedOrientation(a, b, from, to, span, w));
}

const interpolatedOrientation = (
  a: OpSample,
  b: OpSample,
  from: OpSlope,
  to: OpSlope,
  span: number,
  w: number,
): Quat | undefined =>
  a.orientation && b.orientation && from.rate && to.rate
    ? hermiteRotation(orientationRate(a.orientation, from.rate), orientationRate(b.orientation, to.rate), span, w)
    : undefined;
const orientationRate = (orientation: Quat, rate: Vec3): AngularState => ({ orientation, rate });

interface OpSlope {
  readonly numbers: readonly number[];
  readonly rate?: Vec3;
}

/** Slope at sample k, an end of the interval after sample i: from the neighbouring samples if they are compatible, else from the interval's chord. */
function slopeAt(times: Float64Array, k: number, i: number, at: (k: number) => OpSample | undefined): OpSlope {
  const { middle, share } = slopeRule(times, k);
  const three = [at(middle - 1), at(middle), at(middle + 1)];
  const length = at(k)?.numbers.length;
  const alike = three.every((sample) => sample?.numbers.length === length);
  const [p, q, r] = three as OpSample[];
  if (!alike) return chord(at(i) as OpSample, at(i + 1) as OpSample, times[i + 1] - times[i]);
  const before = chord(p, q, times[middle] - times[middle - 1]);
  const after = chord(q, r, times[middle + 1] - times[middle]);
  const numbers = before.numbers.map((x, n) => (1 - share) * x + share * after.numbers[n]);
  return before.rate && after.rate ? { numbers, rate: lerp(before.rate, after.rate, share) } : { numbers };
}

function chord(a: OpSample, b: OpSample, span: number): OpSlope {
  const numbers = a.numbers.map((x, n) => (b.numbers[n] - x) / span);
  if (!a.orientation || !b.orientation) return { numbers };
  return { numbers, rate: scale(logarithm(multiply(conjugate(a.orientation), b.orientation)), 1 / span) };
}

/** Decomposed matrix samples. */
const DECOMPOSED = new WeakMap<TimeSamples, (OpSample | undefined)[]>();

function sampleOf(kind: string, samples: TimeSamples, k: number): OpSample | undefined {
  const made = DECOMPOSED.get(samples) ?? [];
  DECOMPOSED.set(samples, made);
  if (!(k in made)) made[k] = decomposedSample(kind, samples, k);
  return made[k];
}

function decomposedSample(kind: string, { values }: TimeSamples, k: number): OpSample | undefined {
  const value = values[k];
  const single = numberOf(value);
  const numbers = single === undefined ? numbersOf(value) : [single];
  if (!numbers) return undefined;
  const plain = Array.from(numbers);
  if (kind === 'orient' && plain.length === 4) {
    return { numbers: [], orientation: normalizeQuat([plain[0], plain[1], plain[2], plain[3]]) };
  }
  if (kind !== 'transform' || plain.length !== 16) return { numbers: plain };
  const { pose, stretch } = mat4.decomposeRigid(mat4.transpose(plain));
  return { numbers: [...pose.position, ...stretch], orientation: pose.orientation };
}

/** The numbers in the layout of the op's USD value. */
function authoredNumbers(kind: string, numbers: readonly number[], orientation: Quat | undefined): readonly number[] {
  if (!orientation) return numbers;
  if (kind === 'orient') return orientation;
  const [x, y, z, ...stretch] = numbers;
  const turned = mat4.fromParts(toMatrix(orientation), [x, y, z]);
  return mat4.transpose(mat4.multiply(turned, mat4.fromParts(stretch, [0, 0, 0])));
}
