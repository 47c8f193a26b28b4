/** Characters that take two columns: CJK, their punctuation and full-width forms. https://www.unicode.org/reports/tr11/ */
const WIDE =
  /[\u1100-\u115f\u2e80-\u303e\u3041-\ua4cf\uac00-\ud7a3\uf900-\ufaff\ufe30-\ufe6f\uff01-\uff60\uffe0-\uffe6]/gu;

/** Columns that a text takes in a terminal. */
export const displayWidth = (text: string): number => text.length + (text.match(WIDE)?.length ?? 0);

/** Pads a text to a number of columns. */
export const padColumns = (text: string, columns: number): string =>
  text + ' '.repeat(Math.max(0, columns - displayWidth(text)));
