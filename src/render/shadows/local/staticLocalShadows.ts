import { sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { positionAt } from '../../../physics/worldLines/worldLine.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Float, Int } from '../../../shaders/types.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { Gpu } from '../../gpu/device.ts';
import type { LightEntry } from '../../lights/lightTable.ts';
import { LayerTable } from '../atlas/layerTable.ts';
import { type AtlasDraw, ShadowAtlas } from '../atlas/shadowAtlas.ts';
import { makeCaster, wholeBatch } from '../casters/casterMesh.ts';
import { PoseTable } from '../casters/casterPoses.ts';
import type { ReceiverEvent } from '../distant/parallelReceiver.ts';
import { isAlwaysStatic } from '../distant/staticDistantShadows.ts';
import type { Occluders } from '../occluders.ts';
import { faceCountOf, lightLayer, setLightTiles } from './lightTiles.ts';
import { CELLS_PER_TILE, PERSPECTIVE_LAYER_TEXELS } from './perspectiveLayer.ts';
import { perspectiveEdgeThreshold, perspectiveProjection, type TileGrid } from './perspectiveProjection.ts';
import { type IncomingLight, surroundingsVisibility } from './perspectiveReceiver.ts';

/** Width of an atlas [texels]. */
export const ATLAS_WIDTH = 2048;

/** Shadows that bodies at rest throw in the light of lights at rest: exact, and redrawn only when other lights throw shadows. */
export class StaticLocalShadows {
  /** By slot, the light's first tile; undefined if the light moves. */
  private readonly firstTiles: readonly (number | undefined)[];
  private readonly count: number;
  private readonly atlas: ShadowAtlas;
  /** A layer of receivers for each slot, then a layer of occluders for each tile; the latter are relative to `origin`. */
  private readonly table: LayerTable;
  private readonly poses: PoseTable;
  private readonly origin: Vec3;
  private readonly tiles: TileGrid;
  private readonly radius: number;
  private renderedKey = '';

  constructor({ bodies, drawCalls, materials, detail, radius }: Occluders, lights: readonly LightEntry[], gpu: Gpu) {
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
    this.tiles = { side, columns: ATLAS_WIDTH / side };
    this.atlas = new ShadowAtlas(gpu, { cell: side / CELLS_PER_TILE, threshold: perspectiveEdgeThreshold(side) });
    this.table = new LayerTable(lights.length + count, PERSPECTIVE_LAYER_TEXELS);
    this.origin = resting[0] ? positionAt(resting[0].line, 0, 1) : ZERO;
    this.poses = new PoseTable(bodies.length);
    if (count === 0) return;
    this.poses.setStatic(resting, drawCalls, this.origin);
    const projection = perspectiveProjection(this.atlas, this.table, side);
    const placement = this.poses.placement(this.atlas.layer);
    for (const drawCall of drawCalls)
      if (!drawCall.batch.transparent && drawCall.batch.bodies.some(isAlwaysStatic))
        this.atlas.scene.add(makeCaster(wholeBatch(drawCall), placement, projection, materials));
  }

  /** Returns undefined if nothing is at rest. */
  visibility(
    slot: Int | number,
    event: ReceiverEvent,
    incoming: IncomingLight,
    sampleCount: number,
  ): Float | undefined {
    if (this.count === 0) return undefined;
    const { atlas, table, tiles } = this;
    return surroundingsVisibility({ atlas, table, tiles, sampleCount }, slot, event, incoming);
  }

  update(lights: readonly LightEntry[], observation: Observation): void {
    if (this.count === 0) return;
    const { table, tiles, firstTiles, atlas, origin, radius } = this;
    const draws: AtlasDraw[] = [];
    lights.forEach(({ light, line }, slot) => {
      const tile = firstTiles[slot];
      if (tile === undefined) return;
      const position = positionAt(line, observation.t, observation.c);
      const layer = lightLayer(light, observation.t, { c: observation.c, radius, side: tiles.side, cell: atlas.cell });
      const sources = { receivers: sub(position, observation.position), occluders: sub(position, origin) };
      const [faces, first] = [faceCountOf(light), lights.length + tile];
      setLightTiles(table, { receivers: slot, occluders: first, tile }, layer, sources, faces, tiles);
      for (let k = 0; k < faces; k++) draws.push({ layer: first + k });
    });
    const key = `${draws.map(({ layer }) => layer)} ${table.keyOf(lights.length, this.count)}`;
    if (key === this.renderedKey) return;
    this.renderedKey = key;
    const rows = Math.ceil(this.count / tiles.columns);
    atlas.render(ATLAS_WIDTH, rows * tiles.side, draws);
  }

  dispose(): void {
    this.atlas.dispose();
    this.poses.dispose();
  }
}
