import type { Hit, RayFilter, SightCurve, SpacetimeRay } from '../acceleration/ray.ts';

/** Upper bound of corrections of a hit. Each squares the error, which is 2 · 10⁻⁴ at first. */
const MAX_CORRECTIONS = 4;
/** Relative change of s of a hit that is exact. */
const EXACT = 1e-13;

type FindNearest = (ray: SpacetimeRay, filter: RayFilter) => Hit | undefined;

/** The nearest hit on a curve: found on its chords one after another, then corrected on tangents. One that only the chord meets, at a silhouette, stays as it is. */
export function nearestOnCurve(curve: SightCurve, filter: RayFilter, nearest: FindNearest): Hit | undefined {
  const { begin = 0, end = Number.POSITIVE_INFINITY } = filter;
  const { knots } = curve;
  for (let k = 0; k + 1 < knots.length; k++) {
    const [from, to] = [Math.max(begin, knots[k]!), Math.min(end, knots[k + 1]!)];
    if (from > to) continue;
    // A ray that goes on from a surface meets that again where it left it.
    const piece = from > knots[k]! ? curve.tangent(from) : curve.chord(k);
    const found = nearest(piece, { ...filter, begin: from, end: to });
    if (found) return corrected(curve, k, found, filter, nearest);
  }
  return undefined;
}

/** `k`: the knot before the chord that it was found on. */
function corrected(curve: SightCurve, k: number, found: Hit, filter: RayFilter, nearest: FindNearest): Hit {
  const { begin = 0, end = Number.POSITIVE_INFINITY, visibleSides, accepts, alwaysAccept } = filter;
  const { knots } = curve;
  const range = {
    begin: Math.max(begin, knots[k - 1] ?? 0),
    end: Math.min(end, knots[k + 2] ?? Number.POSITIVE_INFINITY),
    visibleSides: visibleSides ?? false,
    accepts: (hit: Hit): boolean =>
      hit.object === found.object && (alwaysAccept?.[hit.object] || !accepts || accepts(hit)),
  };
  let hit = found;
  for (let i = 0; i < MAX_CORRECTIONS; i++) {
    const next = nearest(curve.tangent(hit.s), range);
    if (!next) break;
    const isExact = Math.abs(next.s - hit.s) <= EXACT * hit.s;
    hit = next;
    if (isExact) break;
  }
  return hit;
}
