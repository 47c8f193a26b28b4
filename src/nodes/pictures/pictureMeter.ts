import type { PictureRenderer } from '../../pipelines/pictureRenderer.ts';
import { AOVS_OF_FALSE_COLOR, falseColorValues } from '../../reference/post/falseColor.ts';
import { includesToneMapping } from '../../scene/frameGraph/frameGraph.ts';
import { type LightMeterReadings, METER_CELLS, meterPixel } from '../../scene/view/metering.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { PictureViews } from '../../scene/view/pictureViews.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import type { FalseColorQuantity } from '../../spectrum/falseColor/falseColor.ts';

/** Measures pictures at the same sample positions as the page, so that exposures and scales agree. */
export class PictureMeter {
  private readonly renderer: PictureRenderer;
  private readonly size: PictureSize;

  constructor(renderer: PictureRenderer, size: PictureSize) {
    this.renderer = renderer;
    this.size = size;
  }

  /** Values of a false-colour quantity; `radiance`: the luminance that metering uses. */
  async read(views: PictureViews, settings: RenderSettings, kind: FalseColorQuantity): Promise<LightMeterReadings> {
    const { renderer, size } = this;
    if (renderer.measureLight) return renderer.measureLight(views, settings);
    const { frameGraph, ...plain } = settings;
    const lit = kind !== 'radiance' || includesToneMapping(frameGraph) ? plain : settings;
    const request = { views, settings: lit, samples: 1, pixels: false, aovs: AOVS_OF_FALSE_COLOR[kind] };
    const { aovs } = await renderer.render(request);
    const at = (quantity: FalseColorQuantity) =>
      AOVS_OF_FALSE_COLOR[quantity].every((name) => aovs.has(name))
        ? sampleMeterCells(falseColorValues(quantity, { aovs, views, settings: lit, ...size }), size)
        : new Float32Array();
    return { luminance: at('radiance'), doppler: at('doppler'), time: at('emission-time') };
  }
}

/** Selects the meter's cells from all pixels. */
const sampleMeterCells = (values: Float32Array, { width, height }: PictureSize): Float32Array =>
  Float32Array.from(
    { length: METER_CELLS * METER_CELLS },
    (_, i) => values[meterPixel(Math.floor(i / METER_CELLS), height) * width + meterPixel(i % METER_CELLS, width)]!,
  );
