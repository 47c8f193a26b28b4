import { AOVS_OF, falsePicture, falseValues } from '../../reference/falseColor.ts';
import { legendRoom, withLegend } from '../../reference/falseLegend.ts';
import type { FalseColor, FalseColors, Scale } from '../../spectrum/falseColor.ts';
import { measuredScale } from '../metering.ts';
import type { Gauges } from './gauges.ts';
import type { Painted, PicturePainter, PictureRequest, Size } from './painter.ts';

/** Pictures whose colours are to stand for numbers. */
export interface FalseColouring {
  readonly size: Size;
  readonly falseColour?: FalseColor;
  /** The values at both ends of the colours; without it, round numbers that hold what the first picture has. */
  readonly falseRange?: Scale;
  readonly legend?: boolean;
}

/** Of the files that are written, with the legend where there is one. */
export const writtenSize = ({ size, falseColour, legend }: FalseColouring): Size =>
  falseColour && legend ? { ...size, height: size.height + legendRoom(size.width, falseColour) } : size;

/** Makes pictures whose colours stand for numbers, where a painter does not from its data. All of a film have the scale of its first. */
export class FalseColourPainter {
  private readonly painter: PicturePainter;
  private readonly gauges: Gauges;
  private readonly kind: FalseColor;
  private readonly wanted: FalseColouring;
  private scale: Scale | undefined;

  constructor(painter: PicturePainter, gauges: Gauges, kind: FalseColor, wanted: FalseColouring) {
    this.painter = painter;
    this.gauges = gauges;
    this.kind = kind;
    this.wanted = wanted;
    this.scale = wanted.falseRange;
  }

  /** What the colours of the pictures mean; undefined before the first. */
  get colors(): FalseColors | undefined {
    return this.scale && { kind: this.kind, ...this.scale };
  }

  async paint(request: PictureRequest, onPart: (part: number) => void): Promise<Painted> {
    const { kind, wanted } = this;
    const { view, settings } = request;
    this.scale ??= measuredScale(kind, await this.gauges.read(view, settings, kind));
    const colors = { kind, ...this.scale };
    const pixels = await this.coloured(colors, request, onPart);
    const picture = { ...wanted.size, pixels };
    return { pixels: (wanted.legend ? withLegend(picture, colors) : picture).pixels, aovs: new Map() };
  }

  private async coloured(
    colors: FalseColors,
    request: PictureRequest,
    onPart: (part: number) => void,
  ): Promise<Uint8Array> {
    const { kind, painter, wanted } = this;
    const { view, settings } = request;
    if (painter.measure) {
      const painted = await painter.paint({ ...request, settings: { ...settings, falseColors: colors } }, onPart);
      return painted.pixels;
    }
    const { aovs } = await painter.paint({ ...request, pixels: false, aovs: AOVS_OF[kind] }, onPart);
    const taken = { aovs, view, settings, ...wanted.size };
    return falsePicture(colors, falseValues(kind, taken), taken).pixels;
  }
}
