import { dot, scale, ZERO } from '../../math/vec3.ts';
import { simultaneitySlice } from '../../physics/index.ts';
import { draw, gammaOf, logUniform, lookOut, observers, vec3At, withLength } from './domain.ts';
import { expectedAt, outputsOf, placeAndTime } from './emission.ts';
import { type Mover, movers } from './movers.ts';
import type { Twin } from './twin.ts';

const OBSERVER = { t: 0, position: ZERO } as const;
const EACH = 12;

/** Every observer with every speed of the mover. */
const strata = (speeds: readonly number[]) =>
  observers.flatMap((observer) =>
    speeds.map((beta) => ({ ...observer, beta, size: 1, name: `${observer.name}, β ${beta}` })),
  );

const sliceTwin = (mover: Mover, parts: readonly string[]): Twin => ({
  name: `${mover.kind}Slice`,
  parts,
  texels: mover.texels + 1,
  outputs: 3,
  cases: (random) =>
    draw(strata(mover.speeds), EACH, (stratum) => {
      const { u, n } = lookOut(random, stratum);
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

export const slice: readonly Twin[] = [
  sliceTwin(movers.uniform, ['closing']),
  sliceTwin(movers.hyperbolic, ['hyperbolaVertex', 'hyperbolaCrossing', 'hyperbolaEvent']),
  sliceTwin(movers.polyline, ['bisect', 'pieceVelocity']),
  sliceTwin(movers.cubic, ['bisect', 'cubicPiece', 'cubicRoot', 'onCubic']),
];
