import { int } from 'three/tsl';
import type { Mesh } from 'three/webgpu';
import { length, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { velocityAt } from '../../physics/worldLine.ts';
import type { Int } from '../../shaders/types.ts';
import { type Body, lineOfCentre } from '../bodies.ts';
import type { Drawable } from '../drawable.ts';
import { FloatTable } from '../floatTable.ts';
import { Frame, type FrameTables, OBJECT_TEXELS } from '../frame.ts';
import { meet, type RelativeEvent, type Sight } from '../sight.ts';
import { shownPoint } from '../vertexStage.ts';
import { makeCaster, type Placing, type Projecting } from './casters.ts';
import type { HeightMap } from './heightMap.ts';
import { PoseTable, ROUND, turnOf } from './poses.ts';
import type { Occluders } from './shadowMaps.ts';

/** Smaller ones throw no shadow: radius over distance. */
const LEAST_SIZE = 0.01;
/** Everywhere may be seen. */
const ALL_ROUND = { sides: [], boosted: false };

/** A body with the event of its centre that is seen, and its velocity there [c]. */
export interface Mover extends RelativeEvent {
  readonly body: Body;
  readonly beta: Vec3;
}

/** Occluders that have tiles of their own, in coordinates that move with them: as they are at the events of their centres, from which they are measured. */
export class MovingBodies {
  private readonly occluders: Occluders;
  private readonly poses: PoseTable;
  private readonly frame: Frame;
  private readonly tables: FrameTables;
  private readonly worn: ReadonlySet<Body>;
  private readonly casters: { readonly mesh: Mesh; readonly bodies: readonly Body[] }[] = [];

  constructor(occluders: Occluders) {
    const { bodies, drawables, points } = occluders;
    this.occluders = occluders;
    this.poses = new PoseTable(bodies.length);
    this.tables = { objects: new FloatTable(256), samples: new FloatTable(1024), points };
    this.tables.objects.reserve(bodies.length * OBJECT_TEXELS);
    this.frame = new Frame(this.tables);
    this.worn = new Set(drawables.flatMap(({ batch }) => (batch.worn ? batch.bodies : [])));
  }

  /** Whether all samples that they need are on the GPU. */
  get isComplete(): boolean {
    return this.frame.isComplete;
  }

  /** Has them drawn into a map; `round`: 1 while what is drawn is measured from elsewhere. */
  drawInto(map: HeightMap, bodies: ReadonlySet<Body>, projecting: Projecting, round?: Int): void {
    const { drawables, materials } = this.occluders;
    for (const drawable of drawables) {
      const own = drawable.batch.bodies.filter((body) => bodies.has(body));
      if (drawable.batch.transparent || own.length === 0) continue;
      const mesh = makeCaster(drawable, this.placing(drawable, map.layer, round), projecting, materials);
      map.scene.add(mesh);
      this.casters.push({ mesh, bodies: own });
    }
  }

  /** From now on what none of these needs is not drawn. */
  showOnly(bodies: ReadonlySet<Body>): void {
    for (const caster of this.casters) caster.mesh.visible = caster.bodies.some((body) => bodies.has(body));
  }

  /** As of `PoseTable`: rigid bodies by their turn, in the slot of each from layer `first` on; what deforms by its samples, from the event of its centre. */
  private placing({ batch, vertex }: Drawable, first: Int, round?: Int): Placing {
    const rigid = this.poses.placing(first, round);
    if (batch.kind !== 'sampled-points' && batch.kind !== 'hyperbolic') return rigid;
    const { objects, samples } = this.tables;
    return (input) => ({
      ...rigid(input),
      x: () => {
        const { shown } = shownPoint({ ...vertex, objects, samples }, { event: 'now', place: 'plain' }, input);
        return shown.sub(objects.texel(int(input.object).mul(int(OBJECT_TEXELS))).xyz);
      },
    });
  }

  /** Places them, each in the slot of its number, and `round` them what rests, measured from elsewhere; what is drawn depends on what it tells. */
  place(
    movers: readonly Mover[],
    sight: Sight,
    round?: { readonly bodies: readonly Body[]; readonly from: Vec3 },
  ): string {
    this.poses.clear();
    const deforming: Body[] = [];
    const shapes = movers.map(({ body, ahead }, slot) => {
      const t = sight.t + ahead / sight.c;
      const turn = turnOf(body, this.worn.has(body), t, sight.c);
      if (!turn) deforming.push(body);
      this.poses.set(body, turn ?? [ZERO, ZERO, ZERO], ZERO, slot);
      return `${body.id} ${turn ?? t}`;
    });
    for (const body of round?.bodies ?? []) {
      const turn = turnOf(body, this.worn.has(body), sight.t, sight.c);
      if (turn && round && body.line.kind === 'static')
        this.poses.set(body, turn, sub(body.line.position, round.from), ROUND);
    }
    this.poses.upload();
    this.frame.fill(deforming, sight, ALL_ROUND, false);
    return shapes.join();
  }

  dispose(): void {
    this.poses.dispose();
    this.tables.objects.dispose();
    this.tables.samples.dispose();
  }
}

/** The bodies that are there at all, from the one that looks largest on. */
export function largest(bodies: readonly Body[], sight: Sight): readonly Mover[] {
  return bodies
    .flatMap((body) => {
      const line = lineOfCentre(body, sight.c);
      const event = meet(line, sight);
      const { birth, death } = body.object.lifetime;
      if (!event || !(sight.c * (birth - sight.t) <= event.ahead && event.ahead <= sight.c * (death - sight.t)))
        return [];
      const size = body.radius / Math.max(length(event.offset) - body.radius, 1e-3 * body.radius);
      if (!(size > LEAST_SIZE)) return [];
      const beta = scale(velocityAt(line, sight.t + event.ahead / sight.c, sight.c), 1 / sight.c);
      return [{ body, ...event, beta, size }];
    })
    .sort((a, b) => b.size - a.size || a.body.id - b.body.id);
}
