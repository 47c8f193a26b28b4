import { emptyBox, growBox } from './bvh.ts';

const MARGIN = 1e-9;

/** A binary tree of boxes over time: a node's box contains an object during all pieces of its time interval, its children's during half of them. */
export class TimeBvh {
  /** Number of pieces, each between two samples. */
  readonly pieces: number;
  readonly piecesPerLeaf: number;
  /** 6 per node; node 1 is the root of all pieces; that of first … last has the children 2n of first … `middlePiece` and 2n + 1 of the others. */
  readonly boxes: Float64Array;

  /** The object's box in each piece, 6 numbers each. Leaves are nodes of up to `piecesPerLeaf` pieces. */
  constructor(pieceBoxes: Float64Array, piecesPerLeaf: number) {
    this.pieces = pieceBoxes.length / 6;
    this.piecesPerLeaf = piecesPerLeaf;
    const levels = Math.max(0, Math.ceil(Math.log2(this.pieces / piecesPerLeaf)));
    this.boxes = new Float64Array(6 * 2 ** (levels + 1));
    this.fill(1, 0, this.pieces - 1, enlarged(pieceBoxes));
  }

  /** The root's box: min x y z, max x y z. */
  get whole(): Float64Array {
    return this.boxes.subarray(6, 12);
  }

  private fill(node: number, first: number, last: number, pieceBoxes: Float64Array): void {
    const { boxes } = this;
    emptyBox(boxes, 6 * node);
    if (last - first < this.piecesPerLeaf) {
      for (let k = first; k <= last; k++) growBox(boxes, 6 * node, pieceBoxes, 6 * k);
      return;
    }
    const middle = middlePiece(first, last);
    this.fill(2 * node, first, middle, pieceBoxes);
    this.fill(2 * node + 1, middle + 1, last, pieceBoxes);
    growBox(boxes, 6 * node, boxes, 12 * node);
    growBox(boxes, 6 * node, boxes, 12 * node + 6);
  }
}

/** The last piece of the first half of first … last. */
export const middlePiece = (first: number, last: number): number => (first + last) >> 1;

/** The boxes of pieces between two samples each, from those at the samples: in between points move straight. */
export function boxesBetween(outlines: Float64Array): Float64Array {
  const boxes = outlines.slice(6);
  for (let k = 0; k < boxes.length; k += 6) growBox(boxes, k, outlines, k);
  return boxes;
}

/** Enlarges the boxes by more than the rounding errors of the greatest coordinate. */
function enlarged(boxes: Float64Array): Float64Array {
  const reach = boxes.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  return boxes.map((x, i) => x + (i % 6 < 3 ? -MARGIN : MARGIN) * reach);
}
