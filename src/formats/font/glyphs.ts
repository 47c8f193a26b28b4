import type { Glyph } from '../../scene/text/contours.ts';
import { type FontFace, readFontFace } from './fontFace.ts';

/** Reads a file of a font’s package: `inter/unicode.json`. */
export type ReadFont = (path: string) => Promise<Uint8Array>;

/** Fontsource packages in order of fallback; each is split into subsets by script. */
export const FONTS = [
  /** Latin, Greek, Cyrillic. */
  { name: 'inter', weight: 700 },
  /** Chinese (GB 2312). */
  { name: 'zcool-qingke-huangyou', weight: 400 },
] as const;

/** File name of a subset: `latin`, `[5]` → `files/inter-latin-700-normal.woff`. */
export const fontFile = (
  { name, weight }: { readonly name: string; readonly weight: number },
  subset: string,
): string => `files/${name}-${subset.replace(/[[\]]/g, '')}-${weight}-normal.woff`;

interface FontCache {
  readonly faces: Map<string, Promise<FontFace>>;
  readonly tables: Map<string, Promise<readonly FontSubset[]>>;
}
const ofReaders = new WeakMap<ReadFont, FontCache>();

/** Glyphs by letter, without those of no font. Loads only the subsets needed, each once. */
export async function readGlyphs(letters: Iterable<string>, read: ReadFont): Promise<Map<string, Glyph>> {
  const known = ofReaders.get(read) ?? { faces: new Map(), tables: new Map() };
  ofReaders.set(read, known);
  const found = await Promise.all(
    Array.from(letters, async (name) => [name, await findGlyph(name, read, known)] as const),
  );
  return new Map(found.flatMap(([name, letter]) => (letter ? [[name, letter] as const] : [])));
}

async function findGlyph(letter: string, read: ReadFont, { faces, tables }: FontCache): Promise<Glyph | undefined> {
  for (const { name, weight } of FONTS) {
    const table = await once(tables, name, async () => subsetsIn(await read(`${name}/unicode.json`)));
    const subset = table.find((each) => each.has(letter.codePointAt(0)!));
    if (!subset) continue;
    const path = `${name}/${fontFile({ name, weight }, subset.name)}`;
    const face = await once(faces, path, async () => readFontFace(await read(path)));
    const found = face.glyph(letter);
    if (found) return found;
  }
  return undefined;
}

/** Failed reads are not cached. */
function once<T>(kept: Map<string, Promise<T>>, key: string, make: () => Promise<T>): Promise<T> {
  const known = kept.get(key);
  if (known) return known;
  const made = make();
  kept.set(key, made);
  made.catch(() => kept.delete(key));
  return made;
}

interface FontSubset {
  readonly name: string;
  has(codePoint: number): boolean;
}

/** `{"latin": "U+0000-00FF,U+0131", "[5]": …}` → the subsets and their code point ranges. */
function subsetsIn(bytes: Uint8Array): FontSubset[] {
  const table: Record<string, string> = JSON.parse(new TextDecoder().decode(bytes));
  return Object.entries(table).map(([key, ranges]) => {
    const spans = ranges.split(',').map((range) => {
      const [first, last = first] = range.slice('U+'.length).split('-');
      return [Number.parseInt(first, 16), Number.parseInt(last, 16)] as const;
    });
    const has = (codePoint: number): boolean => spans.some(([first, last]) => first <= codePoint && codePoint <= last);
    return { name: key, has };
  });
}
