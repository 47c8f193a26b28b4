import { CHANNELS, lobeTexel } from './lobeTexel.ts';

/** How a GGX surface reflects light from all round, for one angle of view and one roughness. */
export interface SpecularLobe {
  /** Share of uniform light that is reflected: `scale` F₀ + `bias` F₉₀. */
  readonly scale: number;
  readonly bias: number;
  /** Cosine between the normal and the mean direction of the reflected light. */
  readonly cosine: number;
}

/** The middle of the same lobe, as a cone: the share of light in it, and the cone as that of `LobeParts`. */
export interface LobeCore {
  readonly share: number;
  readonly cosine: number;
  readonly width: number;
}

/** The rest of the lobe as a sum: a cone, and as much of the lobe of roughness 1. Mean and second moments are those of the rest. */
export interface LobeParts {
  /** Share of the lobe of roughness 1, ∝ N·L/(N·L + N·V). */
  readonly wide: number;
  /** Of the cone max(n·axis − c, 0): cosine between normal and axis, and √(1 − c), 1 for Lambert's cosine, 0 for a mirror. */
  readonly cosine: number;
  readonly width: number;
}

type LobeTables = { readonly [T in 'lobes' | 'core' | 'parts']: Float64Array };

/** The table's axes: √(N·V) and roughness, both 0 … 1. */
export const LOBE_TABLE_SIZE = { columns: 24, rows: 20 } as const;
/** Below this a surface reflects as if it had this roughness. */
export const MIN_LOBE_ROUGHNESS = 0.05;

/** Steps of the integral over the visible microfacet normals. */
const STEPS = { radius: 48, angle: 12 } as const;

let tables: LobeTables | undefined;

/** `SpecularLobe`, `LobeCore` and `LobeParts` row after row of roughness, 4 numbers each; integrated on first use. */
export function lobeTables(): LobeTables {
  tables ??= integrateTables();
  return tables;
}

/** Interpolated from the table. */
export function specularLobe(NV: number, roughness: number): SpecularLobe {
  const row = Math.min(Math.max(roughness, MIN_LOBE_ROUGHNESS), 1);
  const at = lobeTexel(lobeTables().lobes, LOBE_TABLE_SIZE, NV, row);
  return { scale: at(0), bias: at(1), cosine: at(2) };
}

function integrateTables(): LobeTables {
  const { columns, rows } = LOBE_TABLE_SIZE;
  const [lobes, core, parts] = [0, 1, 2].map(() => new Float64Array(CHANNELS * columns * rows));
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const NV = Math.max((column / (columns - 1)) ** 2, 1e-4);
      const { scale, bias, cosine: mean, middle, rest } = integrateLobe(NV, row / (rows - 1));
      const at = CHANNELS * (row * columns + column);
      lobes.set([scale, bias, mean], at);
      core.set(coreOf(middle, rest), at);
      const { wide, cosine, width } = partsOf(meanOf(rest), NV);
      parts.set([wide, cosine, width], at);
    }
  return { lobes, core, parts };
}

/** Sums over a lobe, or means: of the components of its directions, along the normal (up) and along the mirrored ray across it, and of their products. */
interface LobeMoments {
  readonly weight: number;
  readonly up: number;
  readonly along: number;
  readonly upUp: number;
  readonly alongAlong: number;
  readonly upAlong: number;
}

/**
 * By even steps over the distribution of visible normals (Heitz 2018), whose weight is F G₂/G₁ with the height-correlated G₂ (Heitz 2014, eq. 99) and
 * Schlick's F.
 */
