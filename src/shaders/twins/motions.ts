import { int } from 'three/tsl';
import type { Random } from '../../math/random.ts';
import { add, addScaled, dot, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import type { PolylineLine, WorldLine } from '../../physics/index.ts';
import { cubicEmission } from '../emission/cubicEmission.ts';
import { hyperbolicEmission } from '../emission/hyperbolicEmission.ts';
import { polylineEmission } from '../emission/polylineEmission.ts';
import { uniformEmission } from '../emission/uniformEmission.ts';
import { cubicShallow } from '../shallowCone/cubicShallow.ts';
import { hyperbolicShallow } from '../shallowCone/hyperbolicShallow.ts';
import { polylineShallow } from '../shallowCone/polylineShallow.ts';
import type { ShallowObserver } from '../shallowCone/shallowObserver.ts';
import { uniformShallow } from '../shallowCone/uniformShallow.ts';
import { cubicSlice } from '../simultaneity/cubicSlice.ts';
import { hyperbolicSlice } from '../simultaneity/hyperbolicSlice.ts';
import { polylineSlice } from '../simultaneity/polylineSlice.ts';
import { uniformSlice } from '../simultaneity/uniformSlice.ts';
import type { Float, Int, SampleTable, Vec3 as Vec3Node, Vec4, VertexEvent, WorldLineAt } from '../types.ts';
import type { EndVelocities } from '../worldLines/cubicPiece.ts';
import { cubicPlace } from '../worldLines/cubicPlace.ts';
import { hyperbolicPlace } from '../worldLines/hyperbolicPlace.ts';
import { polylinePlace } from '../worldLines/polylinePlace.ts';
import { uniformPlace } from '../worldLines/uniformPlace.ts';
import { AIMS, aimedDirection, logUniform, SPEEDS, unitVector, vec3At, velocityInput } from './inputs.ts';
import type { Stratum } from './twin.ts';

export interface MotionStratum extends Stratum {
  readonly beta: number;
  /** Farthest vertex from the anchor [m]. */
  readonly size: number;
}

type Texel = (index: number | Int) => Vec4;

/** A kind of motion: how a random vertex is generated and passed to the CPU and the GPU. Its texels follow the anchor's. */
export interface MotionInput {
  readonly kind: 'uniform' | 'hyperbolic' | 'polyline' | 'cubic';
  /** Number of texels, including the anchor's. */
  readonly texels: number;
  /** Speeds of its strata [c]. */
  readonly speeds: readonly number[];
  readonly draw: (random: Random, stratum: MotionStratum, anchor: Vec3) => readonly number[];
  /** The vertex's world line with c = 1, for the anchor's event at d_c and `time`. */
  readonly worldLine: (input: readonly number[], time: number) => WorldLine;
  readonly emission: (texel: Texel) => VertexEvent;
  readonly slice: (texel: Texel, u: Vec3Node, gamma: Float) => VertexEvent;
  readonly shallow: (texel: Texel, observer: ShallowObserver) => VertexEvent;
  readonly place: (texel: Texel) => WorldLineAt;
}

const offsetIn = (random: Random, size: number): Vec3 => scale(unitVector(random), size * random());

/** anchor · (v, 1 − v²) · offset */
const uniform: MotionInput = {
  kind: 'uniform',
  texels: 3,
  speeds: SPEEDS,
  draw: (random, { beta, size }, anchor) => {
    const direction = aimedDirection(random, normalize(anchor, [0, 0, 1]), AIMS[Math.floor(random() * AIMS.length)]);
    // Sometimes the anchor itself, which may coincide with the observer.
    return [...velocityInput(direction, beta), ...offsetIn(random, random() < 0.1 ? 0 : size), 0];
  },
  worldLine: (input, time) => {
    const velocity = vec3At(input, 1);
    return { kind: 'uniform', position: addScaled(add(vec3At(input, 0), vec3At(input, 2)), velocity, -time), velocity };
  },
  emission: (texel) => uniformEmission(texel(0), texel(1), texel(2).xyz),
  slice: (texel, u, gamma) => uniformSlice(texel(0), texel(1), texel(2).xyz, u, gamma),
  shallow: (texel, observer) => uniformShallow(texel(0), texel(1), texel(2).xyz, observer),
  place: (texel) => uniformPlace(texel(1), texel(2).xyz),
};

/** anchor · (axis, a) · (offset, Born rigid) · (w, 0, 0, 0) */
const hyperbolic: MotionInput = {
  kind: 'hyperbolic',
  texels: 4,
  speeds: SPEEDS,
  draw: (random, { beta, size }, anchor) => {
    const axis = aimedDirection(random, normalize(anchor, [0, 0, 1]), AIMS[Math.floor(random() * AIMS.length)]);
    const w = Math.sqrt((1 + beta) / (1 - beta)) ** (random() < 0.5 ? -1 : 1);
    // a·size < 1, so that a Born-rigid body does not reach its own horizon.
    const a = logUniform(random, 1e-4, 0.5) / Math.max(size, 1);
    return [...axis, a, ...offsetIn(random, size), random() < 0.5 ? 0 : 1, w, 0, 0, 0];
  },
  worldLine: (input, time) => {
    const [axis, a, offset, rigid, w] = [vec3At(input, 1), input[7], vec3At(input, 2), input[11] === 1, input[12]];
    const [cosh, sinh] = [(w + 1 / w) / 2, (w - 1 / w) / 2];
    const turningPoint = addScaled(vec3At(input, 0), axis, (1 - cosh) / a);
    const own = rigid ? a / (1 + a * dot(axis, offset)) : a;
    return {
      kind: 'hyperbolic',
      position: add(turningPoint, offset),
      properAcceleration: scale(axis, own),
      t0: time - sinh / a,
    };
  },
  emission: (texel) => hyperbolicEmission(texel(0), texel(1), texel(3).x, texel(2).w, texel(2).xyz),
  slice: (texel, u, gamma) => hyperbolicSlice(texel(0), texel(1), texel(3).x, texel(2).w, texel(2).xyz, u, gamma),
  shallow: (texel, observer) => hyperbolicShallow(texel(0), texel(1), texel(3).x, texel(2).w, texel(2).xyz, observer),
  place: (texel) => hyperbolicPlace(texel(1), texel(3).x, texel(2).w, texel(2).xyz),
};

const SAMPLES = 9;
const samplesOf =
  (texel: Texel): SampleTable =>
  (index) =>
    texel(index.add(int(1)));

/** anchor · samples; the anchor is near the middle sample, or near an end, so that some vertices are at rest. */
const polyline: MotionInput = {
  kind: 'polyline',
  texels: 1 + SAMPLES,
  speeds: [0.1, 0.5, 0.9, 0.99],
  draw: (random, { beta, size }) => {
    const step = logUniform(random, 0.3, 3) * size;
    const middle = [-1, 2, 4, 4, 4, 6, 9][Math.floor(random() * 7)];
    let place = addScaled(offsetIn(random, size), unitVector(random), beta * step * random());
    const samples: number[] = [];
    for (let i = 0; i < SAMPLES; i++) {
      samples.push(...place, (i - middle + 0.5) * step);
      place = addScaled(place, unitVector(random), beta * step * (i === middle - 1 ? 1 : random()));
    }
    return samples;
  },
  worldLine: (input, time) => {
    const samples = Array.from({ length: SAMPLES }, (_, i) => input.slice(4 * (i + 1), 4 * (i + 2)));
    return {
      kind: 'polyline',
      times: Float64Array.from(samples, (sample) => time + sample[3]),
      positions: Float64Array.from(samples.flatMap((sample) => [...add(vec3At(input, 0), vec3At(sample, 0))])),
    };
  },
  emission: (texel) => polylineEmission(texel(0), samplesOf(texel), int(SAMPLES)),
  slice: (texel, u, gamma) => polylineSlice(texel(0), samplesOf(texel), int(SAMPLES), u, gamma),
  shallow: (texel, observer) => polylineShallow(texel(0), samplesOf(texel), int(SAMPLES), observer),
  place: (texel) => polylinePlace(samplesOf(texel), int(SAMPLES)),
};

const endVelocities =
  (texel: Texel): EndVelocities =>
  (index) => ({
    begin: texel(index.add(int(1 + SAMPLES))).xyz,
    end: texel(index.add(int(2 + SAMPLES))).xyz,
  });

/** anchor · samples · velocities at them; all control velocities are within β, and the chords follow from them. */
const cubic: MotionInput = {
  kind: 'cubic',
  texels: 1 + 2 * SAMPLES,
  speeds: polyline.speeds,
  draw: (random, { beta, size }) => {
    const step = logUniform(random, 0.3, 3) * size;
    const middle = [-1, 2, 4, 4, 4, 6, 9][Math.floor(random() * 7)];
    const control = (): Vec3 => scale(unitVector(random), beta * random());
    const velocities = Array.from({ length: SAMPLES }, control);
    let place = addScaled(offsetIn(random, size), unitVector(random), beta * step * random());
    const samples: number[] = [];
    for (let i = 0; i < SAMPLES; i++) {
      samples.push(...place, (i - middle + 0.5) * step);
      const sum = add(add(velocities[i], control()), velocities[Math.min(i + 1, SAMPLES - 1)]);
      place = addScaled(place, sum, step / 3);
    }
    return [...samples, ...velocities.flatMap((v) => [...v, 0])];
  },
  worldLine: (input, time) => {
    const { times, positions } = polyline.worldLine(input, time) as PolylineLine;
    const at = (i: number) => vec3At(input, 1 + SAMPLES + i);
    const velocities = Array.from({ length: SAMPLES - 1 }, (_, i) => [...at(i), ...at(i + 1)]);
    return { kind: 'cubic', times, positions, velocities: Float64Array.from(velocities.flat()) };
  },
  emission: (texel) => cubicEmission(texel(0), samplesOf(texel), endVelocities(texel), int(SAMPLES)),
  slice: (texel, u, gamma) => cubicSlice(texel(0), samplesOf(texel), endVelocities(texel), int(SAMPLES), u, gamma),
  shallow: (texel, observer) => cubicShallow(texel(0), samplesOf(texel), endVelocities(texel), int(SAMPLES), observer),
  place: (texel) => cubicPlace(samplesOf(texel), endVelocities(texel), int(SAMPLES)),
};

export const motionInputs = { uniform, hyperbolic, polyline, cubic } as const;
