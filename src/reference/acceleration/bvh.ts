/** A bounding volume hierarchy: a binary tree of boxes, its nodes in depth-first order: the left child of node i is node i + 1. */
export interface Bvh {
  /** 6 per node: min x y z, max x y z [m]. In 32 bits, rounded outward, so that twice as many fit into a processor's caches. */
  readonly bounds: Float32Array;
  /** Inner node: index of its right child. Leaf: index of its first item in `order`. */
  readonly link: Int32Array;
  /** Number of items of a leaf; 0 for inner nodes. */
  readonly count: Uint8Array;
  /** Inner node: the axis along which its children lie one behind the other, the left one first; plus 3 if the right one is. */
  readonly axis: Uint8Array;
  /** Item indices, grouped by leaf. */
  readonly order: Uint32Array;
}

/** Entering a node and testing an item cost 1 each, so small leaves pay off. */
const MAX_LEAF_ITEMS = 4;
const BINS = 16;

/**
 * Builds a BVH over items with the given boxes (min x y z, max x y z) by the surface area heuristic: candidate planes divide each side of
 * the centres' bounding box into `BINS` equal slices; the cost of a split is area times item count, summed over both sides.
 * Source: Wald 2007, "On fast construction of SAH-based bounding volume hierarchies".
 */
export function buildBvh(boxes: Float64Array): Bvh {
  const items = boxes.length / 6;
  return new Builder(boxes, items).finish();
}

/** A plane between two sides: before bin `plane` along an axis. */
interface Split {
  readonly axis: number;
  readonly plane: number;
  readonly cost: number;
}

class Builder {
  private readonly boxes: Float64Array;
  /** 3 per item. */
  private readonly centers: Float64Array;
  private readonly order: Uint32Array;
  private readonly bounds: Float64Array;
  private readonly link: Int32Array;
  private readonly count: Uint8Array;
  private readonly axis: Uint8Array;
  private nodes = 0;
  /** The centres' bounding box of the items to be divided. */
  private readonly spread = new Float64Array(6);
  private readonly binBox = new Float64Array(6 * BINS);
  private readonly binCount = new Uint32Array(BINS);
  private readonly side = new Float64Array(6);
  private readonly right = new Float64Array(BINS);

  constructor(boxes: Float64Array, items: number) {
    this.boxes = boxes;
    this.centers = new Float64Array(3 * items);
    for (let i = 0; i < items; i++)
      for (let axis = 0; axis < 3; axis++)
        this.centers[3 * i + axis] = (boxes[6 * i + axis] + boxes[6 * i + 3 + axis]) / 2;
    this.order = Uint32Array.from({ length: items }, (_, i) => i);
    const maxNodes = Math.max(1, 2 * items - 1);
    this.bounds = new Float64Array(6 * maxNodes);
    this.link = new Int32Array(maxNodes);
    this.count = new Uint8Array(maxNodes);
    this.axis = new Uint8Array(maxNodes);
    if (items > 0) this.divide(0, items);
  }

  finish(): Bvh {
    const { nodes, order } = this;
    return {
      bounds: roundedOutward(this.bounds.subarray(0, 6 * nodes)),
      link: this.link.slice(0, nodes),
      count: this.count.slice(0, nodes),
      axis: this.axis.slice(0, nodes),
      order,
    };
  }

  private divide(from: number, to: number): void {
    const node = this.nodes++;
    this.enclose(node, from, to);
    const middle = to - from > 1 ? this.split(node, from, to) : from;
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
  private split(node: number, from: number, to: number): number {
    const items = to - from;
    const best = this.bestSplit(from, to);
    // No plane separates items with the same centre: halve the list instead.
    if (!best) return items <= MAX_LEAF_ITEMS ? from : (from + to) >>> 1;
    const whole = area(this.bounds, 6 * node);
    if (items <= MAX_LEAF_ITEMS && best.cost + whole >= whole * items) return from;
    this.axis[node] = best.axis;
    return this.partition(from, to, best);
  }

  private bestSplit(from: number, to: number): Split | undefined {
    const { spread, centers, order } = this;
    emptyBox(spread, 0);
    for (let i = from; i < to; i++)
      for (let axis = 0; axis < 3; axis++) {
        const x = centers[3 * order[i] + axis];
        if (x < spread[axis]) spread[axis] = x;
        if (x > spread[3 + axis]) spread[3 + axis] = x;
      }
    let best: Split | undefined;
    for (let axis = 0; axis < 3; axis++) {
      if (!(spread[3 + axis] > spread[axis])) continue;
      const split = this.bestPlane(from, to, axis);
      if (!best || split.cost < best.cost) best = split;
    }
    return best;
  }

  private binOf(item: number, axis: number): number {
    const least = this.spread[axis];
    const size = this.spread[3 + axis] - least;
    return Math.min(BINS - 1, Math.floor((BINS * (this.centers[3 * item + axis] - least)) / size));
  }

  /** The first and last bins are never empty, so neither side is. */
  private bestPlane(from: number, to: number, axis: number): Split {
    const { binBox, binCount, side, right } = this;
    binCount.fill(0);
    for (let b = 0; b < BINS; b++) emptyBox(binBox, 6 * b);
    for (let i = from; i < to; i++) {
      const item = this.order[i];
      const b = this.binOf(item, axis);
      binCount[b]++;
      growBox(binBox, 6 * b, this.boxes, 6 * item);
    }
    emptyBox(side, 0);
    let items = 0;
    for (let b = BINS - 1; b > 0; b--) {
      items += binCount[b];
      growBox(side, 0, binBox, 6 * b);
      right[b] = items * area(side, 0);
    }
    emptyBox(side, 0);
    items = 0;
    let [plane, cost] = [1, Number.POSITIVE_INFINITY];
    for (let b = 1; b < BINS; b++) {
      items += binCount[b - 1];
      growBox(side, 0, binBox, 6 * (b - 1));
      const sum = items * area(side, 0) + right[b];
      if (sum < cost) [plane, cost] = [b, sum];
    }
    return { axis, plane, cost };
  }

  private partition(from: number, to: number, { axis, plane }: Split): number {
    const { order } = this;
    let [lo, hi] = [from, to];
    while (lo < hi) {
      if (this.binOf(order[lo], axis) < plane) lo++;
      else {
        hi--;
        [order[lo], order[hi]] = [order[hi], order[lo]];
      }
    }
    return lo;
  }
}

/** The smallest boxes in 32 bits that contain these. */
export function roundedOutward(boxes: Float64Array): Float32Array {
  const rounded = new Float32Array(boxes.length);
  for (let k = 0; k < boxes.length; k++) {
    const x = boxes[k];
    const outward = k % 6 < 3 ? -1 : 1;
    const nearest = Math.fround(x);
    const isInside = outward * (nearest - x) < 0;
    rounded[k] = isInside ? nearest + outward * (Math.abs(nearest) * 2 ** -23 + 2 ** -149) : nearest;
  }
  return rounded;
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

/** Mean of the longest sides of the leaves' boxes [m]; NaN without any. */
export function meanLeafSize({ bounds, count }: Bvh): number {
  let [sum, leaves] = [0, 0];
  for (let node = 0; node < count.length; node++) {
    if (count[node] === 0) continue;
    const k = 6 * node;
    sum += Math.max(bounds[k + 3] - bounds[k], bounds[k + 4] - bounds[k + 1], bounds[k + 5] - bounds[k + 2]);
    leaves++;
  }
  return sum / leaves;
}
