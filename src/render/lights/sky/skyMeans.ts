import { toHalf } from '../../../math/half.ts';
import { gradientAt, type SkyColors } from '../../../scene/lights/skyGradient.ts';
import type { HalfTexels } from '../../../shaders/tables/halfAtlas.ts';

// Means over the sky, weighted by the cone max(n·a − c, 0) about the axis a: of the radiance L, and of L times the components of n; and of L over the whole
// cone alike. The rapidity η of a cone has c = −tanh η: a boost along the axis adds to it (docs/physics.md §6.8).

/** The rapidities for which means are tabulated. */
export const MEAN_RAPIDITIES = { first: -2.1, step: 0.3, count: 15 } as const;

/** c of a level of the tables. */
export const coneCosine = (level: number): number => -Math.tanh(MEAN_RAPIDITIES.first + level * MEAN_RAPIDITIES.step);

/** Steps in the axis' height, and of the integrals along and around the axis. */
export const GRADIENT_HEIGHTS = 64;
const STEPS = { along: 16, around: 16 } as const;

/** Each channel is the share of one colour: zenith, horizon, ground. */
const SHARES: SkyColors = { zenith: [1, 0, 0], horizon: [0, 1, 0], ground: [0, 0, 1] };

let gradient: HalfTexels | undefined;

/**
 * The means of any sky that is a gradient, as shares of its three colours: by the axis' height −1 … 1 across; down the rapidities of L, then of L times the
 * height of n, then of L times its component along the horizon towards the axis, then of L over all of the cone alike.
 */
export function gradientMeans(): HalfTexels {
  gradient ??= integrateGradient();
  return gradient;
}

function integrateGradient(): HalfTexels {
  const { count } = MEAN_RAPIDITIES;
  const data = new Uint16Array(4 * GRADIENT_HEIGHTS * count * 4);
  for (let level = 0; level < count; level++)
    for (let i = 0; i < GRADIENT_HEIGHTS; i++)
      gradientMean((2 * i) / (GRADIENT_HEIGHTS - 1) - 1, coneCosine(level)).forEach((mean, k) => {
        data.set(mean.map(toHalf), 4 * ((k * count + level) * GRADIENT_HEIGHTS + i));
      });
  return { data, width: GRADIENT_HEIGHTS };
}

/** Of L, L n_up, L n_across, and L without weights, as shares of the colours. */
function gradientMean(height: number, c: number): readonly number[][] {
  const sums = Array.from({ length: 3 }, () => [0, 0, 0]);
  const even = [0, 0, 0];
  let whole = 0;
  const level = Math.sqrt(Math.max(1 - height * height, 0));
  for (let i = 0; i < STEPS.along; i++) {
    const cosine = c + ((1 - c) * (i + 0.5)) / STEPS.along;
    const sine = Math.sqrt(1 - cosine * cosine);
    for (let j = 0; j < STEPS.around; j++) {
      const turned = sine * Math.cos((Math.PI * (j + 0.5)) / STEPS.around);
      const [up, across] = [height * cosine + level * turned, level * cosine - height * turned];
      const shares = gradientAt(up, SHARES);
      whole += cosine - c;
      for (let n = 0; n < 3; n++) even[n] += shares[n] / (STEPS.along * STEPS.around);
      [1, up, across].forEach((factor, k) => {
        for (let n = 0; n < 3; n++) sums[k][n] += (cosine - c) * factor * shares[n];
      });
    }
  }
  return [...sums.map((shares) => shares.map((share) => share / whole)), even];
}
