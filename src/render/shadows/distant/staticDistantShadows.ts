import { sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Float } from '../../../shaders/types.ts';
import type { Body } from '../../geometry/bodies.ts';
import type { Gpu } from '../../gpu/device.ts';
import { LayerTable } from '../atlas/layerTable.ts';
import { type AtlasDraw, ShadowAtlas } from '../atlas/shadowAtlas.ts';
import { makeCaster } from '../casters/casterMesh.ts';
import { PoseTable } from '../casters/casterPoses.ts';
import type { Occluders, ShadowedDistantLight } from '../occluders.ts';
import { cascadeSizes, cascades, type LightSpaceBox, lightSpaceBox } from './cascades.ts';
import {
  type AtlasTile,
  lightAxes,
  PARALLEL_LAYER_TEXELS,
  parallelLayerTexels,
  penumbraSlopeOf,
} from './parallelLayer.ts';
import { parallelEdgeThreshold, parallelProjection } from './parallelProjection.ts';
import { cascadeVisibility, type ParallelMaps, type ReceiverEvent } from './parallelReceiver.ts';

/** A sun's maps, one in another round the observer. */
interface LightCascades {
  readonly light: ShadowedDistantLight;
  readonly box: LightSpaceBox;
  readonly count: number;
  /** Place of the first of its layers. */
  readonly first: number;
}

export const isAlwaysStatic = ({ object }: Body): boolean =>
  isStatic(object.motion) &&
  object.lifetime.birth === Number.NEGATIVE_INFINITY &&
  object.lifetime.death === Number.POSITIVE_INFINITY;

/** What throws shadows from where it always is: drawn anew only where the observer has gone on. */
export class StaticDistantShadows {
  private readonly atlas: ShadowAtlas;
  private readonly lights: readonly (LightCascades | undefined)[];
  /** Layers of receivers, and after them those of occluders, which are measured from the middle of what rests. */
  private readonly table: LayerTable;
  private readonly poses: PoseTable;
  private readonly origin: Vec3;
  private readonly count: number;
  private readonly side: number;
  private renderedKey = '';

  constructor(occluders: Occluders, suns: readonly ShadowedDistantLight[], gpu: Gpu) {
    const { bodies, drawables, detail } = occluders;
    const resting = bodies.filter(isAlwaysStatic);
    let count = 0;
    this.lights = suns.map((sun) => {
      const box = lightSpaceBox(resting, lightAxes(sun.direction));
      if (!box) return undefined;
      const made = { light: sun, box, count: cascadeSizes(box).length, first: count };
      count += made.count;
      return made;
    });
    this.count = count;
    this.side = detail.staticTiles[Math.max(0, suns.length - 1)];
    this.atlas = new ShadowAtlas(gpu, { cell: detail.cell, threshold: parallelEdgeThreshold });
    this.table = new LayerTable(2 * count, PARALLEL_LAYER_TEXELS);
    this.origin = this.lights[0]?.box.center ?? ZERO;
    this.poses = new PoseTable(bodies.length);
    this.poses.setStatic(resting, drawables, this.origin);
    const { atlas, table, side } = this;
    const placing = this.poses.placement(atlas.layer);
    for (const drawable of drawables)
      if (!drawable.batch.transparent && drawable.batch.bodies.some(isAlwaysStatic))
        atlas.scene.add(makeCaster(drawable, placing, parallelProjection(atlas, table, side), occluders.materials));
  }

  /** undefined where nothing rests. `sun`: its place among the suns. */
  visibility(sun: number, event: ReceiverEvent, taps: number): Float | undefined {
    const found = this.lights[sun];
    if (!found) return undefined;
    const { atlas, table, side } = this;
    const maps: ParallelMaps = { atlas, table, side, sampleCount: taps };
    return cascadeVisibility(maps, found.first, found.count, event);
  }

  /** Makes the maps for an observer at `position`. */
  update(position: Vec3): void {
    const { side, table, origin, count } = this;
    const order: AtlasDraw[] = [];
    this.lights.forEach((found, row) => {
      if (!found) return;
      const { light, box, first } = found;
      const tiles = Array.from(
        { length: found.count },
        (_, k): AtlasTile => ({ x: k * side, y: row * side, size: side }),
      );
      const spread = penumbraSlopeOf(light.radius, light.direction, light.direction);
      cascades(box, position, { tiles, spread }).forEach((layer, k) => {
        table.set(first + k, parallelLayerTexels({ ...layer, center: sub(layer.center, position) }));
        table.set(count + first + k, parallelLayerTexels({ ...layer, center: sub(layer.center, origin) }));
        order.push({ layer: count + first + k });
      });
    });
    const key = table.keyOf(count, count);
    if (key === this.renderedKey || order.length === 0) return;
    this.renderedKey = key;
    const columns = Math.max(...this.lights.map((found) => found?.count ?? 0));
    this.atlas.render(columns * side, this.lights.length * side, order);
  }

  dispose(): void {
    this.atlas.dispose();
    this.poses.dispose();
  }
}
