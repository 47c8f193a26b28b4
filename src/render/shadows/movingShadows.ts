import type { Vec3 } from '../../math/vec3.ts';
import { addScaled, dot, ZERO } from '../../math/vec3.ts';
import { velocity } from '../../physics/boost.ts';
import type { Float } from '../../shaders/types.ts';
import type { Body } from '../bodies.ts';
import type { Gpu } from '../device.ts';
import type { Sight } from '../sight.ts';
import { HeightMap } from './heightMap.ts';
import { LAYER_TEXELS, type Layer, layerTexels, lightAxes, spreadOf, type Tile, wayToSun } from './layer.ts';
import { LayerTable } from './layerTable.ts';
import { centreOf, largest, lift, type Mover, MovingBodies } from './movingBodies.ts';
import { type Event, type LayerMaps, passingMoving } from './receiver.ts';
import { isAlwaysThere } from './restingShadows.ts';
import type { Occluders, ShadowSun } from './shadowMaps.ts';
import { sunBend, toSun } from './sunward.ts';

const TILES_A_ROW = 4;

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
  private readonly moving: MovingBodies;
  private made = '';

  constructor(occluders: Occluders, suns: readonly ShadowSun[], gpu: Gpu) {
    const { bodies, detail } = occluders;
    this.suns = suns;
    this.bodies = bodies.filter((body) => !isAlwaysThere(body));
    this.most = Math.min(detail.movers, this.bodies.length);
    this.side = detail.moving;
    this.map = new HeightMap(gpu, { cell: detail.cell, bend: sunBend });
    this.table = new LayerTable(2 * suns.length * this.most, LAYER_TEXELS);
    this.moving = new MovingBodies(occluders);
    this.moving.drawInto(this.map, new Set(this.bodies), toSun(this.map, this.table, this.side));
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
    this.setLayers(movers, sight);
    const shapes = this.moving.place(movers, sight);
    if (!this.moving.isComplete) return false;
    const { suns, most, side } = this;
    const key = `${shapes} ${this.table.keyOf(suns.length * most, suns.length * most)}`;
    if (key === this.made || movers.length === 0) return true;
    this.made = key;
    this.moving.showOnly(new Set(movers.map(({ body }) => body)));
    const drawings = suns.map((_, sun) => ({ layer: (suns.length + sun) * most }));
    this.map.make(TILES_A_ROW * side, suns.length * this.rows * side, drawings);
    return true;
  }

  /** Whether all samples that the last maps need are on the GPU. */
  get isComplete(): boolean {
    return this.moving.isComplete;
  }

  dispose(): void {
    this.map.dispose();
    this.moving.dispose();
  }

  private setLayers(movers: readonly Mover[], sight: Sight): void {
    const { table, suns, most } = this;
    for (let layer = 0; layer < 2 * suns.length * most; layer++) table.clear(layer);
    for (const [slot, mover] of movers.entries())
      suns.forEach((sun, row) => {
        const layer = layerOf(mover, sun, sight, this.tile(slot, row));
        const centre = addScaled(centreOf(mover), layer.axes.towards, -lift(mover));
        table.set(row * most + slot, layerTexels({ ...layer, centre }));
        table.set((suns.length + row) * most + slot, layerTexels({ ...layer, beta: ZERO }));
      });
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

function layerOf(
  { body, beta, drift }: Mover,
  { direction, radius: sunRadius }: ShadowSun,
  sight: Sight,
  tile: Tile,
): Layer {
  const way = wayToSun(direction, beta, timePerMetre(sight, direction));
  const spread = spreadOf(sunRadius, direction, way);
  const half = body.radius + drift;
  return { axes: lightAxes(way), beta, centre: ZERO, half, depth: 1.01 * half, spread, tile };
}

/** How time goes on along a ray to the sun: into the past, or in the one moment that is looked at. */
const timePerMetre = ({ surface, u }: Sight, direction: Vec3): number =>
  surface === 'past-light-cone' ? -1 : surface === 'slice' ? dot(velocity(u), direction) : 0;
