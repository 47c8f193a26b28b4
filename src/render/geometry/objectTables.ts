import { length, type Vec3, ZERO } from '../../math/vec3.ts';
import type { PlacementName } from '../../physics/optics/placement.ts';
import { slowed, slowedPlace } from '../../physics/worldLines/shallowCone.ts';
import { simultaneousPosition } from '../../physics/worldLines/simultaneity.ts';
import type { BoundingSphere } from '../../scene/bounds/bounds.ts';
import { motionKind } from '../../scene/motion/motions.ts';
import { type Body, worldLineOfCenter } from './bodies.ts';
import { aberrateCone, type Cone, coneAround, coneMayIntersectFrustum } from './culling.ts';
import { type ObjectRow, type ObjectTables, objectRows } from './objectRows.ts';
import { intersect, type Observation, type WorldTubeSection, worldTubeSection } from './observation.ts';

/** Texels per object in the object table. */
export const OBJECT_TEXELS = 5;
/** The picture's sides, for culling, and how directions are mapped from the world to the frame that they are in. */
export interface ViewFrustum {
  readonly sides: readonly Vec3[];
  readonly place: PlacementName;
}

/**
 * Writes the object and sample tables, per frame and in f64: for every object the event where the world line of its centre meets the hypersurface (its
 * anchor), and what its vertices need, relative to that event, so that f32 never holds a large number. The object table has, from texel
 * OBJECT_TEXELS · (id − 1):
 *   0: (Δx, |Δx|) of the anchor [m]; |Δx| < 0 if nothing of the object can be in the picture.
 *   1: uniform (v, 1 − v²); hyperbolic (axis, a/c² [1/m]); sampled points (origin relative to the anchor [m], texels per sample).
 *   2: birth, death and the observer's event, in metres of light after the anchor's time; the object's id.
 *   3: uniform (Born rigid); hyperbolic (e^φ, Born rigid, shift of the anchor [m]); sampled (first texel, count) in the sample table, and 1/c for points.
 *   4: orientation, if it has one.
 * The sample table has two texels per sample, (place, time) relative to the anchor and the orientation; or one for deforming meshes, (sample, bend of the
 * piece after it (`bendFactor`), 0, time).
 */
export class ObjectTableWriter {
  private readonly tables: ObjectTables;
  private used = 0;
  private complete = true;

  constructor(tables: ObjectTables) {
    this.tables = tables;
  }

  /**
   * Fills the tables; returns which bodies may be in the picture. `withNow`: include samples from or up to the observer's own time, where Newton's search along
   * world lines begins. `isDrawn`: others are not in the picture, as if they could not be seen.
   */
  fill(
    bodies: readonly Body[],
    observation: Observation,
    frustum: ViewFrustum,
    withNow: boolean,
    isDrawn: (body: Body) => boolean = () => true,
  ): boolean[] {
    const { objects, samples } = this.tables;
    this.used = 0;
    this.complete = true;
    objects.reserve(bodies.length * OBJECT_TEXELS);
    const visible = bodies.map((body) =>
      isDrawn(body) ? this.writeObject(body, observation, frustum, withNow) : this.writeUnseen(body),
    );
    objects.upload();
    samples.upload();
    return visible;
  }

  /** Whether all samples that the last frame needs are on the GPU; otherwise they are being loaded, and the frame has to be drawn again. */
  get isComplete(): boolean {
    return this.complete;
  }

  /** Δx of an object's anchor in the last frame [m]; undefined if it cannot be seen. */
  anchor(id: number): Vec3 | undefined {
    const at = 4 * OBJECT_TEXELS * (id - 1);
    const [x, y, z, r] = this.tables.objects.values.subarray(at, at + 4);
    return r < 0 ? undefined : [x, y, z];
  }

