/** What a curve prim says of its curves; counts are those of its vertices. */
export interface CurveArrays {
  readonly counts: ArrayLike<number>;
  readonly kind: CurveKind;
}

export type CurveKind =
  | {
      readonly basis: 'linear' | 'bezier' | 'bspline' | 'catmullRom';
      readonly wrap: 'nonperiodic' | 'periodic' | 'pinned';
    }
  | {
      readonly basis: 'nurbs';
      readonly knots: ArrayLike<number>;
      readonly orders: ArrayLike<number>;
      readonly ranges: ArrayLike<number>;
      readonly weights: ArrayLike<number> | undefined;
    };

/** A sample of a curve: weighted vertices, and the place among its varying values. */
export interface CurveSample {
  readonly vertices: readonly number[];
  readonly weights: readonly number[];
  /** Between this varying value and the next: 0 … 1. */
  readonly varying: readonly [first: number, next: number, part: number];
}

/** A curve as samples; a closed one does not repeat its first. */
export interface SampledCurve {
  /** Index among the curves of its prim. */
  readonly index: number;
  readonly closed: boolean;
  readonly samples: readonly CurveSample[];
}

type Weights = (t: number) => number[];

/** Weights of the four vertices of a cubic segment, by the basis of UsdGeomBasisCurves. */
const CUBICS: Readonly<Record<'bezier' | 'bspline' | 'catmullRom', Weights>> = {
  bezier: (t) => [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3],
  bspline: (t) => [
    (1 - t) ** 3 / 6,
    (3 * t ** 3 - 6 * t * t + 4) / 6,
    (-3 * t ** 3 + 3 * t * t + 3 * t + 1) / 6,
    t ** 3 / 6,
  ],
  catmullRom: (t) => [
    (-(t ** 3) + 2 * t * t - t) / 2,
    (3 * t ** 3 - 5 * t * t + 2) / 2,
    (-3 * t ** 3 + 4 * t * t + t) / 2,
    (t ** 3 - t * t) / 2,
  ],
};

/** Number of segments of a curve of `count` vertices; 0 if it has too few. */
export function segmentCount({ kind }: CurveArrays, count: number, curve: number): number {
  if (kind.basis === 'nurbs') return Math.max(0, count - (kind.orders[curve] ?? 0) + 1);
  const isClosed = kind.wrap === 'periodic';
  if (kind.basis === 'linear') return count < 2 ? 0 : isClosed && count > 2 ? count : count - 1;
  if (kind.basis === 'bezier') {
    if (isClosed) return count >= 3 ? Math.floor(count / 3) : 0;
    return count < 4 ? 0 : Math.floor((count - 4) / 3) + 1;
  }
  if (isClosed) return count < 3 ? 0 : count;
  return Math.max(0, kind.wrap === 'pinned' ? count - 1 : count - 3);
}

/**
 * Number of varying values of a curve, as OpenUSD counts them: at the ends of its segments, once more where a closed
 * linear curve begins, and not at those that a pinned curve has more than others.
 */
export function varyingCount({ kind }: CurveArrays, count: number, segments: number): number {
  if (kind.basis === 'nurbs') return count;
  if (kind.basis === 'linear') return kind.wrap === 'periodic' ? count + 1 : count;
  if (isPhantom(kind)) return Math.max(2, count - 2);
  return kind.wrap === 'periodic' ? segments : segments + 1;
}

/** Whether a curve has segments to phantom vertices. */
const isPhantom = ({ basis, wrap }: Exclude<CurveKind, { basis: 'nurbs' }>): boolean =>
  wrap === 'pinned' && (basis === 'bspline' || basis === 'catmullRom');

/**
 * Samples of all curves with at least one segment: `steps` per segment. Offsets of vertices and varying values go on
 * from one curve to the next.
 */
export function sampleCurves(curves: CurveArrays, steps: number): SampledCurve[] {
  const found: SampledCurve[] = [];
  let [vertex, varying, knot] = [0, 0, 0];
  for (let index = 0; index < curves.counts.length; index++) {
    const count = Math.max(0, curves.counts[index]);
    const segments = segmentCount(curves, count, index);
    const closed = curves.kind.basis !== 'nurbs' && curves.kind.wrap === 'periodic' && segments > 1;
    const values = varyingCount(curves, count, segments);
    if (segments > 0) {
      const samples =
        curves.kind.basis === 'nurbs'
          ? nurbsSamples(curves.kind, { index, vertex, count, knot }, steps)
          : segmentSamples(curves.kind, { vertex, count, segments, varying, values, closed }, steps);
      if (samples.length > 1) found.push({ index, closed, samples });
    }
    vertex += count;
    varying += values;
    if (curves.kind.basis === 'nurbs') knot += count + (curves.kind.orders[index] ?? 0);
  }
  return found;
}

interface OneCurve {
  readonly vertex: number;
  readonly count: number;
  readonly segments: number;
  readonly varying: number;
  readonly values: number;
  readonly closed: boolean;
}

