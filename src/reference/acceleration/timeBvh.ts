import { emptyBox, growBox } from './bvh.ts';

const MARGIN = 1e-9;

/** Boxes over stretches of time: each is round an object in all pieces of its stretch, and has two halves. */
export class TimeBvh {
  /** Pieces between two samples. */
  readonly pieces: number;
  /** 6 per node; node 1 is the whole, the halves of node n are 2n and 2n + 1. */
  private readonly boxes: Float64Array;

  /** `outlines`: the object's boxes at the samples, 6 numbers each, between which its points run straight. */
  constructor(outlines: Float64Array) {
    this.pieces = outlines.length / 6 - 1;
    this.boxes = new Float64Array(6 * 2 ** (2 + Math.ceil(Math.log2(this.pieces))));
    this.fill(1, 0, this.pieces - 1, enlarged(outlines));
  }

  /** The place of a node's box in `boxes`: least x y z, greatest x y z. */
  get whole(): Float64Array {
    return this.boxes.subarray(6, 12);
  }

  /** Whether a line (o x y z, d x y z) is in a node's box anywhere from s = near to far. */
  intersects(node: number, line: Float64Array, near: number, far: number): boolean {
    const { boxes } = this;
    let from = near;
    let to = far;
    for (let axis = 0; axis < 3; axis++) {
      const a = boxes[6 * node + axis] - line[axis];
      const b = boxes[6 * node + 3 + axis] - line[axis];
      const d = line[3 + axis];
      if (d === 0) {
        if (a > 0 || b < 0) return false;
        continue;
      }
      from = Math.max(from, Math.min(a / d, b / d));
      to = Math.min(to, Math.max(a / d, b / d));
      if (from > to) return false;
    }
    return true;
  }

  private fill(node: number, first: number, last: number, outlines: Float64Array): void {
    const { boxes } = this;
    emptyBox(boxes, 6 * node);
    if (first === last) {
      growBox(boxes, 6 * node, outlines, 6 * first);
      growBox(boxes, 6 * node, outlines, 6 * first + 6);
      return;
    }
    const middle = (first + last) >> 1;
    this.fill(2 * node, first, middle, outlines);
    this.fill(2 * node + 1, middle + 1, last, outlines);
    growBox(boxes, 6 * node, boxes, 12 * node);
    growBox(boxes, 6 * node, boxes, 12 * node + 6);
  }
}

/** By a part of the greatest coordinate that is beyond all rounding. */
function enlarged(outlines: Float64Array): Float64Array {
  const reach = outlines.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  return outlines.map((x, i) => x + (i % 6 < 3 ? -MARGIN : MARGIN) * reach);
}
