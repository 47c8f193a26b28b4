import { isFinished, type Plan } from '../../scene/plan.ts';
import type { RenderSettings } from '../../scene/view.ts';
import type { FalseColor, Scale } from '../../spectrum/falseColor.ts';
import { measuredScale } from '../metering.ts';
import { exposedPlan } from '../picture.ts';
import type { Gauges } from './gauges.ts';
import type { PictureRequest } from './painter.ts';

/** Gives a plan its exposures, and the scales of its false colours: all pictures of a film have those of its first. */
export class PlanSettings {
  private readonly gauges: Gauges;
  private readonly plan: Plan;
  private scales: Map<FalseColor, Scale> | undefined;

  constructor(gauges: Gauges, plan: Plan) {
    this.gauges = gauges;
    this.plan = plan;
  }

  /** `metered`: the exposure that the metering sets [EV]. */
  async read(request: PictureRequest, metered: number): Promise<RenderSettings> {
    this.scales ??= await this.measured(request);
    const plan = exposedPlan(this.plan, metered, (kind) => this.scales?.get(kind));
    const { exposure } = request.settings;
    return { ...request.settings, plan, exposure: isFinished(plan) ? exposure : exposure + metered };
  }

  private async measured({ view, settings }: PictureRequest): Promise<Map<FalseColor, Scale>> {
    const scales = new Map<FalseColor, Scale>();
    const kinds = this.plan.steps.flatMap((step) => (step.kind === 'false-colour' ? [step.of] : []));
    for (const kind of new Set(kinds))
      scales.set(kind, measuredScale(kind, await this.gauges.read(view, settings, kind)));
    return scales;
  }
}
