/** A bounding volume hierarchy: a binary tree of boxes, its nodes in depth-first order: the left child of node i is node i + 1. */
export interface Bvh {
  /** 6 per node: min x y z, max x y z [m]. */
  readonly bounds: Float64Array;
  /** Inner node: index of its right child. Leaf: index of its first item in `order`. */
  readonly link: Int32Array;
  /** Number of items of a leaf; 0 for inner nodes. */
  readonly count: Uint8Array;
  /** Item indices, grouped by leaf. */
  readonly order: Uint32Array;
}

/** Entering a node and testing an item cost 1 each, so small leaves pay off. */
const MAX_LEAF_ITEMS = 4;
const BINS = 16;

/**
 * Builds a BVH over items with the given boxes (6 numbers each, as in `Bvh.bounds`) by the surface area heuristic: candidate planes divide the
 * longest side of the centres' bounding box into `BINS` equal slices; the cost of a split is area times item count, summed over both sides.
 * Source: Wald 2007, "On fast construction of SAH-based bounding volume hierarchies".
 */
export function buildBvh(boxes: Float64Array): Bvh {
  const items = boxes.length / 6;
  return new Builder(boxes, items).finish();
}

class Builder {
  private readonly boxes: Float64Array;
  private readonly order: Uint32Array;
  private readonly bounds: Float64Array;
  private readonly link: Int32Array;
  private readonly count: Uint8Array;
  private nodes = 0;
  private readonly binBox = new Float64Array(6 * BINS);
  private readonly binCount = new Uint32Array(BINS);
  private readonly right = new Float64Array(BINS);

  constructor(boxes: Float64Array, items: number) {
    this.boxes = boxes;
    this.order = Uint32Array.from({ length: items }, (_, i) => i);
    const maxNodes = Math.max(1, 2 * items - 1);
    this.bounds = new Float64Array(6 * maxNodes);
    this.link = new Int32Array(maxNodes);
    this.count = new Uint8Array(maxNodes);
    if (items > 0) this.divide(0, items);
  }

  finish(): Bvh {
    const { nodes, order } = this;
    return {
      bounds: this.bounds.slice(0, 6 * nodes),
      link: this.link.slice(0, nodes),
      count: this.count.slice(0, nodes),
      order,
    };
  }

  private divide(from: number, to: number): void {
    const node = this.nodes++;
    this.enclose(node, from, to);
    const middle = to - from > 1 ? this.split(from, to) : from;
    if (middle === from) {
      this.link[node] = from;
      this.count[node] = to - from;
      return;
    }
    this.divide(from, middle);
    this.link[node] = this.nodes;
    this.divide(middle, to);
  }

  private enclose(node: number, from: number, to: number): void {
    emptyBox(this.bounds, 6 * node);
    for (let i = from; i < to; i++) growBox(this.bounds, 6 * node, this.boxes, 6 * this.order[i]);
  }

  /** Partitions the items and returns the index of the second side's first item; `from` if a leaf is cheaper. */
  private split(from: number, to: number): number {
    const items = to - from;
    const { axis, least, size } = this.spread(from, to);
    // No plane separates items with the same centre: halve the list instead.
    if (!(size > 0)) return items <= MAX_LEAF_ITEMS ? from : (from + to) >>> 1;
    const binOf = (item: number) => Math.min(BINS - 1, Math.floor((BINS * (this.center(item, axis) - least)) / size));
    const { plane, cost } = this.bestPlane(from, to, binOf);
    const leafCost = area(this.bounds, 6 * (this.nodes - 1)) * items;
    if (items <= MAX_LEAF_ITEMS && cost + area(this.bounds, 6 * (this.nodes - 1)) >= leafCost) return from;
    return this.partition(from, to, (item) => binOf(item) < plane);
  }

  /** The axis along which the items' centres spread farthest, with their minimum and extent. */
  private spread(from: number, to: number): { axis: number; least: number; size: number } {
    const best = { axis: 0, least: 0, size: 0 };
    for (let axis = 0; axis < 3; axis++) {
      let [least, greatest] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
      for (let i = from; i < to; i++) {
        const x = this.center(this.order[i], axis);
        if (x < least) least = x;
        if (x > greatest) greatest = x;
      }
      if (greatest - least > best.size) Object.assign(best, { axis, least, size: greatest - least });
    }
    return best;
  }

  private center(item: number, axis: number): number {
    return (this.boxes[6 * item + axis] + this.boxes[6 * item + 3 + axis]) / 2;
  }

  /** The bin before which to split, and its cost. The first and last bins are never empty, so neither side is. */
  private bestPlane(from: number, to: number, binOf: (item: number) => number): { plane: number; cost: number } {
    const { binBox, binCount, right } = this;
    binCount.fill(0);
    for (let b = 0; b < BINS; b++) emptyBox(binBox, 6 * b);
    for (let i = from; i < to; i++) {
      const b = binOf(this.order[i]);
      binCount[b]++;
      growBox(binBox, 6 * b, this.boxes, 6 * this.order[i]);
    }
    const side = new Float64Array(6);
    this.sweep(side, BINS - 1, -1, (b, cost) => {
      right[b] = cost;
    });
    let best = { plane: 1, cost: Number.POSITIVE_INFINITY };
    this.sweep(side, 0, 1, (b, cost) => {
      if (b + 1 < BINS && cost + right[b + 1] < best.cost) best = { plane: b + 1, cost: cost + right[b + 1] };
    });
    return best;
  }

  /** Visits the bins from one end, each with area times item count of all bins up to it. */
  private sweep(side: Float64Array, from: number, step: number, visit: (bin: number, cost: number) => void): void {
    emptyBox(side, 0);
    let items = 0;
    for (let b = from; b >= 0 && b < BINS; b += step) {
      items += this.binCount[b];
      growBox(side, 0, this.binBox, 6 * b);
      visit(b, items > 0 ? items * area(side, 0) : 0);
    }
  }

  private partition(from: number, to: number, isLeft: (item: number) => boolean): number {
    const { order } = this;
    let [lo, hi] = [from, to];
    while (lo < hi) {
      if (isLeft(order[lo])) lo++;
      else {
        hi--;
        [order[lo], order[hi]] = [order[hi], order[lo]];
      }
    }
    return lo;
  }
}

/** Sets the box at k to the empty box, min +∞ and max −∞. */
export function emptyBox(boxes: Float64Array, k: number): void {
  boxes.fill(Number.POSITIVE_INFINITY, k, k + 3);
  boxes.fill(Number.NEGATIVE_INFINITY, k + 3, k + 6);
}

/** Enlarges the box at k to contain the one at j of another list. */
export function growBox(boxes: Float64Array, k: number, others: ArrayLike<number>, j: number): void {
  for (let i = 0; i < 3; i++) {
    if (others[j + i] < boxes[k + i]) boxes[k + i] = others[j + i];
    if (others[j + 3 + i] > boxes[k + 3 + i]) boxes[k + 3 + i] = others[j + 3 + i];
  }
}

function area(boxes: Float64Array, k: number): number {
  const [x, y, z] = [boxes[k + 3] - boxes[k], boxes[k + 4] - boxes[k + 1], boxes[k + 5] - boxes[k + 2]];
  return x * y + y * z + z * x;
}
