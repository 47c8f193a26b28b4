import { length, type Vec3 } from '../../math/vec3.ts';
import type { PlacementName } from '../../physics/optics/placement.ts';
import { simultaneousPosition } from '../../physics/worldLines/simultaneity.ts';
import type { BoundingSphere } from '../../scene/bounds/bounds.ts';
import { motionKind } from '../../scene/motion/motions.ts';
import { type Body, worldLineOfCenter } from './bodies.ts';
import { aberrateCone, type Cone, coneAround, coneMayIntersectFrustum } from './culling.ts';
import { type ObjectRow, type ObjectTables, objectRows } from './objectRows.ts';
import {
  intersect,
  type Observation,
  type RelativeEvent,
  type WorldTubeSection,
  worldTubeSection,
} from './observation.ts';

/** Texels per object in the object table. */
export const OBJECT_TEXELS = 5;
/** How the picture is looked at, for culling: where the observer's frame puts a direction of the world. */
export interface ViewFrustum {
  readonly sides: readonly Vec3[];
  readonly place: PlacementName;
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

  /** Fills the tables; tells which bodies may be in the picture. `backToNow`: a world-line search that begins at the observer's own time. */
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
    const orientation = motionKind(body.object.motion).fixedOrientation(body.object.motion);
    if (orientation) out.set(orientation, at + 16);
    const needed = backToNow ? { ...span, to: Math.max(span.to, 0) } : span;
    this.writeMotion({ body, line, span: needed, anchor, observation: sight, at });
    return true;
  }

  private trailingAnchor(body: Body, sight: Observation): RelativeEvent | undefined {
    const { motion } = body.object;
    const point = objectRows(motion).trailingPoint(motion, body.radius);
    return point && intersect(worldLineOfCenter(body, sight.c, point), sight);
  }

  private writeMotion(row: ObjectRow): void {
    const { motion } = row.body.object;
    const { complete, used } = objectRows(motion).write(motion, row, this.tables, this.used);
    this.complete = complete && this.complete;
    this.used = used;
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
