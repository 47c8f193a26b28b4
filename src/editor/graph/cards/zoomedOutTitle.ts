import { createContext } from 'react';
import type { CanvasPoint } from '../../../graph/edits/commands.ts';
import type { CanvasRect } from './cardGeometry.ts';

/**
 * Seen from afar a node is its title, as large as can be read where there is room for it. Lengths are in pixels of the canvas, but where they are said to be the
 * window's.
 */

/** Farther away than this zoom nodes show their titles alone. */
const ZOOMED_OUT = 0.6;
/** In an octave of zoom titles are set anew so many times, not with every frame. */
const STEPS_PER_OCTAVE = 3;

/** What of the canvas a pixel of the window shows, seldom more than it does; undefined where nodes are near. */
export const canvasPixelSize = (zoom: number): number | undefined =>
  zoom < ZOOMED_OUT ? 2 ** (Math.ceil(STEPS_PER_OCTAVE * Math.log2(1 / zoom)) / STEPS_PER_OCTAVE) : undefined;

export const CanvasPixelContext = createContext<number | undefined>(undefined);

/** Where a pixel is more than that, nodes have no pictures, and their titles the room. */
export const MAX_PICTURE_PIXEL = 4.1;

/** Beyond its node a title reaches no farther, to either side, above and below. */
const MAX_OVERHANG: CanvasPoint = [100, 60];

/**
 * How far titles may reach beyond their nodes: half way to the next, so that no two meet. What is beside and below another lies apart by the wider of both
 * gaps, and only that is shared.
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

/** Between two boxes along an axis; below nothing where they lie over each other. */
const gap = (a: CanvasRect, b: CanvasRect, axis: 0 | 1): number =>
  Math.max(a.at[axis] - b.at[axis] - b.size[axis], b.at[axis] - a.at[axis] - a.size[axis]);

/** Of letters [px of the window]: what is large enough; what should be, on a node; and what can just be read. */
const MAX_FONT_SIZE = 13;
const GOOD_FONT_SIZE = 9;
const MIN_FONT_SIZE = 7.5;
export const LINE_HEIGHT = 1.1;
/** From a title to the edge of its node. */
const TITLE_PADDING = 5;
/** Of a word that is cut off, so much is worth showing [em]. */
const MIN_TRUNCATED_WIDTH = 1.6;

export interface ZoomedOutTitle {
  /** The title; words that are too long for a line with soft hyphens. */
  readonly text: string;
  /** Of its letters. */
  readonly size: number;
  readonly lines: number;
  /** What it takes beyond the node on either side, above and below. */
  readonly reach: CanvasPoint;
}

/**
 * How a title is set on a node, or beyond it where that is too small; words are broken where that is not enough either, and at last cut off. Undefined where
 * nothing of it could be read.
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
  const ways = [
    { most: MAX_FONT_SIZE, least: GOOD_FONT_SIZE, room: inside, reach: [0, 0] },
    { most: GOOD_FONT_SIZE, least: MIN_FONT_SIZE, room: beyond, reach },
  ] as const;
  for (const way of ways) {
    for (let size = way.most * pixel; size >= way.least * pixel; size -= 0.5 * pixel) {
      const lines = countLines(words, way.room[0] / size);
      if (lines !== undefined && lines * LINE_HEIGHT * size <= way.room[1])
        return { text: title, size, lines, reach: way.reach };
    }
  }
  const size = MIN_FONT_SIZE * pixel;
  const width = beyond[0] / size;
  if (width < MIN_TRUNCATED_WIDTH) return undefined;
  const lines = Math.max(1, Math.floor(beyond[1] / (LINE_HEIGHT * size)));
  return { text: lines > 1 ? hyphenate(title, width) : title, size, lines, reach };
}

/** With soft hyphens in words that are longer than a line, in pieces of the same length. */
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

/** How many lines words take in a width; undefined where one is longer than that. [em] */
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

/** Of the page's typeface, semi-bold [em]. */
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

/** How wide its words are, between which a title can be broken: after every letter where those are Chinese. */
const wordWidths = (title: string): readonly number[] =>
  (title.match(/\p{Script=Han}|[^\s\p{Script=Han}]+/gu) ?? []).map(wordWidth);
