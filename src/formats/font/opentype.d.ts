/** The part of opentype.js in use; the package has no types. */
declare module 'opentype.js/dist/opentype.mjs' {
  type PathCommand =
    | { readonly type: 'M' | 'L'; readonly x: number; readonly y: number }
    | { readonly type: 'Q'; readonly x1: number; readonly y1: number; readonly x: number; readonly y: number }
    | { readonly type: 'C' | 'Z' };
  interface OpenTypeGlyph {
    /** 0: missing glyph. */
    readonly index: number;
    readonly advanceWidth?: number;
    /** In font units, y up. */
    readonly path: { readonly commands: readonly PathCommand[] };
  }
  interface OpenTypeFont {
    /** Of the table OS/2, in font units. */
    readonly tables: { readonly os2: { readonly sCapHeight: number } };
    charToGlyph(letter: string): OpenTypeGlyph;
  }

  export type { OpenTypeFont };
  export function parse(font: ArrayBuffer): OpenTypeFont;
}
