import { length, normalize, scale, type Vec3 } from '../../math/vec3.ts';
import { oneMinusBetaSquared } from '../../physics/lorentz/boost.ts';
import type { PlacementName } from '../../physics/optics/placement.ts';
import { simultaneousPosition } from '../../physics/worldLines/simultaneity.ts';
import type { PolylineLine, WorldLine } from '../../physics/worldLines/worldLine.ts';
import { bendFactor, isCubic } from '../../scene/motion/cubicPoints.ts';
import { samplePose } from '../../scene/motion/poses.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import { type Body, worldLineOfCenter } from './bodies.ts';
import { aberrateCone, type BoundingSphere, type Cone, coneAround, coneMayIntersectFrustum } from './culling.ts';
import {
  intersect,
  type Observation,
  type RelativeEvent,
  rapidityFactor,
  relativeTo,
  sampleWindow,
  trailingPoint,
  type WorldTubeSection,
  worldTubeSection,
} from './observation.ts';
import type { PointStore } from './pointSamples/pointStore.ts';

/** Texels per object in the object table. */
export const OBJECT_TEXELS = 5;
/** Longest table that a vertex searches. */
const MAX_SAMPLES = 4096;

/** How the picture is looked at, for culling: where the observer's frame puts a direction of the world. */
export interface ViewFrustum {
  readonly sides: readonly Vec3[];
  readonly place: PlacementName;
}

export interface ObjectTables {
  readonly objects: FloatTable;
  readonly samples: FloatTable;
  readonly points: ReadonlyMap<number, PointStore>;
}

/**
 * Once per picture, in f64: for every object the event of its centre on the surface that is looked at (its anchor), and what its vertices need,
 * relative to that, so that f32 never meets a large number. The object table holds, from texel OBJECT_TEXELS · (id − 1):
 *   0  (Δx, |Δx|) of the anchor [m], |Δx| < 0 where nothing of the object can be in the picture
 *   1  uniform (v, 1 − v²); hyperbolic (axis, a/c² [1/m]); sampled points (origin relative to the anchor [m], texels per sample)
 *   2  birth, death and the observer's event, in light-metres after the anchor's time; the object's id
 *   3  uniform (born rigid); hyperbolic (e^φ, born rigid, shift of the anchor [m]); sampled (first texel, count) of the sample table, and 1/c of points
 *   4  orientation, where it has one
 * and the sample table, per sample, two texels: (place, time) relative to the anchor and the orientation, or one: (sample, bend of the piece
 * after it (`bendFactor`), 0, time).
 */
export class ObjectTableWriter {
  private readonly tables: ObjectTables;
  private used = 0;
  private complete = true;

  constructor(tables: ObjectTables) {
    this.tables = tables;
  }

  /** Fills the tables; tells which bodies may be in the picture. `backTo`: a world-line search that begins at the observer's own time. */
  fill(bodies: readonly Body[], sight: Observation, gaze: ViewFrustum, backToNow: boolean): boolean[] {
    const { objects, samples } = this.tables;
    this.used = 0;
    this.complete = true;
    objects.reserve(bodies.length * OBJECT_TEXELS);
    const seen = bodies.map((body) => this.writeObject(body, sight, gaze, backToNow));
    objects.upload();
    samples.upload();
    return seen;
  }

  /** Whether all samples that the last picture needs are on the GPU; else some are on their way, and it is to be made again. */
  get isComplete(): boolean {
    return this.complete;
  }

  /** |Δx| of an object's anchor in the last picture [m]; negative where it cannot be seen. */
  distance(id: number): number {
    return this.tables.objects.values[4 * OBJECT_TEXELS * (id - 1) + 3];
  }

  private writeObject(body: Body, sight: Observation, gaze: ViewFrustum, backToNow: boolean): boolean {
    const at = 4 * OBJECT_TEXELS * (body.id - 1);
    const out = this.tables.objects.values;
    const line = worldLineOfCenter(body, sight.c);
    const span = worldTubeSection(line, body.radius, sight);
    const alive = span && overlapsLifetime(body, span, sight);
    if (!span || !alive || !maybeVisible(span.sphere, sight, gaze)) {
      out[at + 3] = -1;
      return false;
    }
    const anchor = span.anchor ?? this.trailingAnchor(body, sight);
    if (!anchor) {
      out[at + 3] = -1;
      return false;
    }
    out.set([...anchor.offset, length(anchor.offset)], at);
    const { birth, death } = body.object.lifetime;
    const after = (t: number) => clampFinite(sight.c * (t - sight.t) - anchor.ahead);
    out.set([after(birth), after(death), -anchor.ahead, body.id], at + 8);
    if ('pose' in body.object.motion) out.set(body.object.motion.pose.orientation, at + 16);
    this.writeMotion(body, line, backToNow ? { ...span, to: Math.max(span.to, 0) } : span, anchor, sight, at);
    return true;
  }

