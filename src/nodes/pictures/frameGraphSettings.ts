import type { PictureRequest } from '../../pipelines/pictureRenderer.ts';
import { type FrameGraph, includesToneMapping } from '../../scene/frameGraph/frameGraph.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import { measuredFalseColorScale } from './metering.ts';
import type { PictureMeter } from './pictureMeter.ts';
import { exposedFrameGraph } from './renderSettings.ts';

/** Sets exposures and false-colour scales of a frame graph; all frames of a film share the scales of the first. */
export class FrameGraphSettings {
  private readonly gauges: PictureMeter;
  private readonly plan: FrameGraph;
  private scales: Map<FalseColorQuantity, ValueRange> | undefined;

  constructor(gauges: PictureMeter, frameGraph: FrameGraph) {
    this.gauges = gauges;
    this.plan = frameGraph;
  }

  /** `metered`: metered exposure [EV]. */
  async read(request: PictureRequest, metered: number): Promise<RenderSettings> {
    this.scales ??= await this.measured(request);
    const frameGraph = exposedFrameGraph(this.plan, metered, (kind) => this.scales?.get(kind));
    const { exposure } = request.settings;
    return {
      ...request.settings,
      frameGraph,
      exposure: includesToneMapping(frameGraph) ? exposure : exposure + metered,
    };
  }

  private async measured({ views, settings }: PictureRequest): Promise<Map<FalseColorQuantity, ValueRange>> {
    const scales = new Map<FalseColorQuantity, ValueRange>();
    const kinds = this.plan.passes.flatMap((step) => (step.kind === 'false-colour' ? [step.of] : []));
    for (const kind of new Set(kinds))
      scales.set(kind, measuredFalseColorScale(kind, await this.gauges.read(views, settings, kind)));
    return scales;
  }
}
