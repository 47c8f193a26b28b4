import { createContext } from 'react';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import type { CanvasRect } from './cardGeometry.ts';

/**
 * Zoomed out, a node shows its title as large as space allows. Lengths are in canvas pixels unless marked as pixels of
 * the window.
 */

/** Below this zoom nodes show only their titles. */
const ZOOMED_OUT = 0.6;
/** Title layouts per octave of zoom, instead of one per frame. */
const STEPS_PER_OCTAVE = 3;

/**
 * Canvas pixels per window pixel, quantized so that it changes rarely; undefined at zooms where nodes are drawn in
 * full.
 */
export const canvasPixelSize = (zoom: number): number | undefined =>
  zoom < ZOOMED_OUT ? 2 ** (Math.ceil(STEPS_PER_OCTAVE * Math.log2(1 / zoom)) / STEPS_PER_OCTAVE) : undefined;

export const CanvasPixelContext = createContext<number | undefined>(undefined);

/** Above this, nodes have no pictures and titles take their space. */
export const MAX_PICTURE_PIXEL = 4.1;

/** Maximum extent of a title beyond its node, horizontally and vertically. */
const MAX_OVERHANG: CanvasPoint = [100, 60];

/**
 * How far titles may extend beyond their nodes: half way to the next, so that no two overlap. Nodes apart in both
 * directions are separated by the wider gap, and only that is shared.
 */
export function titleOverhangs(boxes: ReadonlyMap<string, CanvasRect>): ReadonlyMap<string, CanvasPoint> {
  const sorted = [...boxes].map(([id, box]) => ({ id, box, reach: [...MAX_OVERHANG] as [number, number] }));
  sorted.sort((a, b) => a.box.at[0] - b.box.at[0]);
  for (const [i, a] of sorted.entries()) {
    const end = a.box.at[0] + a.box.size[0] + 2 * MAX_OVERHANG[0];
    for (let j = i + 1; j < sorted.length && sorted[j]!.box.at[0] < end; j++) {
      const b = sorted[j]!;
      const [x, y] = [gap(a.box, b.box, 0), gap(a.box, b.box, 1)];
      const axis = x > y ? 0 : 1;
      const half = Math.max(0, (axis === 0 ? x : y) / 2);
      for (const { reach } of [a, b]) reach[axis] = Math.min(reach[axis], half);
    }
  }
  return new Map(sorted.map(({ id, reach }) => [id, reach]));
}

/** Gap between two boxes along an axis; negative where they overlap. */
const gap = (a: CanvasRect, b: CanvasRect, axis: 0 | 1): number =>
  Math.max(a.at[axis] - b.at[axis] - b.size[axis], b.at[axis] - a.at[axis] - a.size[axis]);

/** Font sizes [px of the window]: the maximum, the preferred minimum on a node, and the smallest legible. */
const MAX_FONT_SIZE = 13;
const GOOD_FONT_SIZE = 9;
const MIN_FONT_SIZE = 7.5;
export const LINE_HEIGHT = 1.1;
/** Padding between a title and its node's edge. */
const TITLE_PADDING = 5;
/** Narrowest part of a truncated word that is worth showing [em]. */
const MIN_TRUNCATED_WIDTH = 1.6;

export interface ZoomedOutTitle {
  /** The title, with soft hyphens in words that are too long for a line. */
  readonly text: string;
  /** Font size. */
  readonly size: number;
  readonly lines: number;
  /** Extent beyond the node, horizontally and vertically. */
  readonly reach: CanvasPoint;
}

/**
 * Layout of a node's title on the node, or extending beyond it where it would be too small; if that is not enough words
 * are hyphenated, then truncated. Undefined if nothing would be legible.
 */
export function layoutTitle(
  title: string,
  room: CanvasPoint,
  reach: CanvasPoint,
  pixel: number,
): ZoomedOutTitle | undefined {
  const words = wordWidths(title);
  const inside: CanvasPoint = [room[0] - 2 * TITLE_PADDING, room[1] - 2 * TITLE_PADDING];
  const beyond: CanvasPoint = [room[0] + 2 * reach[0] - 2 * TITLE_PADDING, room[1] + 2 * reach[1]];
  const layouts = [
    { most: MAX_FONT_SIZE, least: GOOD_FONT_SIZE, room: inside, reach: [0, 0] },
    { most: GOOD_FONT_SIZE, least: MIN_FONT_SIZE, room: beyond, reach },
  ] as const;
  for (const layout of layouts) {
    for (let size = layout.most * pixel; size >= layout.least * pixel; size -= 0.5 * pixel) {
      const lines = countLines(words, layout.room[0] / size);
      if (lines !== undefined && lines * LINE_HEIGHT * size <= layout.room[1])
        return { text: title, size, lines, reach: layout.reach };
    }
  }
  const size = MIN_FONT_SIZE * pixel;
  const width = beyond[0] / size;
  if (width < MIN_TRUNCATED_WIDTH) return undefined;
  const lines = Math.max(1, Math.floor(beyond[1] / (LINE_HEIGHT * size)));
  return { text: lines > 1 ? hyphenate(title, width) : title, size, lines, reach };
}

/** Inserts soft hyphens into words longer than a line, in pieces of equal length. */
const hyphenate = (title: string, width: number): string =>
  title.replace(/[^\s\p{Script=Han}]+/gu, (word) => {
    const pieces = Math.ceil(wordWidth(word) / (width - HYPHEN_WIDTH));
    if (wordWidth(word) <= width || pieces < 2) return word;
    const letters = [...word];
    const length = Math.ceil(letters.length / pieces);
    return Array.from({ length: pieces }, (_, i) => letters.slice(i * length, (i + 1) * length).join(''))
      .filter(Boolean)
      .join('\u00ad');
  });

/** Number of lines at a width; undefined if a word is wider [em]. */
function countLines(words: readonly number[], width: number): number | undefined {
  let lines = 1;
  let taken = 0;
  for (const word of words) {
    if (word > width) return undefined;
    const after = taken + (taken > 0 ? SPACE_WIDTH : 0) + word;
    if (after <= width) taken = after;
    else {
      lines++;
      taken = word;
    }
  }
  return lines;
}

/** Widths in the page's typeface, semi-bold [em]. */
const SPACE_WIDTH = 0.28;
const HYPHEN_WIDTH = 0.46;
const LETTER_WIDTHS: readonly (readonly [letters: RegExp, width: number])[] = [
  [/[ijlI.,:;'’|!]/u, 0.3],
  [/[frt()[\]/1-]/u, 0.41],
  [/[mwMW%@—…]/u, 0.92],
  [/\p{Lu}/u, 0.7],
  [/\p{Script=Han}|[，。：；（）]/u, 1],
];
const letterWidth = (letter: string): number => LETTER_WIDTHS.find(([letters]) => letters.test(letter))?.[1] ?? 0.61;
const wordWidth = (word: string): number => [...word].reduce((width, letter) => width + letterWidth(letter), 0);

/** Widths of the units between which a title can wrap: words, or single Chinese characters. */
const wordWidths = (title: string): readonly number[] =>
  (title.match(/\p{Script=Han}|[^\s\p{Script=Han}]+/gu) ?? []).map(wordWidth);
