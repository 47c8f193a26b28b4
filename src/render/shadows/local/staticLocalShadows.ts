import { sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { positionAt } from '../../../physics/worldLines/worldLine.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Float, Int } from '../../../shaders/types.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { Gpu } from '../../gpu/device.ts';
import type { LightEntry } from '../../lights/lightTable.ts';
import { LayerTable } from '../atlas/layerTable.ts';
import { type AtlasDraw, ShadowAtlas } from '../atlas/shadowAtlas.ts';
import { makeCaster } from '../casters/casterMesh.ts';
import { PoseTable } from '../casters/casterPoses.ts';
import type { ReceiverEvent } from '../distant/parallelReceiver.ts';
import { isAlwaysStatic } from '../distant/staticDistantShadows.ts';
import type { Occluders } from '../occluders.ts';
import { faceCountOf, lightLayer, setLightTiles } from './lightTiles.ts';
import { CELLS_PER_TILE, PERSPECTIVE_LAYER_TEXELS } from './perspectiveLayer.ts';
import { perspectiveEdgeThreshold, perspectiveProjection, type TileGrid } from './perspectiveProjection.ts';
import { type IncomingLight, surroundingsVisibility } from './perspectiveReceiver.ts';

/** Width of a map [texels]. */
export const ATLAS_WIDTH = 2048;

/** What always is where it is throws these shadows of lights that rest: exact, and drawn anew only where other lights throw them. */
export class StaticLocalShadows {
  /** By slot, the first of its tiles; undefined of a light that moves. */
  private readonly firstTiles: readonly (number | undefined)[];
  private readonly count: number;
  private readonly atlas: ShadowAtlas;
  /** A layer of receivers for each slot, then one of occluders for each tile: these are measured from a place in the world. */
  private readonly table: LayerTable;
  private readonly poses: PoseTable;
  private readonly origin: Vec3;
  private readonly tiling: TileGrid;
  private readonly radius: number;
  private renderedKey = '';

  constructor({ bodies, drawables, materials, detail, radius }: Occluders, lights: readonly LightEntry[], gpu: Gpu) {
    const resting = bodies.filter(isAlwaysStatic);
    let count = 0;
    this.firstTiles = lights.map(({ light }) => {
      if (!isStatic(light.motion) || resting.length === 0) return undefined;
      count += 6;
      return count - 6;
    });
    this.count = count;
    this.radius = radius;
    const side = detail.localTiles[count > 24 ? 1 : 0];
    this.tiling = { side, columns: ATLAS_WIDTH / side };
    this.atlas = new ShadowAtlas(gpu, { cell: side / CELLS_PER_TILE, threshold: perspectiveEdgeThreshold(side) });
    this.table = new LayerTable(lights.length + count, PERSPECTIVE_LAYER_TEXELS);
    this.origin = resting[0] ? positionAt(resting[0].line, 0, 1) : ZERO;
    this.poses = new PoseTable(bodies.length);
    if (count === 0) return;
    this.poses.setStatic(resting, drawables, this.origin);
    const projecting = perspectiveProjection(this.atlas, this.table, side);
    const placing = this.poses.placement(this.atlas.layer);
    for (const drawable of drawables)
      if (!drawable.batch.transparent && drawable.batch.bodies.some(isAlwaysStatic))
        this.atlas.scene.add(makeCaster(drawable, placing, projecting, materials));
  }

  /** undefined where nothing rests. */
  visibility(slot: Int | number, event: ReceiverEvent, beam: IncomingLight, taps: number): Float | undefined {
    if (this.count === 0) return undefined;
    const { atlas, table, tiling } = this;
    return surroundingsVisibility({ atlas, table, tiles: tiling, sampleCount: taps }, slot, event, beam);
  }

  update(lights: readonly LightEntry[], sight: Observation): void {
    if (this.count === 0) return;
    const { table, tiling, firstTiles, atlas, origin, radius } = this;
    const drawings: AtlasDraw[] = [];
    lights.forEach(({ light, line }, slot) => {
      const tile = firstTiles[slot];
      if (tile === undefined) return;
      const position = positionAt(line, sight.t, sight.c);
      const layer = lightLayer(light, sight.t, { c: sight.c, radius, side: tiling.side, cell: atlas.cell });
      const sources = { receivers: sub(position, sight.position), occluders: sub(position, origin) };
      const [faces, first] = [faceCountOf(light), lights.length + tile];
      setLightTiles(table, { receivers: slot, occluders: first, tile }, layer, sources, faces, tiling);
      for (let k = 0; k < faces; k++) drawings.push({ layer: first + k });
    });
    const key = `${drawings.map(({ layer }) => layer)} ${table.keyOf(lights.length, this.count)}`;
    if (key === this.renderedKey) return;
    this.renderedKey = key;
    const rows = Math.ceil(this.count / tiling.columns);
    atlas.render(ATLAS_WIDTH, rows * tiling.side, drawings);
  }

  dispose(): void {
    this.atlas.dispose();
    this.poses.dispose();
  }
}