function segmentSamples(
  { basis, wrap }: Exclude<CurveKind, { basis: 'nurbs' }>,
  { vertex, count, segments, varying, values, closed }: OneCurve,
  steps: number,
): CurveSample[] {
  const samples: CurveSample[] = [];
  const last = closed ? segments * steps : segments * steps + 1;
  for (let i = 0; i < last; i++) {
    const segment = Math.min(segments - 1, Math.floor(i / steps));
    const t = i / steps - segment;
    const [vertices, weights] = weighted(basis, wrap, segment, count, t);
    samples.push({
      vertices: vertices.map((v) => vertex + v),
      weights,
      varying: varyingPlace(isPhantom({ basis, wrap }), { segment, segments, values, t }, varying),
    });
  }
  return samples;
}

/** Where a place of a segment lies among the varying values that begin at `first`. */
function varyingPlace(
  phantom: boolean,
  at: { readonly segment: number; readonly segments: number; readonly values: number; readonly t: number },
  first: number,
): CurveSample['varying'] {
  const { segment, segments, values, t } = at;
  if (!phantom) return [first + segment, first + ((segment + 1) % values), t];
  if (segments < 3) return [first, first + 1, (segment + t) / segments];
  // Constant on the first and the last segment.
  const inside = (i: number): number => first + Math.min(values - 1, Math.max(0, i));
  return [inside(segment - 1), inside(segment), t];
}

/** Vertices of a segment and their weights at t. */
function weighted(
  basis: 'linear' | 'bezier' | 'bspline' | 'catmullRom',
  wrap: 'nonperiodic' | 'periodic' | 'pinned',
  segment: number,
  count: number,
  t: number,
): [vertices: number[], weights: number[]] {
  if (basis === 'linear')
    return [
      [segment, (segment + 1) % count],
      [1 - t, t],
    ];
  const weights = CUBICS[basis](t);
  const isPinned = isPhantom({ basis, wrap });
  const first = basis === 'bezier' ? 3 * segment : isPinned ? segment - 1 : segment;
  const vertices = [0, 1, 2, 3].map((k) => first + k);
  if (!isPinned) return [vertices.map((v) => v % count), weights];
  // Phantom vertices before and after the ends: 2 P₀ − P₁.
  const [at, of]: [number[], number[]] = [[], []];
  vertices.forEach((v, k) => {
    if (v < 0) at.push(0, Math.min(1, count - 1));
    else if (v >= count) at.push(count - 1, Math.max(0, count - 2));
    else at.push(v);
    of.push(...(v < 0 || v >= count ? [2 * weights[k], -weights[k]] : [weights[k]]));
  });
  return [at, of];
}

function nurbsSamples(
  { knots, orders, ranges, weights }: Extract<CurveKind, { basis: 'nurbs' }>,
  {
    index,
    vertex,
    count,
    knot,
  }: { readonly index: number; readonly vertex: number; readonly count: number; readonly knot: number },
  steps: number,
): CurveSample[] {
  const order = orders[index];
  if (!(order >= 2 && order <= MAX_ORDER) || knot + count + order > knots.length) return [];
  const u = (i: number): number => knots[knot + i];
  for (let i = 1; i < count + order; i++) if (!(u(i) >= u(i - 1))) return [];
  const low = Math.max(u(order - 1), ranges[2 * index] ?? -Infinity);
  const high = Math.min(u(count), ranges[2 * index + 1] ?? Infinity);
  const samples: CurveSample[] = [];
  for (let span = order - 1; span < count; span++) {
    const [from, to] = [Math.max(low, u(span)), Math.min(high, u(span + 1))];
    if (!(to > from)) continue;
    for (let i = 0; i <= steps; i++) {
      // A span begins where the one before it ends.
      if (i === 0 && samples.length > 0) continue;
      const basis = splineBasis(u, span, order, from + ((to - from) * i) / steps);
      const at = basis.map((_, k) => vertex + span - order + 1 + k);
      const rational = basis.map((b, k) => b * (weights?.[at[k]] ?? 1));
      const total = rational.reduce((sum, w) => sum + w, 0);
      samples.push({
        vertices: at,
        weights: total > 0 ? rational.map((w) => w / total) : basis,
        varying: [at[0], at[order - 1], i / steps],
      });
    }
  }
  return samples;
}

const MAX_ORDER = 16;

/** The B-splines of an order that are not zero in a span of knots, at x (Cox–de Boor). */
function splineBasis(u: (i: number) => number, span: number, order: number, x: number): number[] {
  const basis = [1];
  for (let degree = 1; degree < order; degree++) {
    let carried = 0;
    for (let k = 0; k < degree; k++) {
      const [right, left] = [u(span + k + 1), u(span + 1 - degree + k)];
      const share = right > left ? basis[k] / (right - left) : 0;
      basis[k] = carried + (right - x) * share;
      carried = (x - left) * share;
    }
    basis.push(carried);
  }
  return basis;
}