function integrateLobe(NV: number, roughness: number) {
  const a = roughness * roughness;
  const level = Math.sqrt(1 - NV * NV);
  const smith = (x: number): number => Math.sqrt(x * x * (1 - a * a) + a * a);
  // V in the space in which the microsurface is a hemisphere, in the plane of N and V.
  const stretched = Math.hypot(a * level, NV);
  const [vx, vz] = [(a * level) / stretched, NV / stretched];
  let [scale, bias, up, along] = [0, 0, 0, 0];
  const [middle, rest] = [{ ...NOTHING }, { ...NOTHING }];
  const limit = 1 / Math.max(a, MIN_LOBE_ROUGHNESS ** 2) - 1;
  for (let i = 0; i < STEPS.radius; i++)
    for (let j = 0; j < STEPS.angle; j++) {
      // Dense towards the rim, where light leaves at grazing angles.
      const rim = (i + 0.5) / STEPS.radius;
      const r = Math.sqrt(1 - rim * rim);
      // The other half is its mirror image.
      const phi = Math.PI * ((j + 0.5) / STEPS.angle - 0.5);
      const x = r * Math.cos(phi);
      const y = ((1 - vz) / 2) * Math.sqrt(1 - x * x) + ((1 + vz) / 2) * r * Math.sin(phi);
      const z = Math.sqrt(Math.max(0, 1 - x * x - y * y));
      const [sx, hz] = [z * vx - y * vz, Math.max(z * vz + y * vx, 1e-9)];
      const [hx, hy] = [a * sx, a * x];
      const length = Math.hypot(hx, hy, hz);
      const VH = (level * hx + NV * hz) / length;
      const NL = (2 * VH * hz) / length - NV;
      if (NL <= 0) continue;
      const weight = (2 * rim * NL * (NV + smith(NV))) / (NL * smith(NV) + NV * smith(NL));
      const grazing = (1 - Math.min(Math.max(VH, 0), 1)) ** 5;
      // V lies on the other side of the normal than the mirrored ray.
      const across = level - (2 * VH * hx) / length;
      scale += weight * (1 - grazing);
      bias += weight * grazing;
      up += weight * NL;
      along += weight * across;
      const inside = shareOfCones((sx * sx + x * x) / (hz * hz), limit);
      for (const [sums, share] of [
        [middle, weight * inside],
        [rest, weight * (1 - inside)],
      ] as const) {
        sums.weight += share;
        sums.up += share * NL;
        sums.along += share * across;
        sums.upUp += share * NL * NL;
        sums.alongAlong += share * across * across;
        sums.upAlong += share * NL * across;
      }
    }
  const count = STEPS.radius * STEPS.angle;
  return { scale: scale / count, bias: bias / count, cosine: up / Math.hypot(up, along), middle, rest };
}

const NOTHING = { weight: 0, up: 0, along: 0, upUp: 0, alongAlong: 0, upAlong: 0 };

/**
 * GGX, 1/(1 + x)² of x = (slope/a)², is the mean of the cones 2 max(X − x, 0)/X² over the density 3X²/(1 + X)⁴ of X: the share at x of those with X < `limit`.
 */
function shareOfCones(x: number, limit: number): number {
  if (x >= limit) return 0;
  const whole = (1 + x) / (1 + limit);
  return 1 - (3 - 2 * whole) * whole * whole;
}

const meanOf = ({ weight, ...sums }: LobeMoments): LobeMoments => ({
  weight: 1,
  up: sums.up / weight,
  along: sums.along / weight,
  upUp: sums.upUp / weight,
  alongAlong: sums.alongAlong / weight,
  upAlong: sums.upAlong / weight,
});

/** The numbers of `LobeCore`. The mean cosine of a cone max(n·axis − c, 0) is (2 + c)/3. */
function coreOf({ weight, up, along }: LobeMoments, rest: LobeMoments): readonly number[] {
  const length = Math.hypot(up, along);
  if (!(length > 0)) return [0, 1, 0];
  return [weight / (weight + rest.weight), up / length, Math.sqrt(Math.min(Math.max(3 - (3 * length) / weight, 0), 1))];
}

/** Shares that are tried for the wide part. */
const WIDE_STEPS = 100;

/** The wide part is that of the roughest surface, ∝ N·L/(N·L + N·V); as much of it as gives the second moment along the axis of the cone. */
function partsOf({ up, along, upUp, alongAlong, upAlong }: LobeMoments, NV: number): LobeParts {
  // Moments of N·L and of the component across it.
  const whole = 1 - NV * Math.log((1 + NV) / NV);
  const mean = (0.5 - NV * whole) / whole;
  const square = (1 / 3 - NV * (0.5 - NV * whole)) / whole;
  const level = (1 - square) / 2;
  let best: LobeParts | undefined;
  let least = Infinity;
  for (let i = 0; i < WIDE_STEPS; i++) {
    const wide = i / WIDE_STEPS;
    const [coneUp, coneAlong] = [(up - wide * mean) / (1 - wide), along / (1 - wide)];
    const length = Math.hypot(coneUp, coneAlong);
    // The mean cosine of a cone is (2 + c)/3.
    const c = 3 * length - 2;
    if (c < 0 || c > 1 || coneUp < 0) continue;
    const [z, x] = [coneUp / length, coneAlong / length];
    const lobe = z * z * upUp + x * x * alongAlong + 2 * x * z * upAlong;
    const sum = ((1 - wide) * (3 + 2 * c + c * c)) / 6 + wide * (z * z * square + x * x * level);
    if (Math.abs(lobe - sum) < least) {
      least = Math.abs(lobe - sum);
      best = { wide, cosine: z, width: Math.sqrt(1 - c) };
    }
  }
  return best ?? { wide: 1, cosine: 1, width: 1 };
}
