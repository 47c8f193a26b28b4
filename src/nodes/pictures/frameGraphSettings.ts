import type { PictureRequest } from '../../pipelines/pictureRenderer.ts';
import { type FrameGraph, includesToneMapping } from '../../scene/frameGraph/frameGraph.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import { measuredFalseColorScale } from './metering.ts';
import type { PictureMeter } from './pictureMeter.ts';
import { exposedFrameGraph } from './renderSettings.ts';

/** Sets exposures and false-colour scales of a frame graph; all frames of a film share the scales of the first. */
export class FrameGraphSettings {
  private readonly meter: PictureMeter;
  private readonly frameGraph: FrameGraph;
  private scales: Map<FalseColorQuantity, ValueRange> | undefined;

  constructor(meter: PictureMeter, frameGraph: FrameGraph) {
    this.meter = meter;
    this.frameGraph = frameGraph;
  }

  /** `metered`: metered exposure [EV]. */
  async read(request: PictureRequest, metered: number): Promise<RenderSettings> {
    this.scales ??= await this.measured(request);
    const frameGraph = exposedFrameGraph(this.frameGraph, metered, (kind) => this.scales?.get(kind));
    const { exposure } = request.settings;
    return {
      ...request.settings,
      frameGraph,
      exposure: includesToneMapping(frameGraph) ? exposure : exposure + metered,
    };
  }

  private async measured({ views, settings }: PictureRequest): Promise<Map<FalseColorQuantity, ValueRange>> {
    const scales = new Map<FalseColorQuantity, ValueRange>();
    const kinds = this.frameGraph.passes.flatMap((pass) => (pass.kind === 'false-colour' ? [pass.of] : []));
    for (const kind of new Set(kinds))
      scales.set(kind, measuredFalseColorScale(kind, await this.meter.read(views, settings, kind)));
    return scales;
  }
}
