import { adaptExposure, exposureForMetering, measuredFalseColorScale } from '../../nodes/pictures/metering.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import { contentKey } from '../../scene/frameGraph/frameGraph.ts';
import type { LightMeterReadings } from '../../scene/view/metering.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';

/** Between two measurements [ms], and how many pictures: each waits for the GPU, which has those to draw, and may draw one again. */
const MIN_METERING_INTERVAL = 80;
const MIN_FRAMES_BETWEEN = 4;
/** Nobody sees a smaller change [EV]: the eye is there, and nothing more is drawn. */
const SETTLED_DIFFERENCE = 0.004;

/** A picture that was drawn, and the way to measure it. */
export interface MeteredPicture {
  readonly picture: PictureSpec;
  readonly viewPoint: ViewPoint;
  readonly settings: RenderSettings;
  /** Width over height. */
  readonly aspect: number;
  readonly measureLight: () => Promise<LightMeterReadings>;
}

/**
 * The exposure of the page. The light of what is drawn is measured now and then, without anybody waiting for it, and the exposure goes there
 * as an eye does, in the person's time: also while the world's stands still. A picture that does not change is measured once, so that it comes to rest.
 */
export class AutoExposure {
  /** Without a way between: where less motion is wished for. */
  private readonly atOnce: boolean;
  private value: number | undefined;
  private target = 0;
  private gauge: LightMeterReadings | undefined;
  /** The scales of the last measurement. */
  private scaled:
    | { readonly gauge: LightMeterReadings | undefined; readonly scales: Map<FalseColorQuantity, ValueRange> }
    | undefined;
  /** Drawn, and not measured yet. */
  private drawn: MeteredPicture | undefined;
  private known = '';
  private busy = false;
  /** How often it opened. */
  private life = 0;
  private since = Number.NEGATIVE_INFINITY;

  constructor(atOnce: boolean) {
    this.atOnce = atOnce;
  }

  /** What the metering adds to the person's own exposure [EV]. */
  exposure({ metering }: PictureSpec): number {
    return metering === 'manual' ? 0 : (this.value ?? 0);
  }

  /** Of false colours: round numbers that hold what was measured last. */
  scale(kind: FalseColorQuantity): ValueRange {
    if (!this.scaled || this.scaled.gauge !== this.gauge) this.scaled = { gauge: this.gauge, scales: new Map() };
    const { scales } = this.scaled;
    const scale = scales.get(kind) ?? measuredFalseColorScale(kind, this.gauge);
    scales.set(kind, scale);
    return scale;
  }

  /** Whether all that was drawn is measured, and the eye is where that leads it. */
  get isSettled(): boolean {
    return !this.drawn && !this.busy && (this.value === undefined || this.value === this.target);
  }

  /** Opens anew: the first measurement from now on is taken as it is, and one of before, should it still come, is none. */
  reset(): void {
    this.life++;
    this.value = undefined;
    this.drawn = undefined;
    this.known = '';
  }

  /** To be told of every picture. */
  observe(drawn: MeteredPicture): void {
    const { metering, falseColor, frameGraph } = drawn.picture;
    if (metering === 'manual' && falseColor === 'none' && !frameGraph) return;
    // What is measured does not depend on how it is shown, as long as that is not seen in what a plan makes of it.
    const { exposure: _, tone: __, falseColors: ___, frameGraph: ____, ...lit } = drawn.settings;
    const what = contentKey([metering, falseColor === 'none', drawn.viewPoint, lit, frameGraph, drawn.aspect]);
    if (what === this.known) return;
    this.known = what;
    this.drawn = drawn;
  }

  /** A step of dt [s] of the person's time; `now` [ms]. Gives what is being measured, for those who would wait for it. */
  advance(dt: number, now: number): Promise<void> | undefined {
    if (this.value !== undefined) {
      const next = this.atOnce ? this.target : adaptExposure(this.value, this.target, dt);
      this.value = Math.abs(next - this.target) < SETTLED_DIFFERENCE ? this.target : next;
    }
    if (!this.drawn || this.busy || now - this.since < Math.max(MIN_METERING_INTERVAL, MIN_FRAMES_BETWEEN * 1000 * dt))
      return undefined;
    this.since = now;
    return this.measure(this.drawn);
  }

  private async measure(drawn: MeteredPicture): Promise<void> {
    const { picture, viewPoint, settings, aspect, measureLight: gauge } = drawn;
    const life = this.life;
    this.busy = true;
    this.drawn = undefined;
    try {
      const measured = await gauge();
      if (life !== this.life) return;
      this.gauge = measured;
      this.target = exposureForMetering(picture.metering, this.gauge, viewPoint, settings, aspect);
      this.value ??= this.target;
    } finally {
      this.busy = false;
    }
  }
}
