import { If, int, select, uniform, vec3 } from 'three/tsl';
import { type Mesh, Vector3 } from 'three/webgpu';
import { addScaled, distance, length, scale, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { gamma } from '../../../physics/lorentz/boost.ts';
import { hypersurfaceOf } from '../../../physics/worldLines/hypersurface.ts';
import { positionAt, velocityAt, type WorldLine } from '../../../physics/worldLines/worldLine.ts';
import { pointSamples } from '../../../scene/motion/motion.ts';
import { pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion } from '../../../scene/types.ts';
import type { Int } from '../../../shaders/types.ts';
import type { DrawCall } from '../../gbuffer/drawCall.ts';
import { type Body, isSolvedPerVertex, linearMapOf, worldLineOfCenter } from '../../geometry/bodies.ts';
import type { ObjectTables } from '../../geometry/objectRows.ts';
import { OBJECT_TEXELS, ObjectTableWriter } from '../../geometry/objectTables.ts';
import { intersect, type Observation, type RelativeEvent } from '../../geometry/observation.ts';
import { vertexEvent } from '../../geometry/vertexStage.ts';
import type { Gpu } from '../../gpu/device.ts';
import { FloatTable } from '../../gpu/floatTable.ts';
import { TriangleTable } from '../../tessellation/gpu/triangleTable.ts';
import type { ShadowAtlas } from '../atlas/shadowAtlas.ts';
import type { Occluders } from '../occluders.ts';
import { type CasterPlacement, dividedBatch, type LayerProjection, makeCaster, wholeBatch } from './casterMesh.ts';
import { PoseTable, SURROUNDINGS } from './casterPoses.ts';

/** Smaller bodies throw no shadow: radius over distance. */
const MIN_APPARENT_SIZE = 0.01;
/** Nothing is culled: casters may be in any direction. */
const NO_CULLING = { sides: [], place: 'plain' } as const;

/** A moving caster at the event of its centre that is seen, with its velocity there [c]. */
export interface ObservedCaster extends RelativeEvent {
  readonly body: Body;
  readonly beta: Vec3;
  /** Largest deviation from uniform motion while light crosses the body, before or after that event [m]. */
  readonly drift: number;
}

/**
 * Occluders with tiles of their own, in coordinates that move with them, relative to the events of their centres: rigid bodies with the pose that they have
 * there; of bodies that turn, deform or accelerate, each vertex at its own event that is seen, so that the body does not shade itself because parts of it are seen
 * later or earlier.
 */
export class MovingCasters {
  private readonly occluders: Occluders;
  private readonly poses: PoseTable;
  private readonly frame: ObjectTableWriter;
  private readonly tables: ObjectTables;
  /** Of the divided batches. */
  private readonly triangles: TriangleTable;
  private readonly instanced: ReadonlySet<Body>;
  /** 1 where events are on the past light cone; otherwise γβ and γ of the observer whose slice of simultaneity is shown. */
  private readonly events = { onLightCone: uniform(1), u: uniform(new Vector3()), gamma: uniform(1) };
  private readonly casters: { readonly mesh: Mesh; readonly bodies: readonly Body[] }[] = [];

  constructor(occluders: Occluders, { renderer }: Gpu) {
    const { bodies, drawCalls, points } = occluders;
    this.occluders = occluders;
    this.triangles = new TriangleTable(renderer);
    this.poses = new PoseTable(bodies.length);
    this.tables = { objects: new FloatTable(256), samples: new FloatTable(1024), points };
    this.tables.objects.reserve(bodies.length * OBJECT_TEXELS);
    this.frame = new ObjectTableWriter(this.tables);
    this.instanced = new Set(drawCalls.flatMap(({ batch }) => (batch.instancing ? batch.bodies : [])));
  }

  /** Whether all samples that the casters need are on the GPU. */
  get isComplete(): boolean {
    return this.frame.isComplete;
  }

  /** Adds the casters to an atlas; `drawsSurroundings`: uniform that is 1 while the surroundings of a light are drawn, which have another origin. */
  addTo(map: ShadowAtlas, bodies: ReadonlySet<Body>, projection: LayerProjection, drawsSurroundings?: Int): void {
    const { drawCalls, materials } = this.occluders;
    for (const drawCall of drawCalls) {
      const ownBodies = drawCall.batch.bodies.filter((body) => bodies.has(body));
      if (drawCall.batch.transparent || ownBodies.length === 0) continue;
      const source = isSolvedPerVertex(drawCall.batch) ? dividedBatch(drawCall, this.triangles) : wholeBatch(drawCall);
      const mesh = makeCaster(source, this.placement(drawCall, map.layer, drawsSurroundings), projection, materials);
      map.scene.add(mesh);
      this.casters.push({ mesh, bodies: ownBodies });
    }
  }

  /** Hides the meshes that none of these bodies needs. */
  showOnly(bodies: ReadonlySet<Body>): void {
    for (const caster of this.casters) caster.mesh.visible = caster.bodies.some((body) => bodies.has(body));
  }

  /**
   * As `PoseTable.placement` for rigid bodies; vertices of others are placed at the event where they are seen, moved back with the body's velocity
   * to the time of its centre's event.
   */
  private placement({ batch, vertex }: DrawCall, first: Int, drawsSurroundings?: Int): CasterPlacement {
    const rigid = this.poses.placement(first, drawsSurroundings);
    if (!isSolvedPerVertex(batch)) return rigid;
    const { objects, samples } = this.tables;
    const uniforms = { ...vertex.uniforms, u: this.events.u, gamma: this.events.gamma };
    return (input) => ({
      ...rigid(input),
      x: () => {
        const center = objects.texel(int(input.object).mul(int(OBJECT_TEXELS))).xyz;
        const x = vec3(0).toVar();
        const placeAt = (event: 'emission' | 'slice'): void => {
          const { dx, s, exists } = vertexEvent({ ...vertex, objects, samples, uniforms }, { event }, input);
          const displacement = dx.sub(center).sub(this.poses.velocity(input).mul(s));
          x.assign(select(exists, displacement, vec3(0)));
        };
        If(this.events.onLightCone.greaterThan(0.5), () => placeAt('emission')).Else(() => placeAt('slice'));
        return x;
      },
    });
  }

  /**
   * Sets the poses: each mover in the slot of its index, and the bodies of `surroundings` as `SURROUNDINGS`, relative to its `from`. Returns a key of all that is
   * drawn.
   */
  update(
    movers: readonly ObservedCaster[],
    observation: Observation,
    surroundings?: { readonly bodies: readonly Body[]; readonly from: Vec3 },
  ): string {
    this.poses.clear();
    const { onLightCone, u, gamma: observerGamma } = this.events;
    const hypersurface = hypersurfaceOf(observation);
    const observerU = hypersurface.momentVelocity(observation.u);
    onLightCone.value = hypersurface.isLightCone ? 1 : 0;
    u.value.set(...observerU);
    observerGamma.value = gamma(observerU);
    const deforming: Body[] = [];
    const shapes = movers.map(({ body, beta, offset, ahead }, slot) => {
      const t = observation.t + ahead / observation.c;
      const linearMap = linearMapOf(body, this.instanced.has(body), t, observation.c);
      if (!linearMap) deforming.push(body);
      this.poses.set(body, linearMap ?? [ZERO, ZERO, ZERO], ZERO, slot, beta);
      return `${body.id} ${linearMap ?? [observation.hypersurface, observation.coneSlope, t, ...offset, ...observerU]}`;
    });
    for (const body of surroundings?.bodies ?? []) {
      const linearMap = linearMapOf(body, this.instanced.has(body), observation.t, observation.c);
      if (linearMap && surroundings)
        this.poses.set(
          body,
          linearMap,
          sub(positionAt(body.line, observation.t, observation.c), surroundings.from),
          SURROUNDINGS,
        );
    }
    this.poses.upload();
    this.frame.fill(deforming, observation, NO_CULLING, false);
    return shapes.join();
  }

  dispose(): void {
    this.poses.dispose();
    this.tables.objects.dispose();
    this.tables.samples.dispose();
    this.triangles.dispose();
  }
}

/** The bodies that exist at their events, in order of decreasing apparent size. */
export function largestCasters(bodies: readonly Body[], observation: Observation): readonly ObservedCaster[] {
  return bodies
    .flatMap((body) => {
      const line = worldLineOfCenter(body, observation.c);
      const event = intersect(line, observation);
      const { birth, death } = body.object.lifetime;
      if (
        !event ||
        !(
          observation.c * (birth - observation.t) <= event.ahead &&
          event.ahead < observation.c * (death - observation.t)
        )
      )
        return [];
      const size = body.radius / Math.max(length(event.offset) - body.radius, 1e-3 * body.radius);
      if (!(size > MIN_APPARENT_SIZE)) return [];
      const beta = scale(
        velocityAt(line, observation.t + event.ahead / observation.c, observation.c),
        1 / observation.c,
      );
      const drift = driftOf(line, event.ahead, beta, body.radius, observation) + turnDrift(body, observation.c);
      return [{ body, ...event, beta, drift, size }];
    })
    .sort((a, b) => b.size - a.size || a.body.id - b.body.id);
}

/** A mover's centre at the observer's time if it keeps its velocity, relative to the observer [m]. */
export const comovingCenter = ({ offset, beta, ahead }: ObservedCaster): Vec3 => addScaled(offset, beta, -ahead);

/**
 * How far receivers are moved towards the light [m] to avoid self-shadowing: a rigid body is drawn as it is at one event, and its surface, seen later or
 * earlier, deviates from that by its drift.
 */
export const driftBias = ({ body, drift }: ObservedCaster): number =>
  isSolvedPerVertex(body.object.motion) && body.object.pieceOf === undefined ? 0 : drift;

/**
 * How far the surface of a piece moves relative to its centre between the event of that and one that is seen with it [m]. Only the piece that exists at the event of its centre casts a shadow, on
 * the others as well, which follow and precede it.
 */
function turnDrift({ object, radius }: Body, c: number): number {
  if (object.pieceOf === undefined) return 0;
  const samples = pointSamples(object.motion);
  return samples ? (radius * relativeSpeed(samples)) / c : 0;
}

const RELATIVE_SPEEDS = new WeakMap<SampledPointsMotion, number>();

/** The largest difference of a vertex's velocity at the first samples from the mean [m/s]. */
function relativeSpeed(motion: SampledPointsMotion): number {
  const cached = RELATIVE_SPEEDS.get(motion);
  if (cached !== undefined) return cached;
  const [from, to] = [pointsAt(motion, 0), pointsAt(motion, 1)];
  const vertices = from.length / 3;
  const mean = [0, 0, 0];
  for (let i = 0; i < from.length; i++) mean[i % 3] += (to[i] - from[i]) / vertices;
  let most = 0;
  for (let i = 0; i < from.length; i += 3)
    most = Math.max(most, Math.hypot(...[0, 1, 2].map((k) => to[i + k] - from[i + k] - mean[k])));
  const speed = most / (motion.times[1] - motion.times[0]);
  RELATIVE_SPEEDS.set(motion, speed);
  return speed;
}

/** Deviation of a line from uniform motion with β, at `radius` of light before and after an event [m]. */
function driftOf(line: WorldLine, ahead: number, beta: Vec3, radius: number, { t, c }: Observation): number {
  const at = (after: number): Vec3 => positionAt(line, t + (ahead + after) / c, c);
  return Math.max(...[-radius, radius].map((after) => distance(at(after), addScaled(at(0), beta, after))));
}
