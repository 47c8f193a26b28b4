import { CHANNELS, lobeTexel } from './lobeTexel.ts';

/** How a layer of fuzz reflects light from all round, for one angle of view and one roughness. */
export interface SheenLobe {
  /** Share of uniform light that white fuzz reflects, 0 … 1. */
  readonly share: number;
  /** What `sheenTerm` is multiplied by: less than 1 where it would reflect more light than there is, as smooth fuzz does at grazing angles. */
  readonly gain: number;
  /** Cosine between the normal and the mean direction of the reflected light. */
  readonly cosine: number;
}

/** The table's axes: √(N·V), and roughness from MIN_SHEEN_ROUGHNESS to 1. */
export const SHEEN_TABLE_SIZE = { columns: 24, rows: 20 } as const;
/** Below this fuzz reflects as if it had this roughness. */
export const MIN_SHEEN_ROUGHNESS = 0.07;

/**
 * Distribution times visibility of upright fibres, which white fuzz's BRDF is (docs/physics.md §6.7). Source: Estevez and Kulla 2017, "Production friendly
 * microfacet sheen BRDF", with their fit of Λ.
 */
export function sheenTerm(NL: number, NV: number, NH: number, roughness: number): number {
  const alpha = Math.max(roughness, MIN_SHEEN_ROUGHNESS) ** 2;
  const seen = (1 + sheenLambda(NV, alpha) + sheenLambda(NL, alpha)) * 4 * NL * NV;
  return fibreDistribution(NH, alpha) / seen;
}

const fibreDistribution = (NH: number, alpha: number): number =>
  ((2 + 1 / alpha) * Math.max(1 - NH * NH, 0) ** (0.5 / alpha)) / (2 * Math.PI);

/** The fits of Estevez and Kulla at α = 1 and α = 0: a/(1 + b xᶜ) + d x + e. */
export const SHEEN_FITS = {
  rough: [21.5473, 3.82987, 0.19823, -1.9776, -4.32054],
  smooth: [25.3245, 3.32435, 0.16801, -1.27393, -4.85967],
} as const;

/** Λ of a cosine: how much of the fibres is hidden. */
function sheenLambda(cosine: number, alpha: number): number {
  const t = (1 - alpha) ** 2;
  const fitted = (x: number): number => {
    const [a, b, c, d, e] = SHEEN_FITS.rough.map((rough, i) => rough + t * (SHEEN_FITS.smooth[i] - rough));
    return a / (1 + b * x ** c) + d * x + e;
  };
  return Math.exp(cosine < 0.5 ? fitted(cosine) : 2 * fitted(0.5) - fitted(1 - cosine));
}

let table: Float64Array | undefined;

/** `SheenLobe` row after row of roughness, integrated on first use. */
export function sheenTable(): Float64Array {
  table ??= integrated();
  return table;
}

/** Interpolated from the table. */
export function sheenLobe(NV: number, roughness: number): SheenLobe {
  const row = sheenRow(Math.min(Math.max(roughness, MIN_SHEEN_ROUGHNESS), 1));
  const at = lobeTexel(sheenTable(), SHEEN_TABLE_SIZE, NV, row);
  return { share: at(0), cosine: at(1), gain: at(2) };
}

/** Place of a roughness in the table, 0 … 1. */
const sheenRow = (roughness: number): number => (roughness - MIN_SHEEN_ROUGHNESS) / (1 - MIN_SHEEN_ROUGHNESS);

/** Steps of the integral over the hemisphere of light. */
const STEPS = { up: 48, around: 48 } as const;

function integrated(): Float64Array {
  const { columns, rows } = SHEEN_TABLE_SIZE;
  const out = new Float64Array(CHANNELS * columns * rows);
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const roughness = MIN_SHEEN_ROUGHNESS + (1 - MIN_SHEEN_ROUGHNESS) * (row / (rows - 1));
      const { share, cosine, gain } = integrateSheen(Math.max((column / (columns - 1)) ** 2, 1e-3), roughness);
      out.set([share, cosine, gain], CHANNELS * (row * columns + column));
    }
  return out;
}

function integrateSheen(NV: number, roughness: number): SheenLobe {
  const alpha = roughness ** 2;
  const level = Math.sqrt(1 - NV * NV);
  const hidden = 1 + sheenLambda(NV, alpha);
  let [whole, up, along] = [0, 0, 0];
  for (let i = 0; i < STEPS.up; i++) {
    // Dense towards the horizon: N·L = u².
    const u = (i + 0.5) / STEPS.up;
    const NL = u * u;
    const flat = Math.sqrt(1 - NL * NL);
    // dΩ = 2u du dφ over all φ; the two N·L cancel.
    const part = (2 * u * 2 * Math.PI) / (STEPS.up * STEPS.around) / ((hidden + sheenLambda(NL, alpha)) * 4 * NV);
    for (let j = 0; j < STEPS.around; j++) {
      // The other half is its mirror image.
      const x = flat * Math.cos((Math.PI * (j + 0.5)) / STEPS.around);
      const NH = (NL + NV) / Math.sqrt(Math.max(2 + 2 * (x * level + NL * NV), 1e-12));
      const weight = part * fibreDistribution(NH, alpha);
      whole += weight;
      up += weight * NL;
      // Away from the observer, as the mirrored ray.
      along -= weight * x;
    }
  }
  const length = Math.hypot(up, along);
  return { share: Math.min(whole, 1), cosine: length > 0 ? up / length : 1, gain: 1 / Math.max(whole, 1) };
}
