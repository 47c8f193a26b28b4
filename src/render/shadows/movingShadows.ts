import { int } from 'three/tsl';
import type { Mesh } from 'three/webgpu';
import { addScaled, dot, length, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import { velocity } from '../../physics/boost.ts';
import { velocityAt } from '../../physics/worldLine.ts';
import type { Float } from '../../shaders/types.ts';
import { type Body, lineOfCentre } from '../bodies.ts';
import type { Gpu } from '../device.ts';
import type { Drawable } from '../drawable.ts';
import { FloatTable } from '../floatTable.ts';
import { Frame, type FrameTables, OBJECT_TEXELS } from '../frame.ts';
import { meet, type RelativeEvent, type Sight } from '../sight.ts';
import { shownPoint } from '../vertexStage.ts';
import { makeCaster, type Placing } from './casters.ts';
import { HeightMap } from './heightMap.ts';
import { type Layer, lightAxes, spreadOf, type Tile, wayToSun } from './layer.ts';
import { LayerTable } from './layerTable.ts';
import { PoseTable, turnOf } from './poses.ts';
import { type Event, type LayerMaps, passingMoving } from './receiver.ts';
import { isAlwaysThere } from './restingShadows.ts';
import type { Occluders, ShadowSun } from './shadowMaps.ts';

const TILES_A_ROW = 4;
/** Smaller ones throw no shadow: radius over distance. */
const LEAST_SIZE = 0.01;
/** Everywhere may be seen. */
const ALL_ROUND = { sides: [], boosted: false };

interface Mover extends RelativeEvent {
  readonly body: Body;
}

/**
 * What throws shadows as it goes: each body on its own tiles, in coordinates that move with it, as it is at the event of its centre. What does not
 * change there, as bodies at constant velocity do not, is not drawn anew.
 */
export class MovingShadows {
  private readonly map: HeightMap;
  private readonly suns: readonly ShadowSun[];
  private readonly bodies: readonly Body[];
  private readonly most: number;
  private readonly side: number;
  /** Of each sun the layers of receivers, then of each those of occluders, which are measured from the body's centre. */
  private readonly table: LayerTable;
  private readonly poses: PoseTable;
  private readonly frame: Frame;
  private readonly tables: FrameTables;
  private readonly worn: ReadonlySet<Body>;
  private readonly casters: { readonly mesh: Mesh; readonly bodies: readonly Body[] }[] = [];
  private made = '';

  constructor(occluders: Occluders, suns: readonly ShadowSun[], gpu: Gpu) {
    const { bodies, drawables, detail, materials } = occluders;
    this.suns = suns;
    this.bodies = bodies.filter((body) => !isAlwaysThere(body));
    this.most = Math.min(detail.movers, this.bodies.length);
    this.side = detail.moving;
    this.map = new HeightMap(gpu, detail.cell);
    this.table = new LayerTable(2 * suns.length * this.most);
    this.poses = new PoseTable(bodies.length);
    this.tables = { objects: new FloatTable(256), samples: new FloatTable(1024), points: occluders.points };
    this.tables.objects.reserve(bodies.length * OBJECT_TEXELS);
    this.frame = new Frame(this.tables);
    this.worn = new Set(drawables.flatMap(({ batch }) => (batch.worn ? batch.bodies : [])));
    const { map, table, side } = this;
    for (const drawable of drawables) {
      const moving = drawable.batch.bodies.filter((body) => !isAlwaysThere(body));
      if (drawable.batch.transparent || moving.length === 0) continue;
      const mesh = makeCaster(drawable, this.placing(drawable), { map, table, side }, materials);
      map.scene.add(mesh);
      this.casters.push({ mesh, bodies: moving });
    }
  }

  /** undefined where nothing moves. `sun`: its place among the suns. */
  passing(sun: number, event: Event, taps: number): Float | undefined {
    if (this.most === 0) return undefined;
    const { map, table, side } = this;
    const maps: LayerMaps = { map, table, side, taps };
    return passingMoving(maps, sun * this.most, this.most, event);
  }

  /** Makes the maps that a picture needs; false where samples of a deforming mesh have still to come. */
  update(sight: Sight): boolean {
    const movers = largest(this.bodies, sight).slice(0, this.most);
    const shapes = this.place(movers, sight);
    if (!this.frame.isComplete) return false;
    const key = `${shapes} ${this.table.keyOf(this.suns.length * this.most)}`;
    if (key === this.made || movers.length === 0) return true;
    this.made = key;
    const shown = new Set(movers.map(({ body }) => body));
    for (const { mesh, bodies } of this.casters) mesh.visible = bodies.some((body) => shown.has(body));
    const { suns, most, side } = this;
    const firsts = suns.map((_, sun) => (suns.length + sun) * most);
    this.map.make(TILES_A_ROW * side, suns.length * this.rows * side, firsts);
    return true;
  }

  /** Whether all samples that the last maps need are on the GPU. */
  get isComplete(): boolean {
    return this.frame.isComplete;
  }

  dispose(): void {
    this.map.dispose();
    this.poses.dispose();
    this.tables.objects.dispose();
    this.tables.samples.dispose();
  }

  /** Rigid bodies by their turn; what deforms by its samples, from the event of its centre. */
  private placing({ batch, vertex }: Drawable): Placing {
    const rigid = this.poses.placing(this.map.at.layer);
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

  /** Fills the tables; what is drawn depends on what it tells, and on the layers of occluders. */
  private place(movers: readonly Mover[], sight: Sight): string {
    const { poses, table, suns, most } = this;
    poses.clear();
    for (let layer = 0; layer < 2 * suns.length * most; layer++) table.clear(layer);
    const deforming: Body[] = [];
    const shapes = movers.map(({ body, offset, ahead }, slot) => {
      const t = sight.t + ahead / sight.c;
      const turn = turnOf(body, this.worn.has(body), t, sight.c);
      if (!turn) deforming.push(body);
      poses.set(body, turn ?? [ZERO, ZERO, ZERO], ZERO, slot);
      const beta = scale(velocityAt(lineOfCentre(body, sight.c), t, sight.c), 1 / sight.c);
      suns.forEach((sun, row) => {
        const layer = this.layerOf(body, beta, sun, sight, this.tile(slot, row));
        table.set(row * most + slot, { ...layer, centre: addScaled(offset, beta, -ahead) });
        table.set((suns.length + row) * most + slot, { ...layer, beta: ZERO });
      });
      return `${body.id} ${turn ?? t}`;
    });
    poses.upload();
    this.frame.fill(deforming, sight, ALL_ROUND, false);
    return shapes.join();
  }

  private layerOf(
    { radius }: Body,
    beta: Vec3,
    { direction, radius: sunRadius }: ShadowSun,
    sight: Sight,
    tile: Tile,
  ): Layer {
    const way = wayToSun(direction, beta, timePerMetre(sight, direction));
    const spread = spreadOf(sunRadius, direction, way);
    return { axes: lightAxes(way), beta, centre: ZERO, half: radius, depth: 1.01 * radius, spread, tile };
  }

  private get rows(): number {
    return Math.ceil(this.most / TILES_A_ROW);
  }

  private tile(slot: number, sun: number): Tile {
    const { side, rows } = this;
    return {
      x: (slot % TILES_A_ROW) * side,
      y: (sun * rows + Math.floor(slot / TILES_A_ROW)) * side,
      size: side,
    };
  }
}

/** How time goes on along a ray to the sun: into the past, or in the one moment that is looked at. */
const timePerMetre = ({ surface, u }: Sight, direction: Vec3): number =>
  surface === 'past-light-cone' ? -1 : surface === 'slice' ? dot(velocity(u), direction) : 0;

/** The moving bodies that are there at all, with the events of their centres, from the largest on. */
function largest(bodies: readonly Body[], sight: Sight): readonly Mover[] {
  return bodies
    .flatMap((body) => {
      const event = meet(lineOfCentre(body, sight.c), sight);
      const { birth, death } = body.object.lifetime;
      if (!event || !(sight.c * (birth - sight.t) <= event.ahead && event.ahead <= sight.c * (death - sight.t)))
        return [];
      const size = body.radius / Math.max(length(event.offset) - body.radius, 1e-3 * body.radius);
      return size > LEAST_SIZE ? [{ body, ...event, size }] : [];
    })
    .sort((a, b) => b.size - a.size || a.body.id - b.body.id);
}
