import type { OpenTypeFont } from 'opentype.js/dist/opentype.mjs';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { Contour, ContourSegment, Glyph, Point2 } from '../../scene/text/contours.ts';
import { unpackWoff } from './woff.ts';

type Commands = ReturnType<OpenTypeFont['charToGlyph']>['path']['commands'];

/** The glyphs of one font file. */
export interface FontFace {
  /** Undefined if the font lacks it. */
  glyph(letter: string): Glyph | undefined;
}

/** Reads a bundled WOFF with TrueType outlines. */
export async function readFontFace(bytes: Uint8Array): Promise<FontFace> {
  // Loaded lazily: only text needs it.
  const { parse } = await import('opentype.js/dist/opentype.mjs');
  const font = parse(unpackWoff(bytes));
  return {
    glyph(letter) {
      const { index, advanceWidth = 0, path } = font.charToGlyph(letter);
      const { sCapHeight: capHeight } = font.tables.os2;
      return index === 0 ? undefined : { contours: contoursFromPath(path.commands), advance: advanceWidth, capHeight };
    },
  };
}

function contoursFromPath(commands: Commands): Contour[] {
  const contours: { start: Point2; segments: ContourSegment[] }[] = [];
  for (const command of commands) {
    const last = contours[contours.length - 1];
    if (command.type === 'M') contours.push({ start: [command.x, command.y], segments: [] });
    else if (command.type === 'L') last.segments.push({ to: [command.x, command.y] });
    else if (command.type === 'Q')
      last.segments.push({ control: [command.x1, command.y1], to: [command.x, command.y] });
    else if (command.type === 'Z') last.segments.push({ to: last.start });
    else throw new MessageError(msg`the font has cubic outlines, not those of TrueType`);
  }
  return contours;
}
