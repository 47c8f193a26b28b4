import { vec4 } from 'three/tsl';
import { add, addScaled, dot, length, scale, sub, type Vec3 } from '../../../src/math/vec3.ts';
import {
  apparentPosition,
  dopplerFactor,
  type EmissionEvent,
  emissionEvent,
  type HyperbolicLine,
  oneMinusBetaSquared,
  type PolylineLine,
  properVelocity,
  type StaticLine,
  type UniformLine,
  type WorldLine,
} from '../../../src/physics/index.ts';
import * as shaders from '../../../src/shaders/index.ts';
import { always, direction, distance, relative, where } from '../../../src/shaders/twins/checks.ts';
import {
  aimedDirection,
  casesOf,
  gammaOf,
  logUniform,
  observerInput,
  observers,
  unitVector,
  vec3At,
  withLength,
} from '../../../src/shaders/twins/inputs.ts';
import { motionInputs } from '../../../src/shaders/twins/motions.ts';
import type { Twin } from '../../../src/shaders/twins/twin.ts';
import type { Int, Vec4, VertexEvent } from '../../../src/shaders/types.ts';

/*
 * The whole path of a vertex, from SI numbers in the world to the pixel and its Doppler factor, at a late time with slow light: c = 10 m/s and
 * t = 10 000 s, tens of kilometres from the origin, observers up to γ = 100. The CPU solves the vertex's own world line in f64, in
 * world coordinates; the GPU gets what frame.ts would upload: the object's anchor, and the rest relative to it, in f32.
 */
const C = 10;
const NOW = 10_000;
const EACH = 120;

interface Truth {
  readonly line: WorldLine;
  readonly observer: { readonly t: number; readonly position: Vec3 };
  readonly u: Vec3;
}
const truths = new WeakMap<readonly number[], Truth>();

/** An object with its centre at `place` at the world time `t`, and one of its vertices. */
interface PrecisionCase {
  readonly center: WorldLine;
  readonly vertex: WorldLine;
  /** The GPU's input after the anchor. */
  readonly upload: (anchor: EmissionEvent) => readonly number[];
}
type MakePrecisionCase = (random: () => number, place: Vec3, t: number, size: number) => PrecisionCase;
type Texel = (index: number | Int) => Vec4;

const offsetIn = (random: () => number, size: number): Vec3 => scale(unitVector(random), size * random());
const pick = <T>(random: () => number, of: readonly T[]): T => of[Math.floor(random() * of.length)];

const atRest: MakePrecisionCase = (random, place, _t, size) => {
  const offset = offsetIn(random, size);
  const line = (position: Vec3): StaticLine => ({ kind: 'static', position });
  return { center: line(place), vertex: line(add(place, offset)), upload: () => [...offset, 0] };
};

const uniform: MakePrecisionCase = (random, place, t, size) => {
  const offset = offsetIn(random, size);
  const beta = scale(unitVector(random), pick(random, [0.1, 0.5, 0.9, 0.99, 0.999]));
  const velocity = scale(beta, C);
  const line = (at: Vec3): UniformLine => ({ kind: 'uniform', position: addScaled(at, velocity, -t), velocity });
  return {
    center: line(place),
    vertex: line(add(place, offset)),
    upload: () => [...beta, oneMinusBetaSquared(beta), ...offset, 0],
  };
};

const hyperbolic: MakePrecisionCase = (random, place, t, size) => {
  const offset = offsetIn(random, size);
  const axis = unitVector(random);
  const a = logUniform(random, 1e-3, 3);
  const sinh = pick(random, [-1, 1]) * logUniform(random, 0.01, 22);
  const cosh = Math.hypot(1, sinh);
  const turningPoint = addScaled(place, axis, ((1 - cosh) * C * C) / a);
  const rigid = random() < 0.5 ? 1 : 0;
  const own = rigid ? a / (1 + (a * dot(axis, offset)) / (C * C)) : a;
  const line = (position: Vec3, g: number): HyperbolicLine => ({
    kind: 'hyperbolic',
    position,
    properAcceleration: scale(axis, g),
    t0: t - (sinh * C) / a,
  });
  return {
    center: line(turningPoint, a),
    vertex: line(add(turningPoint, offset), own),
    upload: (anchor) => {
      const rapidity = Math.asinh((a * (anchor.t - (t - (sinh * C) / a))) / C);
      return [...axis, a / (C * C), ...offset, rigid, Math.exp(rapidity), 0, 0, 0];
    },
  };
};

