import type { Verdict } from './judge.ts';

/** What came out for one picture, or for several together. */
export class Tally {
  private readonly displacements: number[] = [];
  private readonly times: number[] = [];
  private readonly dopplers: number[] = [];
  private readonly velocities: number[] = [];
  private albedos = { asked: 0, unfit: 0 };
  private wrongPixels: number[] = [];
  private judged = 0;

  add(pixel: number, verdict: Verdict): void {
    this.judged++;
    if (!verdict.right) this.wrongPixels.push(pixel);
    // Where an object is shown that is nowhere near, the distance says nothing.
    if (Number.isFinite(verdict.displacement)) this.displacements.push(verdict.displacement);
    if (!verdict.right) return;
    this.times.push(verdict.time);
    this.dopplers.push(verdict.doppler);
    this.velocities.push(verdict.velocity);
  }

  addAlbedo(fits: boolean | undefined): void {
    if (fits === undefined) return;
    this.albedos.asked++;
    if (!fits) this.albedos.unfit++;
  }

  /** Share of the judged pixels. */
  get wrong(): number {
    return this.wrongPixels.length / Math.max(1, this.judged);
  }
  get pixels(): number {
    return this.judged;
  }
  /** The first of them, to look at. */
  get wrongPlaces(): readonly number[] {
    return this.wrongPixels.slice(0, 8);
  }
  /** Of what is truly seen near the pixel at all [px]. */
  get worstDisplacement(): number {
    return worst(this.displacements);
  }
  get time(): Spread {
    return spread(this.times);
  }
  get doppler(): Spread {
    return spread(this.dopplers);
  }
  get velocity(): Spread {
    return spread(this.velocities);
  }
  get albedoUnfit(): number {
    return this.albedos.unfit / Math.max(1, this.albedos.asked);
  }

  line(): string {
    const { time, doppler, velocity } = this;
    const exponential = ({ most, worst: extreme }: Spread): string =>
      `${most.toExponential(0)}/${extreme.toExponential(0)}`;
    return [
      `${this.judged} px, wrong ${(100 * this.wrong).toFixed(3)} %`,
      `displaced 99 % ${quantile(this.displacements, 0.99).toFixed(2)} worst ${this.worstDisplacement.toFixed(2)} px`,
      `time ${exponential(time)}, D ${exponential(doppler)}, v ${exponential(velocity)}`,
      `albedo off ${(100 * this.albedoUnfit).toFixed(1)} %`,
    ].join('; ');
  }
}

/** What 99 % of the pixels stay below, and all. */
export interface Spread {
  readonly most: number;
  readonly worst: number;
}

const worst = (values: readonly number[]): number => values.reduce((most, value) => Math.max(most, value), 0);
const spread = (values: readonly number[]): Spread => ({ most: quantile(values, 0.99), worst: worst(values) });

function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(share * (sorted.length - 1))] ?? 0;
}
