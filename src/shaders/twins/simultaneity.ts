import { dot, scale, ZERO } from '../../math/vec3.ts';
import { simultaneitySlice } from '../../physics/index.ts';
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

export const simultaneityTwins: readonly Twin[] = [
  sliceTwin(motionInputs.uniform, ['lorentzFactorRatio']),
  sliceTwin(motionInputs.hyperbolic, ['hyperbolaVertex', 'hyperbolaCrossing', 'hyperbolaEvent']),
  sliceTwin(motionInputs.polyline, ['bisect', 'pieceVelocity']),
  sliceTwin(motionInputs.cubic, ['bisect', 'cubicPiece', 'cubicRoot', 'evaluateCubic']),
];
