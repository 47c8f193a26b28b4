import type { OpenTypeFont } from 'opentype.js/dist/opentype.mjs';
import type { Contour, Letter, Pair, Stroke } from '../../scene/text/outline.ts';
import { unwrapped } from './woff.ts';

type Commands = ReturnType<OpenTypeFont['charToGlyph']>['path']['commands'];

/** The letters of one font file. */
export interface Face {
  /** Undefined where the file has no such letter. */
  letter(letter: string): Letter | undefined;
}

/** Reads a WOFF of TrueType outlines, which comes with the program. */
export async function readFace(bytes: Uint8Array): Promise<Face> {
  // Loaded with the first letter: no other picture needs it.
  const { parse } = await import('opentype.js/dist/opentype.mjs');
  const font = parse(unwrapped(bytes));
  return {
    letter(letter) {
      const { index, advanceWidth = 0, path } = font.charToGlyph(letter);
      const { sCapHeight: capHeight } = font.tables.os2;
      return index === 0 ? undefined : { contours: contoursOf(path.commands), advance: advanceWidth, capHeight };
    },
  };
}

function contoursOf(commands: Commands): Contour[] {
  const contours: { start: Pair; strokes: Stroke[] }[] = [];
  for (const command of commands) {
    const last = contours[contours.length - 1];
    if (command.type === 'M') contours.push({ start: [command.x, command.y], strokes: [] });
    else if (command.type === 'L') last.strokes.push({ to: [command.x, command.y] });
    else if (command.type === 'Q') last.strokes.push({ control: [command.x1, command.y1], to: [command.x, command.y] });
    else if (command.type === 'Z') last.strokes.push({ to: last.start });
    else throw new Error('the font has cubic outlines, not those of TrueType');
  }
  return contours;
}
