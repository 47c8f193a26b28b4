import { int, select, vec4 } from 'three/tsl';
import { add, addScaled, length, normalize, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import {
  emitterDoppler,
  newtonEmissionTime,
  pastLightCone,
  positionAt,
  velocityAt,
  type WorldLine,
} from '../../physics/index.ts';
import { newtonEmission } from '../emission/newtonEmission.ts';
import { ontoLightCone } from '../emission/ontoLightCone.ts';
import { polylineEmission } from '../emission/polylineEmission.ts';
import { staticEmission } from '../emission/staticEmission.ts';
import type { HyperbolicVertexEvent, Int, Vec4, VertexEvent } from '../types.ts';
import { always, where, within } from './checks.ts';
import {
  AIMS,
  aimedDirection,
  casesOf,
  logUniform,
  SPEEDS,
  unitVector,
  vec3At,
  velocityInput,
  withLength,
} from './inputs.ts';
import { type MotionInput, type MotionStratum, motionInputs } from './motions.ts';
import type { Check, Twin, TwinCase } from './twin.ts';

const OBSERVER = { t: 0, position: ZERO } as const;
const EACH = 100;

/** (Δx, s) · (v, 1 − v²) · (exists, distance in time to the nearest sample [m], 0, 0) */
export const outputsOf = (event: VertexEvent | HyperbolicVertexEvent): readonly Vec4[] => [
  vec4(event.dx, event.s),
  event.velocity,
  vec4('exists' in event ? select(event.exists, 1, 0) : 1, 0, 0, 0),
];

/** The same outputs from the CPU, at the world time `t` after the observer's and `s` after the anchor's. */
export function expectedAt(line: WorldLine, dx: Vec3, t: number, s: number): readonly number[] {
  const v = velocityAt(line, t, 1);
  const speed = length(v);
  return [...dx, s, ...v, (1 - speed) * (1 + speed), 1, nearestSample(line, t), 0, 0];
}
const nowhere = Array<number>(12).fill(0);

const nearestSample = (line: WorldLine, t: number): number =>
  'times' in line ? Math.min(...Array.from(line.times, (time) => Math.abs(time - t))) : 1;

/** Objects of 1 m and 100 m, seen from outside, or around the observer. */
const strata = (speeds: readonly number[]): readonly MotionStratum[] =>
  speeds.flatMap((beta) =>
    [1, 100].flatMap((size) =>
      [false, true].map((around) => ({
        name: `β ${beta}, size ${size} m${around ? ', around the observer' : ''}`,
        gamma: 1,
        beta,
        size,
        around,
      })),
    ),
  );

/** `around`: near the observer, sometimes exactly at the observer. */
function anchorOf(random: () => number, size: number, around = false): Vec3 {
  if (!around) return scale(unitVector(random), logUniform(random, 1.5 * size, 1e5));
  return scale(unitVector(random), random() < 0.1 ? 0 : size * random());
}

/**
 * f32 directions have errors of 6e-8, which fast motion amplifies: one bound up to β = 0.99, one at
 * 0.999 (γ = 22), one at 0.999999 (γ = 707). Ten times as large where the observer is among the vertices and lengths cancel.
 */
const bySpeed =
  (slow: number, fast: number, fastest: number): Check['tolerance'] =>
  ({ beta = 0, around }) => {
    const bound = beta <= 0.99 ? slow : beta <= 0.999 ? fast : fastest;
    return around ? 10 * bound : bound;
  };

/** The length that errors of position and time are relative to: the distance of the vertex plus the path to its event, at least 5 cm [m]. */
const eventScale = (cpu: readonly number[], input: readonly number[]): number => {
  const dx: Vec3 = [cpu[0], cpu[1], cpu[2]];
  return length(dx) + length(sub(dx, vec3At(input, 0))) + Math.abs(cpu[3]) + 0.05;
};

const time: Check = {
  name: 'time, over the reach',
  error: (gpu, cpu, input) => Math.abs(gpu[3] - cpu[3]) / eventScale(cpu, input),
  tolerance: bySpeed(3e-6, 2e-5, 2e-2),
};

/** D of the emitter from the event and the velocity, weighted by distance (nearby directions are less accurate); not at samples, where the velocity jumps. */
const doppler: Check = {
  name: 'D, relative, times |Δx| over the reach',
  error: (gpu, cpu, input) => {
    const known = length([cpu[0], cpu[1], cpu[2]]) / eventScale(cpu, input);
    if (known < 1e-6 || cpu[9] < 1e-4 * (1 + Math.abs(cpu[3]))) return 0;
    return Math.abs(dopplerOf(gpu) / dopplerOf(cpu) - 1) * known;
  },
  tolerance: bySpeed(3e-5, 1e-4, 1e-2),
};

function dopplerOf([x, y, z, , vx, vy, vz, oneMinusV2]: readonly number[]): number {
  const dx: Vec3 = [x, y, z];
  return emitterDoppler(scale(dx, 1 / length(dx)), [vx, vy, vz], oneMinusV2);
}

const exists: Check = {
  name: 'exists',
  error: (gpu, cpu) => Math.abs(gpu[8] - cpu[8]),
  tolerance: always(0),
};

export const placeAndTime: readonly Check[] = [
  where(8, within('place, over the reach', 0, eventScale, bySpeed(3e-6, 2e-5, 1e-3))),
  where(8, time),
];
const eventChecks: readonly Check[] = [...placeAndTime, where(8, doppler)];

function motionCases(
  mover: MotionInput,
  random: () => number,
  extra: () => readonly number[] = () => [],
): readonly TwinCase[] {
  return casesOf(strata(mover.speeds), EACH, (stratum) => {
    const anchor = anchorOf(random, stratum.size, stratum.around);
    return [...withLength(anchor), ...mover.draw(random, stratum, anchor), ...extra()];
  });
}

const emissionTwin = (mover: MotionInput, parts: readonly string[]): Twin => ({
  name: `${mover.kind}Emission`,
  parts,
  texels: mover.texels,
  outputs: 3,
  cases: (random) => motionCases(mover, random),
  cpu: (input) => {
    const R = length(vec3At(input, 0));
    const line = mover.worldLine(input, -R);
    const seen = pastLightCone(line, OBSERVER, 1);
    return seen ? expectedAt(line, seen.offset, -seen.delay, R - seen.delay) : nowhere;
  },
  gpu: (texel) => outputsOf(mover.emission(texel)),
  checks: [...eventChecks, exists],
});

/** Newton's steps are not compared on hyperbolas, where a long step can land where 1 − v² is rounding noise. */
const newtonTwin = (mover: MotionInput): Twin => ({
  name: `newtonEmission, ${mover.kind}`,
  parts: ['newtonEmission'],
  texels: mover.texels + 1,
  outputs: 3,
  cases: (random) =>
    motionCases({ ...mover, speeds: mover.speeds.filter((beta) => beta <= 0.9) }, random, () => [
      Math.floor(12 * random()),
      0.3 + 0.7 * random(),
      0,
      0,
    ]),
  cpu: (input) => {
    const R = length(vec3At(input, 0));
    const line = mover.worldLine(input, -R);
    const [iterations, damping] = input.slice(4 * mover.texels);
    const t = newtonEmissionTime(line, OBSERVER, 1, { iterations, damping });
    return expectedAt(line, positionAt(line, t, 1), t, R + t);
  },
  gpu: (texel) => {
    const settings = texel(mover.texels);
    return outputsOf(newtonEmission(texel(0), mover.place(texel), int(settings.x), settings.y));
  },
  checks: eventChecks,
});

const placeTwin = (mover: MotionInput, parts: readonly string[]): Twin => ({
  name: `${mover.kind}Place`,
  parts,
  texels: mover.texels + 1,
  outputs: 3,
  cases: (random) => motionCases(mover, random, () => [20 * random() - 10, 0, 0, 0]),
  cpu: (input) => {
    const line = mover.worldLine(input, 0);
    const time = input[4 * mover.texels];
    return expectedAt(line, positionAt(line, time, 1), time, time);
  },
  gpu: (texel) => {
    const time = texel(mover.texels).x;
    const { x, velocity } = mover.place(texel)(time);
    return outputsOf({ dx: texel(0).xyz.add(x), s: time, velocity });
  },
  checks: eventChecks,
});

const staticTwin: Twin = {
  name: 'staticEmission',
  texels: 2,
  outputs: 3,
  cases: (random) =>
    casesOf(strata([0]), EACH, ({ size, around }) => [
      ...withLength(anchorOf(random, size, around)),
      ...scale(unitVector(random), size * random()),
      0,
    ]),
  cpu: (input) => {
    const dx = add(vec3At(input, 0), vec3At(input, 1));
    return expectedAt({ kind: 'static', position: dx }, dx, 0, length(vec3At(input, 0)) - length(dx));
  },
  gpu: (texel) => outputsOf(staticEmission(texel(0), texel(1).xyz)),
  checks: eventChecks,
};

/** (Δx, s) slightly off the light cone · (v, 1 − v²) */
const ontoConeTwin: Twin = {
  name: 'ontoLightCone',
  texels: 2,
  outputs: 3,
  cases: (random) =>
    // Nearer to c, the offset from the cone is lost in the rounding of f32 inputs.
    casesOf(strata(SPEEDS.filter((beta) => beta <= 0.99)), EACH, ({ beta, size }) => {
      const dx = anchorOf(random, size);
      const direction = aimedDirection(random, normalize(dx, [0, 0, 1]), AIMS[Math.floor(random() * AIMS.length)]);
      const beside = (random() < 0.5 ? -1 : 1) * logUniform(random, 2e-3, 0.05) * (1 - beta);
      return [...dx, -length(dx) * (1 + beside), ...velocityInput(direction, beta)];
    }),
  cpu: (input) => {
    const [dx, s, v] = [vec3At(input, 0), input[3], vec3At(input, 1)];
    const line: WorldLine = { kind: 'uniform', position: addScaled(dx, v, -s), velocity: v };
    const seen = pastLightCone(line, OBSERVER, 1);
    return seen ? expectedAt(line, seen.offset, -seen.delay, -seen.delay) : nowhere;
  },
  gpu: (texel) => {
    const [event, velocity] = [texel(0), texel(1)];
    const seen = ontoLightCone(event, velocity).toVar();
    return outputsOf({ dx: seen.xyz, s: seen.w, velocity });
  },
  checks: eventChecks,
};

const LONGEST = 4096;

/** A zigzag with the maximal number of samples, and its root anywhere in it or outside. anchor · (first sample) · (step) */
const longestTable: Twin = {
  name: 'polylineEmission, 4096 samples',
  texels: 3,
  outputs: 3,
  cases: (random) =>
    casesOf([{ name: '4096 samples', gamma: 1, beta: 0.5 }], 100, () => {
      // Dyadic numbers, so that the times computed by the shader are exact.
      const dt = 2 ** -Math.floor(4 * random());
      const first = -(Math.floor((LONGEST + 100) * random()) + Math.floor(1024 * random()) / 1024) * dt;
      return [
        ...withLength(anchorOf(random, 1)),
        ...scale(unitVector(random), 0.5),
        first,
        ...scale(unitVector(random), 0.5 * dt),
        dt,
      ];
    }),
  cpu: (input) => {
    const [anchor, first, step] = [
      vec3At(input, 0),
      input.slice(4, 8).map(Math.fround),
      input.slice(8).map(Math.fround),
    ];
    const index = Array.from({ length: LONGEST }, (_, i) => i);
    const R = length(anchor);
    const line: WorldLine = {
      kind: 'polyline',
      times: Float64Array.from(index, (i) => first[3] + i * step[3] - R),
      positions: Float64Array.from(
        index.flatMap((i) => [...addScaled(add(anchor, vec3At(first, 0)), vec3At(step, 0), i % 2)]),
      ),
    };
    const seen = pastLightCone(line, OBSERVER, 1);
    return seen ? expectedAt(line, seen.offset, -seen.delay, R - seen.delay) : nowhere;
  },
  gpu: (texel) => {
    const [first, step] = [texel(1), texel(2)];
    const at = (i: Int) => first.add(vec4(step.xyz.mul(i.mod(int(2)).toFloat()), step.w.mul(i.toFloat())));
    return outputsOf(polylineEmission(texel(0), at, int(LONGEST)));
  },
  checks: placeAndTime,
};

export const emissionTwins: readonly Twin[] = [
  staticTwin,
  ontoConeTwin,
  emissionTwin(motionInputs.uniform, ['linearEmission']),
  emissionTwin(motionInputs.hyperbolic, ['hyperbolaVertex', 'hyperbolaEmission', 'hyperbolaEvent']),
  emissionTwin(motionInputs.polyline, ['linearEmission', 'bisect', 'pieceVelocity']),
  emissionTwin(motionInputs.cubic, [
    'linearEmission',
    'bisect',
    'pieceVelocity',
    'cubicPiece',
    'cubicRoot',
    'evaluateCubic',
    'fullVelocity',
  ]),
  longestTable,
  newtonTwin(motionInputs.uniform),
  newtonTwin(motionInputs.polyline),
  newtonTwin(motionInputs.cubic),
  placeTwin(motionInputs.uniform, []),
  placeTwin(motionInputs.hyperbolic, ['hyperbolaVertex', 'hyperbolaCrossing', 'hyperbolaEvent']),
  placeTwin(motionInputs.polyline, ['bisect', 'pieceVelocity']),
  placeTwin(motionInputs.cubic, ['bisect', 'cubicPiece', 'evaluateCubic']),
];
