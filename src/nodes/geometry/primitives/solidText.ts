import { type LocalizedText, listed, msg } from '../../../messages/message.ts';
import type { Glyph } from '../../../scene/text/contours.ts';
import type { TextStyle } from '../../../scene/text/textMesh.ts';
import { InputError } from '../../../scene/types.ts';
import { nodeRefusal } from '../../common/params.ts';
import type { Services } from '../../services.ts';
import { definePrimitive, lengthParam } from './definePrimitive.ts';

/** Maximum number of letters. */
const MAX_LETTERS = 10_000;

/** In cap heights. */
const capHeightParam = (title: LocalizedText, help: LocalizedText, value: number, min: number, max: number) =>
  ({ kind: 'number', title, help, default: value, min, max, step: 0.01 }) as const;

/** Extruded text that stands on the ground and faces +z. */
export const solidTextNode = definePrimitive({
  id: 'solid-text',
  title: msg`Solid text`,
  help: msg`Extruded letters that stand on the ground and face +z, in any number of lines: Latin, Greek, Cyrillic, Chinese. Letters have their own widths; there is no kerning.`,
  name: 'Text',
  params: {
    text: { kind: 'text', title: msg`Text`, default: 'c', lines: true },
    size: lengthParam(msg`Cap height`, 1),
    depth: lengthParam(msg`Depth (z)`, 0.2),
    align: {
      kind: 'choice',
      title: msg`Alignment`,
      default: 'center',
      options: [
        { value: 'left', title: msg`Start at x = 0` },
        { value: 'center', title: msg`Centre at x = 0` },
        { value: 'right', title: msg`End at x = 0` },
      ],
    },
    spacing: capHeightParam(msg`Letter spacing`, msg`Additional space, in cap heights.`, 0, -1, 10),
    lineHeight: capHeightParam(msg`Line height`, msg`In cap heights.`, 1.65, 0.1, 10),
    tolerance: {
      ...capHeightParam(
        msg`Curve tolerance`,
        msg`Maximum deviation of line segments from the curve, in cap heights: smaller is rounder, with more triangles.`,
        0.002,
        1e-5,
        0.2,
      ),
      step: 0.00001,
      scale: 'log',
    },
  },
  async mesh({ text, align, ...measures }, { node, services }) {
    // Loaded on demand, since few scenes have text.
    const { MAX_TEXT_TRIANGLES, textMesh, textTriangles } = await import('../../../scene/text/textMesh.ts');
    const lines = await glyphLines(text, node, services);
    const style: TextStyle = { ...measures, align: align as TextStyle['align'] };
    const triangles = textTriangles(lines, style);
    if (triangles === 0)
      throw nodeRefusal('letters.none', `${node}.text`, msg`it shows nothing; write a letter`, remedy(node, 'c'));
    if (triangles > MAX_TEXT_TRIANGLES) {
      const message = msg`it would be of ${triangles} triangles, more than ${MAX_TEXT_TRIANGLES}; write less, or let curves be coarser (tolerance)`;
      throw nodeRefusal('letters.large', node, message);
    }
    return textMesh(lines, style);
  },
});

async function glyphLines(text: string, node: string, { readFont }: Services): Promise<Glyph[][]> {
  const lines = text
    .normalize('NFC')
    .split(/\r?\n/)
    .map((line) => Array.from(line));
  const written = lines.flat();
  if (written.length > MAX_LETTERS) {
    const message = msg`it has ${written.length} letters, more than ${MAX_LETTERS}; write less`;
    throw nodeRefusal('letters.many', `${node}.text`, message, remedy(node, written.slice(0, MAX_LETTERS).join('')));
  }
  const { readGlyphs } = await import('../../../formats/font/glyphs.ts');
  const letters = await readGlyphs(new Set(written), readFont).catch((error: unknown) => {
    if (!(error instanceof InputError)) throw error;
    const { code, place, message } = error.diagnostic;
    throw nodeRefusal(code, place, message);
  });
  const missing = [...new Set(written)].filter((letter) => !letters.has(letter));
  if (missing.length > 0) {
    const few = listed([...missing.slice(0, 8).map(describeLetter), ...(missing.length > 8 ? ['…'] : [])]);
    const message = msg`no font that comes with the program has ${few}; leave it out`;
    const without = lines.map((line) => line.filter((letter) => letters.has(letter)).join('')).join('\n');
    throw nodeRefusal('letters.missing', `${node}.text`, message, remedy(node, without || 'c'));
  }
  return lines.map((line) => line.map((letter) => letters.get(letter)!));
}

const remedy = (node: string, value: string) => ({ node, param: 'text', value });

/** `"ß" (U+00DF)` */
const describeLetter = (letter: string): string =>
  `"${letter}" (U+${letter.codePointAt(0)!.toString(16).toUpperCase().padStart(4, '0')})`;
