import type { PixelOracle, PixelVerdict } from './pixelOracle.ts';
import { pixelSampleAt } from './pixels.ts';

/** Values compared at right pixels. D and velocity are separate for surfaces of varying velocity. */
export const MEASURES = ['time', 'depth', 'doppler', 'velocity', 'changing doppler', 'changing velocity'] as const;
export type Measure = (typeof MEASURES)[number];

/** Upper bounds for 99 % of the pixels, and for all. */
export interface Spread {
  readonly most: number;
  readonly worst: number;
}

/** Tolerance of base colours beyond their neighbourhood: mipmaps and anisotropic filters differ between GPUs. */
const ALBEDO_SLACK = 0.08;
/** Fraction of base colours allowed outside their neighbourhood: mipmaps and anisotropic filters differ between GPUs. */
export const ALBEDO_UNFIT = 0.02;
/**
 * Interval of pixels whose base colour is checked, which costs 49 rays each; and the interval that decides if too many of those do not fit. A hundred pixels
 * measure a fraction of 0.02 only to ± 0.014: a scene with 0.015 of 824 pixels had 0.024 of every 61st.
 */
const ALBEDO_STEPS = [61, 7] as const;

/** Results for one or several pictures. */
export class ErrorTally {
  private readonly displacements: number[] = [];
  private readonly errors = new Map<Measure, number[]>(MEASURES.map((name) => [name, []]));
  private readonly wrongPixels: number[] = [];
  private albedos = { asked: 0, unfit: 0 };
  private judged = 0;

  add(pixel: number, verdict: PixelVerdict): void {
    this.judged++;
    // Behind the camera the displacement is meaningless.
    if (Number.isFinite(verdict.displacement)) this.displacements.push(verdict.displacement);
    if (!verdict.right) {
      this.wrongPixels.push(pixel);
      return;
    }
    const kind = verdict.changing ? 'changing ' : '';
    this.errors.get('time')?.push(verdict.time);
    this.errors.get('depth')?.push(verdict.depth);
    this.errors.get(`${kind}doppler`)?.push(verdict.doppler);
    this.errors.get(`${kind}velocity`)?.push(verdict.velocity);
  }

  /** Replaces the results for base colours; undefined: not comparable. */
  setAlbedos(results: readonly (boolean | undefined)[]): void {
    const asked = results.filter((fits) => fits !== undefined);
    this.albedos = { asked: asked.length, unfit: asked.filter((fits) => !fits).length };
  }

  /** Fraction of the judged pixels. */
  get wrong(): number {
    return this.wrongPixels.length / Math.max(1, this.judged);
  }
  /** Indices of the first wrong pixels, for inspection. */
  get wrongPlaces(): readonly number[] {
    return this.wrongPixels.slice(0, 8);
  }
  /** Displacements: from pixel centres to the true positions [px]. */
  get displacement(): Spread {
    return spread(this.displacements);
  }
  error(measure: Measure): Spread {
    return spread(this.errors.get(measure) ?? []);
  }
  get albedoUnfit(): number {
    return this.albedos.unfit / Math.max(1, this.albedos.asked);
  }

  line(): string {
    const { most, worst } = this.displacement;
    const errors = MEASURES.map((name) => [name, this.error(name)] as const).filter(([, { worst }]) => worst > 0);
    const exponential = (x: number): string => x.toExponential(0).replace('e-', 'e−');
    return [
      `wrong ${(100 * this.wrong).toFixed(3)} % of ${this.judged}`,
      `displaced ${most.toFixed(2)}/${worst.toFixed(2)} px`,
      ...errors.map(([name, e]) => `${name} ${exponential(e.most)}/${exponential(e.worst)}`),
      `albedo ${(100 * this.albedoUnfit).toFixed(1)} %`,
    ].join(', ');
  }
}

/** Judges the given pixels of a picture; `values`: from `readSamplePixels`. */
export function tallyErrors(judge: PixelOracle, values: Float32Array, pixels: readonly number[]): ErrorTally {
  const tally = new ErrorTally();
  const withAlbedo: { readonly k: number; readonly fits: () => boolean | undefined }[] = [];
  pixels.forEach((pixel, k) => {
    const claim = pixelSampleAt(values, k);
    const verdict = judge.judge(pixel, claim);
    tally.add(pixel, verdict);
    if (verdict.right && claim.object > 0)
      withAlbedo.push({ k, fits: () => judge.albedoFits(pixel, claim, ALBEDO_SLACK) });
  });
  for (const step of ALBEDO_STEPS) {
    tally.setAlbedos(withAlbedo.filter(({ k }) => k % step === 0).map(({ fits }) => fits()));
    if (tally.albedoUnfit <= ALBEDO_UNFIT) break;
  }
  return tally;
}

function spread(values: readonly number[]): Spread {
  const sorted = [...values].sort((a, b) => a - b);
  const last = sorted.length - 1;
  return { most: sorted[Math.floor(0.99 * last)] ?? 0, worst: sorted[last] ?? 0 };
}
