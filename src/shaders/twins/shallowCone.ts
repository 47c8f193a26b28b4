import { length, vec4 } from 'three/tsl';
import { length as lengthOf, normalize, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { gamma as gammaFactor } from '../../physics/index.ts';
import { shallowPosition as positionOf, shallowCone, slowed } from '../../physics/worldLines/shallowCone.ts';
import { ontoShallowCone } from '../shallowCone/ontoShallowCone.ts';
import type { ShallowObserver } from '../shallowCone/shallowObserver.ts';
import { shallowPosition } from '../shallowCone/shallowPosition.ts';
import type { Int, Vec4 } from '../types.ts';
import { always, where, within } from './checks.ts';
import { expectedAt, outputsOf } from './emission.ts';
import { casesOf, gammaOf, logUniform, observerInput, observers, vec3At, velocityInput, withLength } from './inputs.ts';
import { type MotionInput, motionInputs } from './motions.ts';
import type { Check, Twin } from './twin.ts';

const OBSERVER = { t: 0, position: ZERO } as const;
const EACH = 8;
const SLOPES = [0.01, 0.3, 0.7, 0.99];
/** 1 px of a picture of 1000 px a radian. */
const PIXEL = 1e-3;

const strata = (speeds: readonly number[]) =>
  observers
    .filter(({ gamma }) => gamma <= 100)
    .flatMap((observer) =>
      speeds
        .filter((beta) => beta <= 0.999)
        .flatMap((beta) =>
          SLOPES.map((slope) => ({
            ...observer,
            beta,
            slope,
            size: 1,
            name: `${observer.name}, β ${beta}, λ ${slope}`,
          })),
        ),
    );

/** (u, γ) · (γβ and γ of λβ) · (λ, 0, 0, 0) */
const observerTexels = (u: Vec3, slope: number): readonly number[] => {
  const slow = slowed(u, slope);
  return [...u, gammaOf(u), ...slow, gammaFactor(slow), slope, 0, 0, 0];
};
const OBSERVER_TEXELS = 3;

function observerAt(texel: (index: number | Int) => Vec4, first: number): ShallowObserver {
  const [observer, slow, slope] = [0, 1, 2].map((k) => texel(first + k));
  return { u: observer.xyz, gamma: observer.w, slowedU: slow.xyz, slowedGamma: slow.w, coneSlope: slope.x };
}

/** Up to β = 0.99, and beyond, where rounding the velocity to f32 alone shifts events along the line of sight. */
const bySpeed =
  (slow: number, fast: number): Check['tolerance'] =>
  ({ beta = 0 }) =>
    beta <= 0.99 ? slow : fast;

/** The direction in which the event is drawn. */
const direction: Check = {
  name: 'direction [px]',
  error: (gpu, cpu) => {
    const [seen, expected] = [gpu, cpu].map((of): Vec3 => [of[12]!, of[13]!, of[14]!]);
    return lengthOf(expected!) < 0.05
      ? 0
      : lengthOf(sub(normalize(seen!, [0, 0, 0]), normalize(expected!, [0, 0, 0]))) / PIXEL;
  },
  tolerance: bySpeed(0.1, 0.3),
};

/** [m] */
const reach = (cpu: readonly number[], input: readonly number[]): number =>
  lengthOf([cpu[0]!, cpu[1]!, cpu[2]!]) +
  lengthOf(sub([cpu[0]!, cpu[1]!, cpu[2]!], vec3At(input, 0))) +
  Math.abs(cpu[3]!) +
  0.05;

const shallowTwin = (mover: MotionInput, parts: readonly string[]): Twin => ({
  name: `${mover.kind}Shallow`,
  parts,
  texels: mover.texels + OBSERVER_TEXELS,
  outputs: 4,
  cases: (random) =>
    casesOf(strata(mover.speeds), EACH, (stratum) => {
      const { u, n } = observerInput(random, stratum);
      const anchor = scale(n, logUniform(random, 2, 1e4));
      return [...withLength(anchor), ...mover.draw(random, stratum, anchor), ...observerTexels(u, stratum.slope)];
    }),
  cpu: (input) => {
    const u = vec3At(input, mover.texels);
    const slope = input[4 * (mover.texels + 2)]!;
    const cone = shallowCone(slope);
    const time = cone.timeAt(vec3At(input, 0), u);
    const line = mover.worldLine(input, time);
    const { offset, ahead } = cone.intersect(line, OBSERVER, u, 1)!;
    return [...expectedAt(line, offset, ahead, ahead - time), ...positionOf(offset, u, slope), 0];
  },
  gpu: (texel) => {
    const observer = observerAt(texel, mover.texels);
    const event = mover.shallow(texel, observer);
    return [...outputsOf(event), vec4(shallowPosition(event.dx, observer), 0)];
  },
  checks: [where(8, within('place, over the reach', 0, reach, bySpeed(1e-5, 1e-4))), where(8, direction)],
});

/** Events that pass near the cone. */
const ontoTwin: Twin = {
  name: 'ontoShallowCone',
  texels: 2 + OBSERVER_TEXELS,
  outputs: 2,
  cases: (random) =>
    casesOf(strata([0, 0.5, 0.9, 0.999]), EACH, (stratum) => {
      const { u, n } = observerInput(random, stratum);
      const place = scale(n, logUniform(random, 2, 1e3));
      const time = shallowCone(stratum.slope).timeAt(place, u) + (random() - 0.5) * 0.2 * lengthOf(place);
      const direction = normalize([random() - 0.5, random() - 0.5, random() - 0.5], [1, 0, 0]);
      return [...place, time, ...velocityInput(direction, stratum.beta), ...observerTexels(u, stratum.slope)];
    }),
  cpu: (input) => {
    const u = vec3At(input, 2);
    const slope = input[16]!;
    const velocity = vec3At(input, 1);
    const place = vec3At(input, 0);
    const line = { kind: 'uniform', position: sub(place, scale(velocity, input[3]!)), velocity } as const;
    const { offset, ahead } = shallowCone(slope).intersect(line, OBSERVER, u, 1)!;
    return [...offset, ahead, ...positionOf(offset, u, slope), 0];
  },
  gpu: (texel) => {
    const observer = observerAt(texel, 2);
    const event = ontoShallowCone(texel(0), texel(1), observer).toVar();
    return [event, vec4(shallowPosition(event.xyz, observer), length(event.xyz))];
  },
  checks: [
    {
      name: 'place, over the reach',
      error: (gpu, cpu, input) =>
        lengthOf(sub([gpu[0]!, gpu[1]!, gpu[2]!], [cpu[0]!, cpu[1]!, cpu[2]!])) /
        (lengthOf([cpu[0]!, cpu[1]!, cpu[2]!]) + lengthOf(vec3At(input, 0)) + Math.abs(cpu[3]!)),
      tolerance: always(1e-4),
    },
  ],
};

export const shallowConeTwins: readonly Twin[] = [
  shallowTwin(motionInputs.uniform, ['linearShallow', 'shallowAnchor', 'shallowPosition']),
  shallowTwin(motionInputs.hyperbolic, ['shallowRate', 'shallowTime']),
  shallowTwin(motionInputs.polyline, []),
  shallowTwin(motionInputs.cubic, []),
  ontoTwin,
];
