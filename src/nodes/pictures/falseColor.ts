import type { PictureRenderer, PictureRequest, RenderedPicture } from '../../pipelines/pictureRenderer.ts';
import { falseColorLegendHeight, withFalseColorLegend } from '../../reference/figures/falseColorLegend.ts';
import { AOVS_OF_FALSE_COLOR, falseColorPicture, falseColorValues } from '../../reference/post/falseColor.ts';
import type { PictureSize } from '../../scene/view/pictureViews.ts';
import type { FalseColorQuantity, FalseColorScale, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import { measuredFalseColorScale } from './metering.ts';
import type { PictureMeter } from './pictureMeter.ts';

/** Options of false-colour pictures. */
export interface FalseColorOptions {
  readonly size: PictureSize;
  readonly falseColour?: FalseColorQuantity;
  /** Values at the ends of the colour scale; otherwise round numbers that enclose the first picture's values. */
  readonly falseRange?: ValueRange;
  readonly legend?: boolean;
}

/** Size of written files, with the legend if there is one. */
export const outputSize = ({ size, falseColour, legend }: FalseColorOptions): PictureSize =>
  falseColour && legend ? { ...size, height: size.height + falseColorLegendHeight(size.width, falseColour) } : size;

/** Maps data to false colours for renderers that do not. All frames of a film share the scale of the first. */
export class FalseColorRenderer {
  private readonly renderer: PictureRenderer;
  private readonly gauges: PictureMeter;
  private readonly kind: FalseColorQuantity;
  private readonly wanted: FalseColorOptions;
  private scale: ValueRange | undefined;

  constructor(renderer: PictureRenderer, gauges: PictureMeter, kind: FalseColorQuantity, wanted: FalseColorOptions) {
    this.renderer = renderer;
    this.gauges = gauges;
    this.kind = kind;
    this.wanted = wanted;
    this.scale = wanted.falseRange;
  }

  /** Colour scale of the pictures; undefined before the first. */
  get colors(): FalseColorScale | undefined {
    return this.scale && { kind: this.kind, ...this.scale };
  }

  async render(request: PictureRequest, onPart: (part: number) => void): Promise<RenderedPicture> {
    const { kind, wanted } = this;
    const { views, settings } = request;
    this.scale ??= measuredFalseColorScale(kind, await this.gauges.read(views, settings, kind));
    const colors = { kind, ...this.scale };
    const pixels = await this.renderColors(colors, request, onPart);
    const picture = { ...wanted.size, pixels };
    return { pixels: (wanted.legend ? withFalseColorLegend(picture, colors) : picture).pixels, aovs: new Map() };
  }

  private async renderColors(
    colors: FalseColorScale,
    request: PictureRequest,
    onPart: (part: number) => void,
  ): Promise<Uint8Array> {
    const { kind, renderer: painter, wanted } = this;
    const { views, settings } = request;
    if (painter.measureLight) {
      const painted = await painter.render({ ...request, settings: { ...settings, falseColors: colors } }, onPart);
      return painted.pixels;
    }
    const { aovs } = await painter.render({ ...request, pixels: false, aovs: AOVS_OF_FALSE_COLOR[kind] }, onPart);
    const taken = { aovs, views, settings, ...wanted.size };
    return falseColorPicture(colors, falseColorValues(kind, taken), taken).pixels;
  }
}
