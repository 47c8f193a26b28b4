import { vec4 } from 'three/tsl';
import { add, cross, dot, length, normalize, scale } from '../../math/vec3.ts';
import * as physics from '../../physics/index.ts';
import { aberrate } from '../kinematics/aberrate.ts';
import { apparentPosition } from '../kinematics/apparentPosition.ts';
import { boost } from '../kinematics/boost.ts';
import { coneOffset } from '../kinematics/coneOffset.ts';
import { dopplerFactor } from '../kinematics/dopplerFactor.ts';
import { emitterDoppler } from '../kinematics/emitterDoppler.ts';
import { lorentzFactorRatio } from '../kinematics/lorentzFactorRatio.ts';
import { observerDoppler } from '../kinematics/observerDoppler.ts';
import { recession } from '../kinematics/recession.ts';
import { simultaneousPosition } from '../kinematics/simultaneousPosition.ts';
import { unaberrate } from '../kinematics/unaberrate.ts';
import { always, direction, distance, relative, upTo100, within } from './checks.ts';
import {
  AIMS,
  aimedDirection,
  casesOf,
  gammaOf,
  logUniform,
  observerInput,
  observers,
  SPEEDS,
  unitVector,
  vec3At,
  velocityInput,
  withLength,
} from './inputs.ts';
import type { Twin, TwinCase } from './twin.ts';

const EACH = 60;

/** (Δx or n), (u, γ) */
const observerCases =
  (what: 'dx' | 'n') =>
  (random: () => number): readonly TwinCase[] =>
    casesOf(observers, EACH, (stratum) => {
      const look = observerInput(random, stratum);
      return [...look[what], 0, ...look.u, gammaOf(look.u)];
    });

const observed = {
  texels: 2,
  outputs: 1,
} as const;

const observerDopplerTwin: Twin = {
  ...observed,
  name: 'observerDoppler',
  cases: observerCases('dx'),
  cpu: (input) => [physics.observerDoppler(vec3At(input, 0), vec3At(input, 1)), 0, 0, 0],
  gpu: (texel) => [vec4(observerDoppler(texel(0).xyz, texel(1).xyz, texel(1).w), 0, 0, 0)],
  checks: [relative('D', 0, upTo100(2e-5, 2e-4))],
};

const apparentPositionTwin: Twin = {
  ...observed,
  name: 'apparentPosition',
  cases: observerCases('dx'),
  cpu: (input) => [...physics.apparentPosition(vec3At(input, 0), vec3At(input, 1)), 0],
  gpu: (texel) => [vec4(apparentPosition(texel(0).xyz, texel(1).xyz, texel(1).w), 0)],
  checks: [direction(0, upTo100(0.05, 0.5)), distance(0, upTo100(2e-5, 2e-4))],
};

const aberrateTwin: Twin = {
  ...observed,
  name: 'aberrate',
  cases: observerCases('n'),
  cpu: (input) => [...physics.aberrate(vec3At(input, 0), vec3At(input, 1)), 0],
  gpu: (texel) => [vec4(aberrate(texel(0).xyz, texel(1).xyz, texel(1).w), 0)],
  checks: [direction(0, upTo100(0.05, 0.5))],
};

const unaberrateTwin: Twin = {
  ...observed,
  name: 'unaberrate',
  cases: observerCases('n'),
  cpu: (input) => [...physics.unaberrate(vec3At(input, 0), vec3At(input, 1)), 0],
  gpu: (texel) => [vec4(unaberrate(texel(0).xyz, texel(1).xyz, texel(1).w), 0)],
  checks: [direction(0, upTo100(0.05, 0.5))],
};

const boostTwin: Twin = {
  ...observed,
  name: 'boost',
  cases: (random) =>
    casesOf(observers, EACH, (stratum) => {
      const { dx, u } = observerInput(random, stratum);
      return [...dx, (2 * random() - 1) * length(dx), ...u, gammaOf(u)];
    }),
  cpu: (input) => {
    const [ct, ...x] = physics.boost([input[3], ...vec3At(input, 0)], vec3At(input, 1));
    return [...x, ct];
  },
  gpu: (texel) => [boost(texel(0), texel(1).xyz, texel(1).w)],
  // (x, y, z), and (y, z, ct).
  checks: [0, 1].map((at) =>
    within(`from ${at}, over γ²|x|`, at, (_, input) => input[7] ** 2 * (length(vec3At(input, 0)) + 1e-3), always(1e-6)),
  ),
};

const simultaneousPositionTwin: Twin = {
  ...observed,
  name: 'simultaneousPosition',
  cases: observerCases('dx'),
  cpu: (input) => [...physics.simultaneousPosition(vec3At(input, 0), vec3At(input, 1)), 0],
  gpu: (texel) => [vec4(simultaneousPosition(texel(0).xyz, texel(1).xyz, texel(1).w), 0)],
  checks: [within('place, over |Δx|', 0, (_, input) => length(vec3At(input, 0)) + 1e-3, always(1e-6))],
};