  private writeObject(body: Body, observation: Observation, frustum: ViewFrustum, withNow: boolean): boolean {
    const at = 4 * OBJECT_TEXELS * (body.id - 1);
    const out = this.tables.objects.values;
    const line = worldLineOfCenter(body, observation.c);
    const section = worldTubeSection(line, body.radius, observation);
    const exists = section && overlapsLifetime(body, section, observation);
    if (!section || !exists || !maybeVisible(section.sphere, observation, frustum)) return this.writeUnseen(body);
    // A body that straddles a horizon is anchored where it has come out farthest: its centre may be infinitely far away.
    const straddles = section.sphere.radius === Number.POSITIVE_INFINITY || !section.anchor;
    const trailing = straddles ? this.trailingAnchor(body, observation) : undefined;
    const anchor = trailing?.anchor ?? section.anchor;
    if (!anchor) return this.writeUnseen(body);
    out.set([...anchor.offset, length(anchor.offset)], at);
    const { birth, death } = body.object.lifetime;
    const after = (t: number) => clampFinite(observation.c * (t - observation.t) - anchor.ahead);
    out.set([after(birth), after(death), -anchor.ahead, body.id], at + 8);
    const orientation = motionKind(body.object.motion).fixedOrientation(body.object.motion);
    if (orientation) out.set(orientation, at + 16);
    const neededSection = withNow
      ? { ...section, from: Math.min(section.from, 0), to: Math.max(section.to, 0) }
      : section;
    const anchorPoint = trailing?.anchorPoint ?? ZERO;
    this.writeMotion({ body, line, section: neededSection, anchor, anchorPoint, observation, at });
    return true;
  }

  private writeUnseen({ id }: Body): false {
    this.tables.objects.values[4 * OBJECT_TEXELS * (id - 1) + 3] = -1;
    return false;
  }

  private trailingAnchor(body: Body, observation: Observation): Pick<ObjectRow, 'anchor' | 'anchorPoint'> | undefined {
    const { motion } = body.object;
    const anchorPoint = objectRows(motion).trailingPoint(motion, body);
    const anchor = anchorPoint && intersect(worldLineOfCenter(body, observation.c, anchorPoint), observation);
    return anchor && { anchor, anchorPoint };
  }

  private writeMotion(row: ObjectRow): void {
    const { motion } = row.body.object;
    const { complete, used } = objectRows(motion).write(motion, row, this.tables, this.used);
    this.complete = complete && this.complete;
    this.used = used;
  }
}

/** Times beyond those of any event, because f32 tables cannot do with ±Infinity. */
const clampFinite = (t: number): number => Math.max(-1e30, Math.min(1e30, t));

function overlapsLifetime({ object }: Body, { from, to }: WorldTubeSection, observation: Observation): boolean {
  const ahead = (t: number) => observation.c * (t - observation.t);
  return ahead(object.lifetime.birth) <= to && ahead(object.lifetime.death) >= from;
}

/** Conservative: false only if no pixel can show any of it. */
function maybeVisible(sphere: BoundingSphere, observation: Observation, frustum: ViewFrustum): boolean {
  const cone = CONES[frustum.place](sphere, observation);
  return !cone || coneMayIntersectFrustum(cone, frustum.sides);
}

/** The cone of directions in which a picture shows what is in a sphere; undefined: all directions. */
const CONES: Readonly<Record<PlacementName, (sphere: BoundingSphere, observation: Observation) => Cone | undefined>> = {
  apparent(sphere, { u }) {
    const cone = coneAround(sphere);
    return cone && aberrateCone(cone, u);
  },
  contracted: (sphere, { u }) => coneAround(contracted(sphere, u)),
  shallow({ center, radius }, { u, coneSlope }) {
    const cone = coneAround({ center: slowedPlace(center, u, coneSlope), radius });
    return cone && aberrateCone(cone, slowed(u, coneSlope));
  },
  plain: coneAround,
};

const contracted = (sphere: BoundingSphere, u: Vec3): BoundingSphere => ({
  center: simultaneousPosition(sphere.center, u),
  radius: sphere.radius,
});
