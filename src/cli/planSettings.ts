import { exposedPlan } from '../nodes/picture.ts';
import { AOVS_OF, falseValues } from '../reference/falseColor.ts';
import { isFinished, type Plan } from '../scene/plan.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { FalseColor, Scale } from '../spectrum/falseColor.ts';
import { scaleFor } from '../spectrum/falseScale.ts';
import type { Painter, PictureRequest } from './painter.ts';
import type { Size } from './parse.ts';

/** Gives a plan its exposures, and the scales of its false colours: all pictures of a film have those of its first. */
export class PlanSettings {
  private readonly painter: Painter;
  private readonly plan: Plan;
  private readonly size: Size;
  private scales: Map<FalseColor, Scale> | undefined;

  constructor(painter: Painter, plan: Plan, size: Size) {
    this.painter = painter;
    this.plan = plan;
    this.size = size;
  }

  /** `metered`: the exposure that the metering sets [EV]. */
  async read(request: PictureRequest, metered: number): Promise<RenderSettings> {
    this.scales ??= await this.measured(request);
    const plan = exposedPlan(this.plan, metered, (kind) => this.scales?.get(kind));
    const { exposure } = request.settings;
    return { ...request.settings, plan, exposure: isFinished(plan) ? exposure : exposure + metered };
  }

  private async measured(request: PictureRequest): Promise<Map<FalseColor, Scale>> {
    const scales = new Map<FalseColor, Scale>();
    const kinds = this.plan.steps.flatMap((step) => (step.kind === 'false-colour' ? [step.of] : []));
    for (const kind of new Set(kinds)) {
      const { plan: _, ...settings } = request.settings;
      const { view } = request;
      const { aovs } = await this.painter.paint({ ...request, settings, pixels: false, aovs: AOVS_OF[kind] });
      scales.set(kind, scaleFor(kind, falseValues(kind, { aovs, view, settings, ...this.size })));
    }
    return scales;
  }
}
