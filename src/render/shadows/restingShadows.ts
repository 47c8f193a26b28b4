import { sub, type Vec3, ZERO } from '../../math/vec3.ts';
import type { Float } from '../../shaders/types.ts';
import type { Body } from '../bodies.ts';
import type { Gpu } from '../device.ts';
import { cascadeSizes, cascades, type LitBox, litBox } from './cascades.ts';
import { makeCaster } from './casters.ts';
import { type Drawing, HeightMap } from './heightMap.ts';
import { LAYER_TEXELS, layerTexels, lightAxes, spreadOf, type Tile } from './layer.ts';
import { LayerTable } from './layerTable.ts';
import { PoseTable } from './poses.ts';
import { type Event, type LayerMaps, passingResting } from './receiver.ts';
import type { Occluders, ShadowSun } from './shadowMaps.ts';
import { sunBend, toSun } from './sunward.ts';

/** A sun's maps, one in another round the observer. */
interface Cascades {
  readonly sun: ShadowSun;
  readonly box: LitBox;
  readonly count: number;
  /** Place of the first of its layers. */
  readonly first: number;
}

export const isAlwaysThere = ({ object }: Body): boolean =>
  object.motion.kind === 'static' &&
  object.lifetime.birth === Number.NEGATIVE_INFINITY &&
  object.lifetime.death === Number.POSITIVE_INFINITY;

/** What throws shadows from where it always is: drawn anew only where the observer has gone on. */
export class RestingShadows {
  private readonly map: HeightMap;
  private readonly suns: readonly (Cascades | undefined)[];
  /** Layers of receivers, and after them those of occluders, which are measured from the middle of what rests. */
  private readonly table: LayerTable;
  private readonly poses: PoseTable;
  private readonly origin: Vec3;
  private readonly count: number;
  private readonly side: number;
  private made = '';

  constructor(occluders: Occluders, suns: readonly ShadowSun[], gpu: Gpu) {
    const { bodies, drawables, detail } = occluders;
    const resting = bodies.filter(isAlwaysThere);
    let count = 0;
    this.suns = suns.map((sun) => {
      const box = litBox(resting, lightAxes(sun.direction));
      if (!box) return undefined;
      const made = { sun, box, count: cascadeSizes(box).length, first: count };
      count += made.count;
      return made;
    });
    this.count = count;
    this.side = detail.resting[Math.max(0, suns.length - 1)];
    this.map = new HeightMap(gpu, { cell: detail.cell, bend: sunBend });
    this.table = new LayerTable(2 * count, LAYER_TEXELS);
    this.origin = this.suns[0]?.box.centre ?? ZERO;
    this.poses = new PoseTable(bodies.length);
    this.poses.setResting(resting, drawables, this.origin);
    const { map, table, side } = this;
    const placing = this.poses.placing(map.layer);
    for (const drawable of drawables)
      if (!drawable.batch.transparent && drawable.batch.bodies.some(isAlwaysThere))
        map.scene.add(makeCaster(drawable, placing, toSun(map, table, side), occluders.materials));
  }

  /** undefined where nothing rests. `sun`: its place among the suns. */
  passing(sun: number, event: Event, taps: number): Float | undefined {
    const found = this.suns[sun];
    if (!found) return undefined;
    const { map, table, side } = this;
    const maps: LayerMaps = { map, table, side, taps };
    return passingResting(maps, found.first, found.count, event);
  }

  /** Makes the maps for an observer at `position`. */
  update(position: Vec3): void {
    const { side, table, origin, count } = this;
    const order: Drawing[] = [];
    this.suns.forEach((found, row) => {
      if (!found) return;
      const { sun, box, first } = found;
      const tiles = Array.from({ length: found.count }, (_, k): Tile => ({ x: k * side, y: row * side, size: side }));
      const spread = spreadOf(sun.radius, sun.direction, sun.direction);
      cascades(box, position, { tiles, spread }).forEach((layer, k) => {
        table.set(first + k, layerTexels({ ...layer, centre: sub(layer.centre, position) }));
        table.set(count + first + k, layerTexels({ ...layer, centre: sub(layer.centre, origin) }));
        order.push({ layer: count + first + k });
      });
    });
    const key = table.keyOf(count, count);
    if (key === this.made || order.length === 0) return;
    this.made = key;
    const columns = Math.max(...this.suns.map((found) => found?.count ?? 0));
    this.map.make(columns * side, this.suns.length * side, order);
  }

  dispose(): void {
    this.map.dispose();
    this.poses.dispose();
  }
}
