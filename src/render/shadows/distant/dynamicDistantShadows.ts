import type { Vec3 } from '../../../math/vec3.ts';
import { addScaled, dot, ZERO } from '../../../math/vec3.ts';
import { HYPERSURFACES } from '../../../physics/worldLines/hypersurface.ts';
import type { Float } from '../../../shaders/types.ts';
import type { Body } from '../../geometry/bodies.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { Gpu } from '../../gpu/device.ts';
import { LayerTable } from '../atlas/layerTable.ts';
import { ShadowAtlas } from '../atlas/shadowAtlas.ts';
import {
  comovingCenter,
  driftBias,
  largestCasters,
  MovingCasters,
  type ObservedCaster,
} from '../casters/movingCasters.ts';
import type { Occluders, ShadowedDistantLight } from '../occluders.ts';
import {
  type AtlasTile,
  comovingPathToLight,
  lightAxes,
  PARALLEL_LAYER_TEXELS,
  type ParallelLayer,
  parallelLayerTexels,
  penumbraSlopeOf,
} from './parallelLayer.ts';
import { parallelEdgeThreshold, parallelProjection } from './parallelProjection.ts';
import { castersVisibility, type ParallelMaps, type ReceiverEvent } from './parallelReceiver.ts';
import { isAlwaysStatic } from './staticDistantShadows.ts';

const TILES_PER_ROW = 4;

/**
 * What throws shadows as it goes: each body on its own tiles, in coordinates that move with it, as it is at the event of its centre. What does not
 * change there, as bodies at constant velocity do not, is not drawn anew.
 */
export class DynamicDistantShadows {
  private readonly atlas: ShadowAtlas;
  private readonly lights: readonly ShadowedDistantLight[];
  private readonly bodies: readonly Body[];
  private readonly maxCasters: number;
  private readonly side: number;
  /** Of each sun the layers of receivers, then of each those of occluders, which are measured from the body's centre. */
  private readonly table: LayerTable;
  private readonly casters: MovingCasters;
  private renderedKey = '';

  constructor(occluders: Occluders, suns: readonly ShadowedDistantLight[], gpu: Gpu) {
    const { bodies, detail } = occluders;
    this.lights = suns;
    this.bodies = bodies.filter((body) => !isAlwaysStatic(body));
    this.maxCasters = Math.min(detail.maxCasters, this.bodies.length);
    this.side = detail.dynamicTile;
    this.atlas = new ShadowAtlas(gpu, { cell: detail.cell, threshold: parallelEdgeThreshold });
    this.table = new LayerTable(2 * suns.length * this.maxCasters, PARALLEL_LAYER_TEXELS);
    this.casters = new MovingCasters(occluders);
    this.casters.addTo(this.atlas, new Set(this.bodies), parallelProjection(this.atlas, this.table, this.side));
  }

  /** undefined where nothing moves. `sun`: its place among the suns. */
  visibility(sun: number, event: ReceiverEvent, taps: number): Float | undefined {
    if (this.maxCasters === 0) return undefined;
    const { atlas, table, side } = this;
    const maps: ParallelMaps = { atlas, table, side, sampleCount: taps };
    return castersVisibility(maps, sun * this.maxCasters, this.maxCasters, event);
  }

  /** Makes the maps that a picture needs; false where samples of a deforming mesh have still to come. */
  update(sight: Observation): boolean {
    const movers = largestCasters(this.bodies, sight).slice(0, this.maxCasters);
    this.setLayers(movers, sight);
    const shapes = this.casters.update(movers, sight);
    if (!this.casters.isComplete) return false;
    const { lights: suns, maxCasters: most, side } = this;
    const key = `${shapes} ${this.table.keyOf(suns.length * most, suns.length * most)}`;
    if (key === this.renderedKey || movers.length === 0) return true;
    this.renderedKey = key;
    this.casters.showOnly(new Set(movers.map(({ body }) => body)));
    const drawings = suns.map((_, sun) => ({ layer: (suns.length + sun) * most }));
    this.atlas.render(TILES_PER_ROW * side, suns.length * this.rows * side, drawings);
    return true;
  }

  /** Whether all samples that the last maps need are on the GPU. */
  get isComplete(): boolean {
    return this.casters.isComplete;
  }

  dispose(): void {
    this.atlas.dispose();
    this.casters.dispose();
  }

  private setLayers(movers: readonly ObservedCaster[], sight: Observation): void {
    const { table, lights: suns, maxCasters: most } = this;
    for (let layer = 0; layer < 2 * suns.length * most; layer++) table.clear(layer);
    for (const [slot, mover] of movers.entries())
      suns.forEach((sun, row) => {
        const layer = layerOf(mover, sun, sight, this.tile(slot, row));
        const center = addScaled(comovingCenter(mover), layer.axes.toLight, -driftBias(mover));
        table.set(row * most + slot, parallelLayerTexels({ ...layer, center }));
        table.set((suns.length + row) * most + slot, parallelLayerTexels({ ...layer, beta: ZERO }));
      });
  }

  private get rows(): number {
    return Math.ceil(this.maxCasters / TILES_PER_ROW);
  }

  private tile(slot: number, sun: number): AtlasTile {
    const { side, rows } = this;
    return {
      x: (slot % TILES_PER_ROW) * side,
      y: (sun * rows + Math.floor(slot / TILES_PER_ROW)) * side,
      size: side,
    };
  }
}

function layerOf(
  { body, beta, drift }: ObservedCaster,
  { direction, radius: sunRadius }: ShadowedDistantLight,
  sight: Observation,
  tile: AtlasTile,
): ParallelLayer {
  const way = comovingPathToLight(direction, beta, timePerMeter(sight, direction));
  const spread = penumbraSlopeOf(sunRadius, direction, way);
  const half = body.radius + drift;
  return {
    axes: lightAxes(way),
    beta,
    center: ZERO,
    halfSide: half,
    halfDepth: 1.01 * half,
    penumbraSlope: spread,
    tile,
  };
}

/** How time goes on along a ray to the sun: into the past, or in the one moment that is looked at. */
function timePerMeter({ hypersurface, u }: Observation, direction: Vec3): number {
  const { linear, radial } = HYPERSURFACES[hypersurface].timeGradient(u);
  return dot(linear, direction) + radial;
}
