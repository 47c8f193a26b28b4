import { sub, type Vec3, ZERO } from '../../math/vec3.ts';
import type { Float, Int } from '../../shaders/types.ts';
import type { Gpu } from '../device.ts';
import type { KnownLamp } from '../lampTable.ts';
import type { Sight } from '../sight.ts';
import { makeCaster } from './casters.ts';
import { type Drawing, HeightMap } from './heightMap.ts';
import { type Beam, passingRound } from './lampReceiver.ts';
import { facesOf, lampLayer, setRoom } from './lampRoom.ts';
import { LayerTable } from './layerTable.ts';
import { CELLS, POINT_TEXELS } from './pointLayer.ts';
import { pointBend, type Tiling, toPoint } from './pointward.ts';
import { PoseTable } from './poses.ts';
import type { Event } from './receiver.ts';
import { isAlwaysThere } from './restingShadows.ts';
import type { Occluders } from './shadowMaps.ts';

/** Width of a map [texels]. */
export const MAP_WIDTH = 2048;

/** What always is where it is throws these shadows of lamps that rest: exact, and drawn anew only where other lamps throw them. */
export class RestingLamps {
  /** By slot, the first of its tiles; undefined of a lamp that moves. */
  private readonly tiles: readonly (number | undefined)[];
  private readonly count: number;
  private readonly map: HeightMap;
  /** A layer of receivers for each slot, then one of occluders for each tile: these are measured from a place in the world. */
  private readonly table: LayerTable;
  private readonly poses: PoseTable;
  private readonly origin: Vec3;
  private readonly tiling: Tiling;
  private readonly radius: number;
  private made = '';

  constructor({ bodies, drawables, materials, detail, radius }: Occluders, lamps: readonly KnownLamp[], gpu: Gpu) {
    const resting = bodies.filter(isAlwaysThere);
    let count = 0;
    this.tiles = lamps.map(({ lamp }) => {
      if (lamp.motion.kind !== 'static' || resting.length === 0) return undefined;
      count += 6;
      return count - 6;
    });
    this.count = count;
    this.radius = radius;
    const side = detail.lampTiles[count > 24 ? 1 : 0];
    this.tiling = { side, columns: MAP_WIDTH / side };
    this.map = new HeightMap(gpu, { cell: side / CELLS, bend: pointBend(side) });
    this.table = new LayerTable(lamps.length + count, POINT_TEXELS);
    this.origin = resting[0]?.line.kind === 'static' ? resting[0].line.position : ZERO;
    this.poses = new PoseTable(bodies.length);
    if (count === 0) return;
    this.poses.setResting(resting, drawables, this.origin);
    const projecting = toPoint(this.map, this.table, side);
    const placing = this.poses.placing(this.map.layer);
    for (const drawable of drawables)
      if (!drawable.batch.transparent && drawable.batch.bodies.some(isAlwaysThere))
        this.map.scene.add(makeCaster(drawable, placing, projecting, materials));
  }

  /** undefined where nothing rests. */
  passing(slot: Int | number, event: Event, beam: Beam, taps: number): Float | undefined {
    if (this.count === 0) return undefined;
    const { map, table, tiling } = this;
    return passingRound({ map, table, tiling, taps }, slot, event, beam);
  }

  update(lamps: readonly KnownLamp[], sight: Sight): void {
    if (this.count === 0) return;
    const { table, tiling, tiles, map, origin, radius } = this;
    const drawings: Drawing[] = [];
    lamps.forEach(({ lamp, line }, slot) => {
      const tile = tiles[slot];
      if (tile === undefined || line.kind !== 'static') return;
      const layer = lampLayer(lamp, sight.t, { c: sight.c, radius, side: tiling.side, cell: map.cell });
      const sources = { receivers: sub(line.position, sight.position), occluders: sub(line.position, origin) };
      const [faces, first] = [facesOf(lamp), lamps.length + tile];
      setRoom(table, { receivers: slot, occluders: first, tile }, layer, sources, faces, tiling);
      for (let k = 0; k < faces; k++) drawings.push({ layer: first + k });
    });
    const key = `${drawings.map(({ layer }) => layer)} ${table.keyOf(lamps.length, this.count)}`;
    if (key === this.made) return;
    this.made = key;
    const rows = Math.ceil(this.count / tiling.columns);
    map.make(MAP_WIDTH, rows * tiling.side, drawings);
  }

  dispose(): void {
    this.map.dispose();
    this.poses.dispose();
  }
}