  private trailingAnchor(body: Body, sight: Observation): RelativeEvent | undefined {
    const { motion } = body.object;
    if (motion.kind !== 'hyperbolic') return undefined;
    return intersect(worldLineOfCenter(body, sight.c, trailingPoint(motion.properAcceleration, body.radius)), sight);
  }

  private writeMotion(
    body: Body,
    line: WorldLine,
    span: WorldTubeSection,
    anchor: RelativeEvent,
    sight: Observation,
    at: number,
  ): void {
    const out = this.tables.objects.values;
    const rigid = body.object.authoredIn === 'rest' ? 1 : 0;
    if (line.kind === 'uniform') {
      const v = scale(line.velocity, 1 / sight.c);
      out.set([...v, oneMinusBetaSquared(v)], at + 4);
      out.set([rigid, 0, 0, 0], at + 12);
    } else if (line.kind === 'hyperbolic') {
      const shift = span.anchor ? 0 : -body.radius;
      const reference = span.anchor
        ? line
        : worldLineOfCenter(body, sight.c, trailingPoint(line.properAcceleration, body.radius));
      if (reference.kind !== 'hyperbolic') return;
      const a = reference.properAcceleration;
      out.set([...normalize(a, [1, 0, 0]), length(a) / (sight.c * sight.c)], at + 4);
      out.set([rapidityFactor(a, line.t0, anchor.ahead, sight), rigid, shift, 0], at + 12);
    } else if (line.kind === 'polyline') {
      this.writeSamples(body, line, span, anchor, sight, at);
    }
  }

  private writeSamples(
    body: Body,
    line: PolylineLine,
    span: WorldTubeSection,
    anchor: RelativeEvent,
    sight: Observation,
    at: number,
  ): void {
    const { motion } = body.object;
    const out = this.tables.objects.values;
    const store = this.tables.points.get(body.id);
    const [first, count] = sampleWindow(line, span, sight, Math.min(MAX_SAMPLES, store?.capacity ?? MAX_SAMPLES));
    const after = (k: number) => sight.c * (line.times[k] - sight.t) - anchor.ahead;
    const samples = this.tables.samples;
    out.set([this.used, count], at + 12);
    if (motion.kind === 'sampled-points' && store) {
      this.complete = store.ensureResident(first, count) && this.complete;
      samples.reserve(this.used + count);
      out.set([...relativeTo(motion.origin, sight, anchor), store.stride], at + 4);
      const bend = isCubic(motion)
        ? (k: number) => (k + 1 < line.times.length ? bendFactor(motion, k, sight.c) : 0)
        : () => 0;
      out[at + 14] = 1 / sight.c;
      for (let k = first; k < first + count; k++)
        samples.values.set([store.slot(k), bend(k), 0, after(k)], 4 * this.used++);
    } else if (motion.kind === 'sampled') {
      samples.reserve(this.used + 2 * count);
      for (let k = first; k < first + count; k++) {
        const place: Vec3 = [line.positions[3 * k], line.positions[3 * k + 1], line.positions[3 * k + 2]];
        samples.values.set([...relativeTo(place, sight, anchor), after(k)], 4 * this.used++);
        samples.values.set(samplePose(motion.poses, k).orientation, 4 * this.used++);
      }
    }
  }
}

/** f32 has no use for ±Infinity in a uniform table: a time no event has. */
const clampFinite = (t: number): number => Math.max(-1e30, Math.min(1e30, t));

function overlapsLifetime({ object }: Body, { from, to }: WorldTubeSection, sight: Observation): boolean {
  const ahead = (t: number) => sight.c * (t - sight.t);
  return ahead(object.lifetime.birth) <= to && ahead(object.lifetime.death) >= from;
}

/** Conservative: false only for what no pixel can show. */
function maybeVisible(ball: BoundingSphere, sight: Observation, gaze: ViewFrustum): boolean {
  const cone = CONES[gaze.place](ball, sight.u);
  return !cone || coneMayIntersectFrustum(cone, gaze.sides);
}

/** The cone of directions in which a picture shows what is in a sphere; undefined: all directions. */
const CONES: Readonly<Record<PlacementName, (sphere: BoundingSphere, u: Vec3) => Cone | undefined>> = {
  apparent(sphere, u) {
    const cone = coneAround(sphere);
    return cone && aberrateCone(cone, u);
  },
  contracted: (sphere, u) => coneAround(contracted(sphere, u)),
  plain: coneAround,
};

const contracted = (ball: BoundingSphere, u: Vec3): BoundingSphere => ({
  center: simultaneousPosition(ball.center, u),
  radius: ball.radius,
});
