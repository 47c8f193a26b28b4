import type { Vec3 } from '../../../math/vec3.ts';
import { addScaled, dot, ZERO } from '../../../math/vec3.ts';
import { lightSurfaceOf } from '../../../physics/worldLines/hypersurface.ts';
import type { Float } from '../../../shaders/types.ts';
import { type Body, isSolvedPerVertex } from '../../geometry/bodies.ts';
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
 * Shadows of moving bodies: each body has tiles of its own, in coordinates that move with it, and is drawn as it is at the event of its centre. Tiles are
 * redrawn only when that changes; it does not for bodies at constant velocity.
 */
export class DynamicDistantShadows {
  private readonly atlas: ShadowAtlas;
  private readonly lights: readonly ShadowedDistantLight[];
  private readonly bodies: readonly Body[];
  private readonly maxCasters: number;
  private readonly side: number;
  /** For each light the layers of receivers; then for each light those of occluders, which are relative to the body's centre. */
  private readonly table: LayerTable;
  private readonly casters: MovingCasters;
  private renderedKey = '';

  constructor(occluders: Occluders, lights: readonly ShadowedDistantLight[], gpu: Gpu) {
    const { bodies, detail } = occluders;
    this.lights = lights;
    this.bodies = bodies.filter((body) => !isAlwaysStatic(body));
    this.maxCasters = Math.min(detail.maxCasters, this.bodies.length);
    this.side = detail.dynamicTile;
    this.atlas = new ShadowAtlas(gpu, { cell: detail.cell, threshold: parallelEdgeThreshold });
    this.table = new LayerTable(2 * lights.length * this.maxCasters, PARALLEL_LAYER_TEXELS);
    this.casters = new MovingCasters(occluders, gpu);
    this.casters.addTo(this.atlas, new Set(this.bodies), parallelProjection(this.atlas, this.table, this.side));
  }

  /** Returns undefined if nothing moves. `index`: of the light. */
  visibility(index: number, event: ReceiverEvent, sampleCount: number): Float | undefined {
    if (this.maxCasters === 0) return undefined;
    const { atlas, table, side } = this;
    const maps: ParallelMaps = { atlas, table, side, sampleCount };
    return castersVisibility(maps, index * this.maxCasters, this.maxCasters, event);
  }

  /** Updates the maps for a picture. Returns false if samples of a deforming mesh are not loaded yet. */
  update(observation: Observation): boolean {
    const movers = largestCasters(this.bodies, observation).slice(0, this.maxCasters);
    this.setLayers(movers, observation);
    const shapes = this.casters.update(movers, observation);
    if (!this.casters.isComplete) return false;
    const { lights, maxCasters, side } = this;
    const key = `${shapes} ${this.table.keyOf(lights.length * maxCasters, lights.length * maxCasters)}`;
    if (key === this.renderedKey || movers.length === 0) return true;
    this.renderedKey = key;
    this.casters.showOnly(new Set(movers.map(({ body }) => body)));
    const draws = lights.map((_, index) => ({ layer: (lights.length + index) * maxCasters }));
    this.atlas.render(TILES_PER_ROW * side, lights.length * this.rows * side, draws);
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

  private setLayers(movers: readonly ObservedCaster[], observation: Observation): void {
    const { table, lights, maxCasters } = this;
    for (let layer = 0; layer < 2 * lights.length * maxCasters; layer++) table.clear(layer);
    for (const [slot, mover] of movers.entries())
      lights.forEach((light, row) => {
        const layer = layerOf(mover, light, observation, this.tile(slot, row));
        const center = addScaled(comovingCenter(mover), layer.axes.toLight, -driftBias(mover));
        table.set(row * maxCasters + slot, parallelLayerTexels({ ...layer, center }));
        table.set((lights.length + row) * maxCasters + slot, parallelLayerTexels({ ...layer, beta: ZERO }));
      });
  }

  private get rows(): number {
    return Math.ceil(this.maxCasters / TILES_PER_ROW);
  }

  private tile(slot: number, index: number): AtlasTile {
    const { side, rows } = this;
    return {
      x: (slot % TILES_PER_ROW) * side,
      y: (index * rows + Math.floor(slot / TILES_PER_ROW)) * side,
      size: side,
    };
  }
}

function layerOf(
  { body, beta, drift }: ObservedCaster,
  { direction, radius: sunRadius }: ShadowedDistantLight,
  observation: Observation,
  tile: AtlasTile,
): ParallelLayer {
  const path = comovingPathToLight(direction, beta, timePerMeter(observation, direction));
  const penumbraSlope = penumbraSlopeOf(sunRadius, direction, path);
  const halfSide = body.radius + drift;
  return {
    axes: lightAxes(path),
    beta,
    center: ZERO,
    halfSide,
    halfDepth: 1.01 * halfSide,
    penumbraSlope,
    tile,
    asSeen: isSolvedPerVertex(body.object.motion),
  };
}

/** Change of time per metre along the ray to the light [m of light]: into the past, or within the slice of simultaneity. */
function timePerMeter(observation: Observation, direction: Vec3): number {
  const { linear, radial } = lightSurfaceOf(observation).timeGradient(observation.u);
  return dot(linear, direction) + radial;
}
