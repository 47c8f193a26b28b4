import { int } from 'three/tsl';
import { dot, scale, ZERO } from '../../math/vec3.ts';
import { newtonSimultaneousTime, positionAt, simultaneitySlice } from '../../physics/index.ts';
import { newtonSlice } from '../simultaneity/newtonSlice.ts';
import { expectedAt, outputsOf, placeAndTime } from './emission.ts';
import { casesOf, gammaOf, logUniform, observerInput, observers, vec3At, withLength } from './inputs.ts';
import { type MotionInput, motionInputs } from './motions.ts';
import type { Twin } from './twin.ts';

const OBSERVER = { t: 0, position: ZERO } as const;
const EACH = 12;

/** Every observer combined with every speed of the object. */
const strata = (speeds: readonly number[]) =>
  observers.flatMap((observer) =>
    speeds.map((beta) => ({ ...observer, beta, size: 1, name: `${observer.name}, β ${beta}` })),
  );

const sliceTwin = (mover: MotionInput, parts: readonly string[]): Twin => ({
  name: `${mover.kind}Slice`,
  parts,
  texels: mover.texels + 1,
  outputs: 3,
  cases: (random) =>
    casesOf(strata(mover.speeds), EACH, (stratum) => {
      const { u, n } = observerInput(random, stratum);
      const anchor = scale(n, logUniform(random, 0.1, 1e5));
      return [...withLength(anchor), ...mover.draw(random, stratum, anchor), ...u, gammaOf(u)];
    }),
  cpu: (input) => {
    const u = vec3At(input, mover.texels);
    const time = dot(u, vec3At(input, 0)) / gammaOf(u);
    const line = mover.worldLine(input, time);
    const { offset, ahead } = simultaneitySlice(line, OBSERVER, u, 1);
    return expectedAt(line, offset, ahead, ahead - time);
  },
  gpu: (texel) => outputsOf(mover.slice(texel, texel(mover.texels).xyz, texel(mover.texels).w)),
  checks: placeAndTime,
});

/** As `newtonTwin` of emission.ts. */
const newtonTwin = (mover: MotionInput): Twin => ({
  name: `newtonSlice, ${mover.kind}`,
  parts: ['newtonSlice'],
  texels: mover.texels + 2,
  outputs: 3,
  cases: (random) =>
    casesOf(
      strata(mover.speeds).filter(({ gamma, beta }) => gamma <= 10 && beta <= 0.9),
      EACH,
      (stratum) => {
        const { u, n } = observerInput(random, stratum);
        const anchor = scale(n, logUniform(random, 0.1, 100));
        const settings = [Math.floor(12 * random()), 0.3 + 0.7 * random(), 0, 0];
        return [...withLength(anchor), ...mover.draw(random, stratum, anchor), ...u, gammaOf(u), ...settings];
      },
    ),
  cpu: (input) => {
    const u = vec3At(input, mover.texels);
    const time = dot(u, vec3At(input, 0)) / gammaOf(u);
    const line = mover.worldLine(input, time);
    const [iterations, damping] = input.slice(4 * (mover.texels + 1));
    const ahead = newtonSimultaneousTime(line, OBSERVER, u, 1, { iterations, damping });
    return expectedAt(line, positionAt(line, ahead, 1), ahead, ahead - time);
  },
  gpu: (texel) => {
    const [observer, settings] = [texel(mover.texels), texel(mover.texels + 1)];
    return outputsOf(newtonSlice(texel(0), mover.place(texel), observer.xyz, observer.w, int(settings.x), settings.y));
  },
  checks: placeAndTime,
});

export const simultaneityTwins: readonly Twin[] = [
  newtonTwin(motionInputs.uniform),
  newtonTwin(motionInputs.polyline),

  sliceTwin(motionInputs.uniform, ['lorentzFactorRatio']),
  sliceTwin(motionInputs.hyperbolic, ['hyperbolaVertex', 'hyperbolaCrossing', 'hyperbolaEvent', 'momentCrossing']),
  sliceTwin(motionInputs.polyline, ['bisect', 'pieceVelocity']),
  sliceTwin(motionInputs.cubic, ['bisect', 'cubicPiece', 'cubicRoot', 'evaluateCubic']),
];
