import type { LocalizedText } from '../../messages/message.ts';
import { localized } from './language.ts';
import { displayWidth, padColumns } from './width.ts';

/** The cells of a line of a table. */
export type Row = readonly LocalizedText[];

/** Pads the cells of rows into columns. */
export function columns(rows: readonly Row[], indent: number): string[] {
  const cells = rows.map((row) => row.map(localized));
  const width = (k: number) => Math.max(...cells.map((row) => displayWidth(row[k] ?? '')));
  return cells.map((row) =>
    (' '.repeat(indent) + row.map((cell, k) => padColumns(cell, width(k))).join('  ')).trimEnd(),
  );
}