const SAMPLES = motionInputs.polyline.texels - 1;
/** 24 samples per second, as in animations: a moving centre, and a vertex moving about it. */
const sampled: MakePrecisionCase = (random, place, t, size) => {
  const times = Float64Array.from({ length: SAMPLES }, (_, i) => t + (i - (SAMPLES - 1) / 2 + random() * 0.4) / 24);
  const velocity = scale(unitVector(random), 0.6 * C);
  const jitter = Math.min(size, 0.02);
  const offset = offsetIn(random, size);
  const line = (at: (i: number) => Vec3): PolylineLine => ({
    kind: 'polyline',
    times,
    positions: Float64Array.from([...times].flatMap((_, i) => [...at(i)])),
  });
  const centerAt = (i: number): Vec3 => addScaled(place, velocity, times[i] - t);
  const vertices = [...times].map((_, i) => add(add(centerAt(i), offset), offsetIn(random, jitter)));
  return {
    center: line(centerAt),
    vertex: line((i) => vertices[i]),
    upload: (anchor) => vertices.flatMap((at, i) => [...sub(at, anchor.position), C * (times[i] - anchor.t)]),
  };
};

const upTo100 = observers.filter(({ gamma }) => gamma <= 100);

function pipelineTwin(
  name: string,
  texels: number,
  make: MakePrecisionCase,
  solve: (texel: Texel) => VertexEvent,
): Twin {
  return {
    name: `${name} at t = 10 000 s, c = 10 m/s`,
    texels: texels + 1,
    outputs: 2,
    cases: (random) =>
      casesOf(upTo100, EACH, (stratum) => {
        const position = scale(unitVector(random), 5e4 * random());
        const axis = observerInput(random, stratum).u;
        const n = aimedDirection(random, length(axis) > 0 ? scale(axis, 1 / length(axis)) : [0, 0, 1], stratum.aim);
        const r = logUniform(random, 2, 9e4);
        const { center, vertex, upload } = make(random, addScaled(position, n, r), NOW - r / C, Math.min(r / 2, 20));
        const observer = { t: NOW, position };
        const anchor = emissionEvent(center, observer, C);
        if (!anchor) throw new Error('the centre is on the light cone by construction');
        const input = [...withLength(anchor.offset), ...upload(anchor), ...axis, gammaOf(axis)];
        truths.set(input, { line: vertex, observer, u: axis });
        return input;
      }),
    cpu: (input) => {
      const truth = truths.get(input);
      if (!truth) throw new Error('not one of the cases');
      const seen = emissionEvent(truth.line, truth.observer, C);
      // Behind a horizon, which is tested by the twin of hyperbolicEmission.
      if (!seen) return Array(8).fill(0);
      const D = dopplerFactor(seen.offset, truth.u, properVelocity(scale(seen.velocity, 1 / C)));
      return [...apparentPosition(seen.offset, truth.u), D, length(vec3At(input, 0)) / C - seen.delay, 0, 0, 0];
    },
    gpu: (texel) => {
      const observer = texel(texels);
      const { dx, s, velocity } = solve(texel);
      const [u, gamma] = [observer.xyz, observer.w];
      const D = shaders.dopplerFactor(dx, u, gamma, velocity);
      return [vec4(shaders.apparentPosition(dx, u, gamma), D), vec4(s.div(C), 0, 0, 0)];
    },
    checks: [
      where(3, direction(0, always(0.1))),
      where(3, distance(0, always(1e-4))),
      where(3, relative('D', 3, always(1e-4))),
      where(3, {
        name: "emission time after the anchor's, over 1 s + itself",
        error: (gpu, cpu) => Math.abs(gpu[4] - cpu[4]) / (1 + Math.abs(cpu[4])),
        tolerance: always(1e-5),
      }),
    ],
  };
}

export const pipelines: readonly Twin[] = [
  pipelineTwin('static', 2, atRest, (texel) => shaders.staticEmission(texel(0), texel(1).xyz)),
  pipelineTwin('uniform', motionInputs.uniform.texels, uniform, motionInputs.uniform.emission),
  pipelineTwin('hyperbolic', motionInputs.hyperbolic.texels, hyperbolic, motionInputs.hyperbolic.emission),
  pipelineTwin('sampled', motionInputs.polyline.texels, sampled, motionInputs.polyline.emission),
];
