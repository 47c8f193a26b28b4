import { If, int, select, uniform, vec3 } from 'three/tsl';
import { type Mesh, Vector3 } from 'three/webgpu';
import { addScaled, distance, length, scale, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { gamma } from '../../../physics/lorentz/boost.ts';
import { HYPERSURFACES } from '../../../physics/worldLines/hypersurface.ts';
import { positionAt, velocityAt, type WorldLine } from '../../../physics/worldLines/worldLine.ts';
import type { Int } from '../../../shaders/types.ts';
import type { DrawCall } from '../../gbuffer/drawCall.ts';
import { type Body, isSolvedPerVertex, linearMapOf, worldLineOfCenter } from '../../geometry/bodies.ts';
import type { ObjectTables } from '../../geometry/objectRows.ts';
import { OBJECT_TEXELS, ObjectTableWriter } from '../../geometry/objectTables.ts';
import { intersect, type Observation, type RelativeEvent } from '../../geometry/observation.ts';
import { vertexEvent } from '../../geometry/vertexStage.ts';
import { FloatTable } from '../../gpu/floatTable.ts';
import type { ShadowAtlas } from '../atlas/shadowAtlas.ts';
import type { Occluders } from '../occluders.ts';
import { type CasterPlacement, type LayerProjection, makeCaster } from './casterMesh.ts';
import { PoseTable, SURROUNDINGS } from './casterPoses.ts';

/** Smaller ones throw no shadow: radius over distance. */
const MIN_APPARENT_SIZE = 0.01;
/** Everywhere may be seen. */
const NO_CULLING = { sides: [], place: 'plain' } as const;

/** A body with the event of its centre that is seen, and its velocity there [c]. */
export interface ObservedCaster extends RelativeEvent {
  readonly body: Body;
  readonly beta: Vec3;
  /** How far it goes from its steady way while light crosses it, before or after [m]. */
  readonly drift: number;
}

/**
 * Occluders that have tiles of their own, in coordinates that move with them, measured from the events of their centres: what is rigid as it is
 * there, what deforms or accelerates each vertex at the event of it that is seen, so that it does not shade itself for being later or earlier.
 */
export class MovingCasters {
  private readonly occluders: Occluders;
  private readonly poses: PoseTable;
  private readonly frame: ObjectTableWriter;
  private readonly tables: ObjectTables;
  private readonly instanced: ReadonlySet<Body>;
  /** 1 where events are on the past light cone; else γβ and γ of the observer of whose moment they are. */
  private readonly events = { onLightCone: uniform(1), u: uniform(new Vector3()), gamma: uniform(1) };
  private readonly casters: { readonly mesh: Mesh; readonly bodies: readonly Body[] }[] = [];

  constructor(occluders: Occluders) {
    const { bodies, drawables, points } = occluders;
    this.occluders = occluders;
    this.poses = new PoseTable(bodies.length);
    this.tables = { objects: new FloatTable(256), samples: new FloatTable(1024), points };
    this.tables.objects.reserve(bodies.length * OBJECT_TEXELS);
    this.frame = new ObjectTableWriter(this.tables);
    this.instanced = new Set(drawables.flatMap(({ batch }) => (batch.instancing ? batch.bodies : [])));
  }

  /** Whether all samples that they need are on the GPU. */
  get isComplete(): boolean {
    return this.frame.isComplete;
  }

  /** Has them drawn into a map; `round`: 1 while what is drawn is measured from elsewhere. */
  addTo(map: ShadowAtlas, bodies: ReadonlySet<Body>, projecting: LayerProjection, round?: Int): void {
    const { drawables, materials } = this.occluders;
    for (const drawable of drawables) {
      const own = drawable.batch.bodies.filter((body) => bodies.has(body));
      if (drawable.batch.transparent || own.length === 0) continue;
      const mesh = makeCaster(drawable, this.placement(drawable, map.layer, round), projecting, materials);
      map.scene.add(mesh);
      this.casters.push({ mesh, bodies: own });
    }
  }

  /** From now on what none of these needs is not drawn. */
  showOnly(bodies: ReadonlySet<Body>): void {
    for (const caster of this.casters) caster.mesh.visible = caster.bodies.some((body) => bodies.has(body));
  }

  /** As of `PoseTable`: rigid bodies by their turn, in the slot of each from layer `first` on; of what deforms each vertex where it is seen, less its way since. */
  private placement({ batch, vertex }: DrawCall, first: Int, round?: Int): CasterPlacement {
    const rigid = this.poses.placement(first, round);
    if (!isSolvedPerVertex(batch)) return rigid;
    const { objects, samples } = this.tables;
    const uniforms = { ...vertex.uniforms, u: this.events.u, gamma: this.events.gamma };
    return (input) => ({
      ...rigid(input),
      x: () => {
        const center = objects.texel(int(input.object).mul(int(OBJECT_TEXELS))).xyz;
        const x = vec3(0).toVar();
        const measure = (event: 'emission' | 'slice'): void => {
          const { dx, s, exists } = vertexEvent({ ...vertex, objects, samples, uniforms }, { event }, input);
          const since = dx.sub(center).sub(this.poses.velocity(input).mul(s));
          x.assign(select(exists, since, vec3(0)));
        };
        If(this.events.onLightCone.greaterThan(0.5), () => measure('emission')).Else(() => measure('slice'));
        return x;
      },
    });
  }

  /** Places them, each in the slot of its number, and `round` them what rests, measured from elsewhere; what is drawn depends on what it tells. */
  update(
    movers: readonly ObservedCaster[],
    sight: Observation,
    round?: { readonly bodies: readonly Body[]; readonly from: Vec3 },
  ): string {
    this.poses.clear();
    const { onLightCone, u, gamma: factor } = this.events;
    const surface = HYPERSURFACES[sight.hypersurface];
    const moment = surface.momentVelocity(sight.u);
    onLightCone.value = surface.isLightCone ? 1 : 0;
    u.value.set(...moment);
    factor.value = gamma(moment);
    const deforming: Body[] = [];
    const shapes = movers.map(({ body, beta, offset, ahead }, slot) => {
      const t = sight.t + ahead / sight.c;
      const turn = linearMapOf(body, this.instanced.has(body), t, sight.c);
      if (!turn) deforming.push(body);
      this.poses.set(body, turn ?? [ZERO, ZERO, ZERO], ZERO, slot, beta);
      return `${body.id} ${turn ?? [sight.hypersurface, t, ...offset, ...moment]}`;
    });
    for (const body of round?.bodies ?? []) {
      const turn = linearMapOf(body, this.instanced.has(body), sight.t, sight.c);
      if (turn && round)
        this.poses.set(body, turn, sub(positionAt(body.line, sight.t, sight.c), round.from), SURROUNDINGS);
    }
    this.poses.upload();
    this.frame.fill(deforming, sight, NO_CULLING, false);
    return shapes.join();
  }

  dispose(): void {
    this.poses.dispose();
    this.tables.objects.dispose();
    this.tables.samples.dispose();
  }
}

/** The bodies that are there at all, from the one that looks largest on. */
export function largestCasters(bodies: readonly Body[], sight: Observation): readonly ObservedCaster[] {
  return bodies
    .flatMap((body) => {
      const line = worldLineOfCenter(body, sight.c);
      const event = intersect(line, sight);
      const { birth, death } = body.object.lifetime;
      if (!event || !(sight.c * (birth - sight.t) <= event.ahead && event.ahead <= sight.c * (death - sight.t)))
        return [];
      const size = body.radius / Math.max(length(event.offset) - body.radius, 1e-3 * body.radius);
      if (!(size > MIN_APPARENT_SIZE)) return [];
      const beta = scale(velocityAt(line, sight.t + event.ahead / sight.c, sight.c), 1 / sight.c);
      return [{ body, ...event, beta, drift: driftOf(line, event.ahead, beta, body.radius, sight), size }];
    })
    .sort((a, b) => b.size - a.size || a.body.id - b.body.id);
}

/** Where a mover's centre would be at the observer's time, with the velocity that it has [m]. */
export const comovingCenter = ({ offset, beta, ahead }: ObservedCaster): Vec3 => addScaled(offset, beta, -ahead);

/**
 * How far what meets a mover's tile is lifted towards the light [m]: a rigid body is drawn as it is at one event, from which its surface, seen later or
 * earlier, is as far as it drifts.
 */
export const driftBias = ({ body, drift }: ObservedCaster): number =>
  isSolvedPerVertex(body.object.motion) ? 0 : drift;

/** How far a line is from straight on with β, `radius` of light before and after an event [m]. */
function driftOf(line: WorldLine, ahead: number, beta: Vec3, radius: number, { t, c }: Observation): number {
  const at = (after: number): Vec3 => positionAt(line, t + (ahead + after) / c, c);
  return Math.max(...[-radius, radius].map((after) => distance(at(after), addScaled(at(0), beta, after))));
}
