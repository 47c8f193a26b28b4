import { type Vec3, ZERO } from '../../math/vec3.ts';
import { samplesUntil } from '../../physics/worldLines/samples.ts';
import type { Lifetime } from '../../scene/types.ts';
import type { SpacetimeRay } from '../acceleration/ray.ts';
import { clipToTimes, type MovingBox, type RayQuery } from '../acceleration/rayQuery.ts';
import { TimeBvh } from '../acceleration/timeBvh.ts';

/** Intersects a ray between s = begin and s = end with piece k of a motion. */
export type PieceTracer = (ray: SpacetimeRay, k: number, begin: number, end: number, search: RayQuery) => void;

/** The current ray relative to the origin of the current object: o x y z, d x y z. */
const line = new Float64Array(6);

/**
 * Finds the pieces of a sampled motion in which a ray may meet the object, in the order in which the ray passes them. Piece k lies between samples k and
 * k + 1; the object is at rest in piece −1, before its first sample, and in the last one, after its last sample.
 */
export class PieceSearch {
  /** The greatest absolute coordinate [m]. */
  readonly reach: number;
  private readonly times: Float64Array;
  private readonly origin: Vec3;
  private readonly c: number;
  private readonly timeBvh: TimeBvh;
  private readonly trace: PieceTracer;

  /** `outlines`: the object's boxes at the samples relative to `origin`, 6 numbers each [m]. */
  constructor(times: Float64Array, origin: Vec3, outlines: Float64Array, c: number, trace: PieceTracer) {
    this.times = times;
    this.origin = origin;
    this.c = c;
    this.timeBvh = new TimeBvh(outlines);
    this.reach = Math.max(...this.timeBvh.whole.map(Math.abs));
    this.trace = trace;
  }

  get bounds(): MovingBox {
    return { box: Array.from(this.timeBvh.whole, (x, i) => x + this.origin[i % 3]), velocity: ZERO };
  }

  /** When piece k begins and ends [s]. */
  timesOf(k: number): readonly [from: number, to: number] {
    const { times } = this;
    return [
      k < 0 ? Number.NEGATIVE_INFINITY : times[k],
      k < times.length - 1 ? times[k + 1] : Number.POSITIVE_INFINITY,
    ];
  }

  intersect(ray: SpacetimeRay, { birth, death }: Lifetime, search: RayQuery): void {
    const [begin, end] = clipToTimes(ray, birth, death, this.c, search.begin, search.end);
    if (begin > end) return;
    const { pieces } = this.timeBvh;
    if (ray.dt === 0) {
      this.trace(ray, samplesUntil(this.times, ray.t) - 1, begin, end, search);
      return;
    }
    for (let i = 0; i < 3; i++) {
      line[i] = ray.x[i] - this.origin[i];
      line[3 + i] = ray.dx[i];
    }
    const [early, late] = ray.dt > 0 ? [-1, pieces] : [pieces, -1];
    this.trace(ray, early, begin, end, search);
    this.descend(ray, 1, 0, pieces - 1, begin, end, search);
    this.trace(ray, late, begin, end, search);
  }

  /** Intersects the pieces from first to last, in the order in which the ray passes them. */
  private descend(
    ray: SpacetimeRay,
    node: number,
    first: number,
    last: number,
    begin: number,
    end: number,
    search: RayQuery,
  ): void {
    const { times } = this;
    const perSecond = this.c / ray.dt;
    const one = (times[first] - ray.t) * perSecond;
    const other = (times[last + 1] - ray.t) * perSecond;
    const near = Math.max(begin, Math.min(one, other));
    const far = Math.min(end, search.end, Math.max(one, other));
    if (near > far || !this.timeBvh.intersects(node, line, near, far)) return;
    if (first === last) {
      this.trace(ray, first, near, far, search);
      return;
    }
    const middle = (first + last) >> 1;
    const rising = ray.dt > 0;
    if (rising) this.descend(ray, 2 * node, first, middle, begin, end, search);
    this.descend(ray, 2 * node + 1, middle + 1, last, begin, end, search);
    if (!rising) this.descend(ray, 2 * node, first, middle, begin, end, search);
  }
}
