import type { LocalizedText } from '../messages/message.ts';
import type { Mark, MarkRole, PixelPoint } from './marks.ts';

/** A row of a legend: a sample of a mark, and what it stands for. */
export interface LegendRow {
  readonly text: LocalizedText;
  readonly role: MarkRole;
  readonly sample: 'line' | 'solid' | 'dashes' | 'filled' | 'hollow' | 'tick' | 'none';
}

const [ROW, SAMPLE] = [18, 22]; // [px]
/** Characters of a name that have room; of longer ones the end is kept, which tells prims apart. */
const MAX_NAME = 24;

/** Rows below each other from a corner on, if there is one; those without room are left out. */
export function legendMarks(rows: readonly LegendRow[], at: PixelPoint | undefined, height: number): readonly Mark[] {
  if (!at) return [];
  const [x, y] = at;
  const room = Math.max(0, Math.floor((height - y) / ROW));
  return rows.slice(0, room).flatMap((row, i) => rowMarks(row, x, y + i * ROW + ROW / 2));
}

function rowMarks({ text, role, sample }: LegendRow, x: number, y: number): Mark[] {
  const label: Mark = {
    kind: 'text',
    role: 'axis',
    at: [x + SAMPLE + 8, y + 4],
    text: shortened(text),
    anchor: 'start',
  };
  return [...sampleMarks(role, sample, x, y), label];
}

function sampleMarks(role: MarkRole, sample: LegendRow['sample'], x: number, y: number): Mark[] {
  const across: PixelPoint[] = [
    [x, y],
    [x + SAMPLE, y],
  ];
  const middle = x + SAMPLE / 2;
  switch (sample) {
    case 'none':
      return [];
    case 'filled':
    case 'hollow':
      return [{ kind: 'dot', role, at: [middle, y], filled: sample === 'filled' }];
    case 'tick': {
      const upright: PixelPoint[] = [
        [middle, y - 4],
        [middle, y + 4],
      ];
      return [
        { kind: 'lines', role, lines: [across], width: 1.5 },
        { kind: 'lines', role, lines: [upright], width: 1.25 },
      ];
    }
    default:
      return [
        { kind: 'lines', role, lines: [across], width: 2, ...(sample !== 'line' && { dashed: sample === 'dashes' }) },
      ];
  }
}

const shortened = (text: LocalizedText): LocalizedText =>
  typeof text === 'string' && text.length > MAX_NAME ? `…${text.slice(1 - MAX_NAME)}` : text;