const dopplerFactorTwin: Twin = {
  name: 'dopplerFactor',
  texels: 3,
  outputs: 1,
  cases: (random) =>
    casesOf(observers, EACH, (stratum) => {
      const { u, dx } = observerInput(random, stratum);
      const beta = SPEEDS[Math.floor(random() * SPEEDS.length)];
      const aim = AIMS[Math.floor(random() * AIMS.length)];
      return [
        ...dx,
        0,
        ...u,
        gammaOf(u),
        ...velocityInput(aimedDirection(random, normalize(dx, [0, 0, 1]), aim), beta),
      ];
    }),
  cpu: (input) => {
    const uEmitter = scale(vec3At(input, 2), 1 / Math.sqrt(input[11]));
    return [physics.dopplerFactor(vec3At(input, 0), vec3At(input, 1), uEmitter), 0, 0, 0];
  },
  gpu: (texel) => [vec4(dopplerFactor(texel(0).xyz, texel(1).xyz, texel(1).w, texel(2)), 0, 0, 0)],
  checks: [relative('D', 0, upTo100(1e-4, 4e-4))],
};

const emitterStrata = SPEEDS.flatMap((beta) => AIMS.map((aim) => ({ name: `β ${beta}, ${aim}`, gamma: 1, beta, aim })));

/** n, (v, 1 − v²) */
const emitterCases = (random: () => number): readonly TwinCase[] =>
  casesOf(emitterStrata, EACH, ({ beta, aim }) => {
    const n = unitVector(random);
    return [...n, 0, ...velocityInput(aimedDirection(random, n, aim), beta)];
  });

const emitterDopplerTwin: Twin = {
  ...observed,
  name: 'emitterDoppler',
  cases: emitterCases,
  cpu: (input) => [physics.emitterDoppler(vec3At(input, 0), vec3At(input, 1), input[7]), 0, 0, 0],
  gpu: (texel) => [vec4(emitterDoppler(texel(0).xyz, texel(1)), 0, 0, 0)],
  checks: [relative('D', 0, always(1e-4))],
};

const recessionTwin: Twin = {
  ...observed,
  name: 'recession',
  cases: emitterCases,
  cpu: (input) => {
    const [n, v] = [vec3At(input, 0), vec3At(input, 1)];
    const side = cross(v, n);
    return [dot(v, n) < 0 ? (input[7] + dot(side, side)) / (1 - dot(v, n)) : 1 + dot(v, n), 0, 0, 0];
  },
  gpu: (texel) => [vec4(recession(texel(0).xyz, texel(1)), 0, 0, 0)],
  checks: [relative('1 + v·n', 0, always(1e-4))],
};

const lorentzFactorRatioTwin: Twin = {
  ...observed,
  name: 'lorentzFactorRatio',
  cases: (random) =>
    casesOf(observers, EACH, (stratum) => {
      const { u, n } = observerInput(random, stratum);
      return [...u, gammaOf(u), ...velocityInput(n, SPEEDS[Math.floor(random() * SPEEDS.length)])];
    }),
  // γ − u·v is the relative Lorentz factor of observer and object divided by the object's own.
  cpu: (input) => {
    const gammaV = 1 / Math.sqrt(input[7]);
    const relativeU = physics.relativeVelocity(scale(vec3At(input, 1), gammaV), vec3At(input, 0));
    return [gammaOf(relativeU) / gammaV, 0, 0, 0];
  },
  gpu: (texel) => [vec4(lorentzFactorRatio(texel(0).xyz, texel(0).w, texel(1)), 0, 0, 0)],
  checks: [relative('γ − u·v', 0, upTo100(1e-4, 4e-4))],
};

const coneOffsetTwin: Twin = {
  ...observed,
  name: 'coneOffset',
  cases: (random) =>
    casesOf([{ name: 'anchor 0.1 m … 100 km', gamma: 1 }], 400, () => [
      ...withLength(scale(unitVector(random), logUniform(random, 0.1, 1e5))),
      ...scale(unitVector(random), logUniform(random, 0.01, 100)),
      0,
    ]),
  cpu: (input) => {
    const [dc, x] = [vec3At(input, 0), vec3At(input, 1)];
    return [(dot(x, x) + 2 * dot(dc, x)) / (length(add(dc, x)) + length(dc)), 0, 0, 0];
  },
  gpu: (texel) => [vec4(coneOffset(texel(0), texel(1).xyz), 0, 0, 0)],
  checks: [
    {
      name: 'difference, over |x|',
      error: (gpu, cpu, input) => Math.abs(gpu[0] - cpu[0]) / length(vec3At(input, 1)),
      tolerance: always(1e-6),
    },
  ],
};

export const kinematicsTwins: readonly Twin[] = [
  observerDopplerTwin,
  emitterDopplerTwin,
  dopplerFactorTwin,
  apparentPositionTwin,
  aberrateTwin,
  unaberrateTwin,
  boostTwin,
  simultaneousPositionTwin,
  recessionTwin,
  lorentzFactorRatioTwin,
  coneOffsetTwin,
];
