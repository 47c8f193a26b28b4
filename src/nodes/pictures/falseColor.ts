import type { PictureRenderer, PictureRequest, RenderedPicture } from '../../pipelines/pictureRenderer.ts';
import { withFalseColorLegend } from '../../reference/figures/falseColorLegend.ts';
import { AOVS_OF_FALSE_COLOR, falseColorPicture, falseColorValues } from '../../reference/post/falseColor.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { FalseColorQuantity, FalseColorScale, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import { measuredFalseColorScale } from './metering.ts';
import type { PictureMeter } from './pictureMeter.ts';

/** Options of false-colour pictures. */
export interface FalseColorOptions {
  readonly size: PictureSize;
  readonly falseColour?: FalseColorQuantity;
  /** Values at the ends of the colour scale; otherwise round numbers that enclose the first picture's values. */
  readonly falseRange?: ValueRange;
  /** Whether legends are below the picture: of its false colours, and of what is drawn over it. */
  readonly legend?: boolean;
}

/** Maps data to false colours for renderers that do not. All frames of a film share the scale of the first. */
export class FalseColorRenderer {
  private readonly renderer: PictureRenderer;
  private readonly meter: PictureMeter;
  private readonly kind: FalseColorQuantity;
  private readonly options: FalseColorOptions;
  private scale: ValueRange | undefined;

  constructor(renderer: PictureRenderer, meter: PictureMeter, kind: FalseColorQuantity, options: FalseColorOptions) {
    this.renderer = renderer;
    this.meter = meter;
    this.kind = kind;
    this.options = options;
    this.scale = options.falseRange;
  }

  /** Colour scale of the pictures; undefined before the first. */
  get colors(): FalseColorScale | undefined {
    return this.scale && { kind: this.kind, ...this.scale };
  }

  async render(request: PictureRequest, onPart: (part: number) => void): Promise<RenderedPicture> {
    const { kind, options } = this;
    const { views, settings } = request;
    this.scale ??= measuredFalseColorScale(kind, await this.meter.read(views, settings, kind));
    const colors = { kind, ...this.scale };
    const pixels = await this.renderColors(colors, request, onPart);
    const picture = { ...options.size, pixels };
    return { pixels: (options.legend ? withFalseColorLegend(picture, colors) : picture).pixels, aovs: new Map() };
  }

  private async renderColors(
    colors: FalseColorScale,
    request: PictureRequest,
    onPart: (part: number) => void,
  ): Promise<Uint8Array> {
    const { kind, renderer, options } = this;
    const { views, settings } = request;
    if (renderer.measureLight) {
      const drawn = await renderer.render({ ...request, settings: { ...settings, falseColors: colors } }, onPart);
      return drawn.pixels;
    }
    const { aovs } = await renderer.render({ ...request, pixels: false, aovs: AOVS_OF_FALSE_COLOR[kind] }, onPart);
    const input = { aovs, views, settings, ...options.size };
    return falseColorPicture(colors, falseColorValues(kind, input), input).pixels;
  }
}
