import { AOVS_OF, falsePicture, falseValues } from '../reference/falseColor.ts';
import { legendRoom, withLegend } from '../reference/falseLegend.ts';
import type { FalseColor, FalseColors, Scale } from '../spectrum/falseColor.ts';
import { scaleFor } from '../spectrum/falseScale.ts';
import type { Painter, Picture, PictureRequest } from './painter.ts';
import type { Size } from './parse.ts';

export interface FalseColourFlags {
  readonly size: Size;
  readonly falseColour?: FalseColor;
  /** The values at both ends of the colours; without it, round numbers that hold what the first picture has. */
  readonly falseRange?: Scale;
  readonly legend?: boolean;
}

/** Of the files that are written, with the legend where there is one. */
export const writtenSize = ({ size, falseColour, legend }: FalseColourFlags): Size =>
  falseColour && legend ? { ...size, height: size.height + legendRoom(size.width, falseColour) } : size;

/** Makes pictures whose colours stand for numbers, from the data of whatever draws. All of a film have the scale of its first. */
export class FalseColourPainter {
  private readonly painter: Painter;
  private readonly kind: FalseColor;
  private readonly flags: FalseColourFlags;
  private scale: Scale | undefined;

  constructor(painter: Painter, kind: FalseColor, flags: FalseColourFlags) {
    this.painter = painter;
    this.kind = kind;
    this.flags = flags;
    this.scale = flags.falseRange;
  }

  /** What the colours of the pictures mean; undefined before the first. */
  get colors(): FalseColors | undefined {
    return this.scale && { kind: this.kind, ...this.scale };
  }

  async paint(request: PictureRequest, onPart: (part: number) => void): Promise<Picture> {
    const { kind, painter, flags } = this;
    const { view, settings } = request;
    const { aovs } = await painter.paint({ ...request, pixels: false, aovs: AOVS_OF[kind] }, onPart);
    const taken = { aovs, view, settings, ...flags.size };
    const values = falseValues(kind, taken);
    this.scale ??= scaleFor(kind, values);
    const colors = { kind, ...this.scale };
    const picture = falsePicture(colors, values, taken);
    return { pixels: (flags.legend ? withLegend(picture, colors) : picture).pixels, aovs: new Map() };
  }
}
