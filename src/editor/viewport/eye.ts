import type { Picture } from '../../nodes/define.ts';
import { eased, exposureFor, measuredScale } from '../../nodes/metering.ts';
import type { Gauge } from '../../scene/gauge.ts';
import { textOf } from '../../scene/plan.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view.ts';
import type { FalseColor, Scale } from '../../spectrum/falseColor.ts';

/** Between two measurements [ms], and how many pictures: each waits for the GPU, which has those to draw, and may draw one again. */
const INTERVAL = 80;
const PICTURES = 4;
/** Nobody sees a smaller change [EV]: the eye is there, and nothing more is drawn. */
const THERE = 0.004;

/** A picture that was drawn, and the way to measure it. */
export interface Drawn {
  readonly picture: Picture;
  readonly viewPoint: ViewPoint;
  readonly settings: RenderSettings;
  /** Width over height. */
  readonly aspect: number;
  readonly gauge: () => Promise<Gauge>;
}

/**
 * The exposure of the page. The light of what is drawn is measured now and then, without anybody waiting for it, and the exposure goes there
 * as an eye does, in the person's time: also while the world's stands still. A picture that does not change is measured once, so that it comes to rest.
 */
export class Eye {
  /** Without a way between: where less motion is wished for. */
  readonly #atOnce: boolean;
  #value: number | undefined;
  #target = 0;
  #gauge: Gauge | undefined;
  /** The scales of the last measurement. */
  #scaled: { readonly gauge: Gauge | undefined; readonly scales: Map<FalseColor, Scale> } | undefined;
  /** Drawn, and not measured yet. */
  #drawn: Drawn | undefined;
  #known = '';
  #busy = false;
  /** How often it opened. */
  #life = 0;
  #since = Number.NEGATIVE_INFINITY;

  constructor(atOnce: boolean) {
    this.#atOnce = atOnce;
  }

  /** What the metering adds to the person's own exposure [EV]. */
  exposure({ metering }: Picture): number {
    return metering === 'manual' ? 0 : (this.#value ?? 0);
  }

  /** Of false colours: round numbers that hold what was measured last. */
  scale(kind: FalseColor): Scale {
    if (!this.#scaled || this.#scaled.gauge !== this.#gauge) this.#scaled = { gauge: this.#gauge, scales: new Map() };
    const { scales } = this.#scaled;
    const scale = scales.get(kind) ?? measuredScale(kind, this.#gauge);
    scales.set(kind, scale);
    return scale;
  }

  /** Whether all that was drawn is measured, and the eye is where that leads it. */
  get rests(): boolean {
    return !this.#drawn && !this.#busy && (this.#value === undefined || this.#value === this.#target);
  }

  /** Opens anew: the first measurement from now on is taken as it is, and one of before, should it still come, is none. */
  blink(): void {
    this.#life++;
    this.#value = undefined;
    this.#drawn = undefined;
    this.#known = '';
  }

  /** To be told of every picture. */
  see(drawn: Drawn): void {
    const { metering, falseColor, plan } = drawn.picture;
    if (metering === 'manual' && falseColor === 'none' && !plan) return;
    // What is measured does not depend on how it is shown, as long as that is not seen in what a plan makes of it.
    const { exposure: _, tone: __, falseColors: ___, plan: ____, ...lit } = drawn.settings;
    const what = textOf([metering, falseColor === 'none', drawn.viewPoint, lit, plan, drawn.aspect]);
    if (what === this.#known) return;
    this.#known = what;
    this.#drawn = drawn;
  }

  /** A step of dt [s] of the person's time; `now` [ms]. Gives what is being measured, for those who would wait for it. */
  advance(dt: number, now: number): Promise<void> | undefined {
    if (this.#value !== undefined) {
      const next = this.#atOnce ? this.#target : eased(this.#value, this.#target, dt);
      this.#value = Math.abs(next - this.#target) < THERE ? this.#target : next;
    }
    if (!this.#drawn || this.#busy || now - this.#since < Math.max(INTERVAL, PICTURES * 1000 * dt)) return undefined;
    this.#since = now;
    return this.#measure(this.#drawn);
  }

  async #measure(drawn: Drawn): Promise<void> {
    const { picture, viewPoint, settings, aspect, gauge } = drawn;
    const life = this.#life;
    this.#busy = true;
    this.#drawn = undefined;
    try {
      const measured = await gauge();
      if (life !== this.#life) return;
      this.#gauge = measured;
      this.#target = exposureFor(picture.metering, this.#gauge, viewPoint, settings, aspect);
      this.#value ??= this.#target;
    } finally {
      this.#busy = false;
    }
  }
}
