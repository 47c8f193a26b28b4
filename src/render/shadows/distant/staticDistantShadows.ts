import { sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Float } from '../../../shaders/types.ts';
import type { Body } from '../../geometry/bodies.ts';
import type { Gpu } from '../../gpu/device.ts';
import { LayerTable } from '../atlas/layerTable.ts';
import { type AtlasDraw, ShadowAtlas } from '../atlas/shadowAtlas.ts';
import { makeCaster, wholeBatch } from '../casters/casterMesh.ts';
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

/** A light's cascades: layers of increasing size round the observer. */
interface LightCascades {
  readonly light: ShadowedDistantLight;
  readonly box: LightSpaceBox;
  readonly count: number;
  /** Index of the first of its layers. */
  readonly first: number;
}

/** Whether a body is at rest at all times and never appears or disappears. */
export const isAlwaysStatic = ({ object }: Body): boolean =>
  isStatic(object.motion) &&
  object.lifetime.birth === Number.NEGATIVE_INFINITY &&
  object.lifetime.death === Number.POSITIVE_INFINITY;

/** Shadows of bodies at rest: redrawn only when the observer has moved on. */
export class StaticDistantShadows {
  private readonly atlas: ShadowAtlas;
  private readonly lights: readonly (LightCascades | undefined)[];
  /** The layers of receivers, then those of occluders, which are relative to `origin`. */
  private readonly table: LayerTable;
  private readonly poses: PoseTable;
  private readonly origin: Vec3;
  private readonly count: number;
  private readonly side: number;
  private renderedKey = '';

  constructor(occluders: Occluders, lights: readonly ShadowedDistantLight[], gpu: Gpu) {
    const { bodies, drawCalls, detail } = occluders;
    const resting = bodies.filter(isAlwaysStatic);
    let count = 0;
    this.lights = lights.map((distantLight) => {
      const box = lightSpaceBox(resting, lightAxes(distantLight.direction));
      if (!box) return undefined;
      const cascade = { light: distantLight, box, count: cascadeSizes(box).length, first: count };
      count += cascade.count;
      return cascade;
    });
    this.count = count;
    this.side = detail.staticTiles[Math.max(0, lights.length - 1)];
    this.atlas = new ShadowAtlas(gpu, { cell: detail.cell, threshold: parallelEdgeThreshold });
    this.table = new LayerTable(2 * count, PARALLEL_LAYER_TEXELS);
    this.origin = this.lights[0]?.box.center ?? ZERO;
    this.poses = new PoseTable(bodies.length);
    this.poses.setStatic(resting, drawCalls, this.origin);
    const { atlas, table, side } = this;
    const placement = this.poses.placement(atlas.layer);
    for (const drawCall of drawCalls)
      if (!drawCall.batch.transparent && drawCall.batch.bodies.some(isAlwaysStatic))
        atlas.scene.add(
          makeCaster(wholeBatch(drawCall), placement, parallelProjection(atlas, table, side), occluders.materials),
        );
  }

  /** Returns undefined if nothing is at rest. `index`: of the light. */
  visibility(index: number, event: ReceiverEvent, sampleCount: number): Float | undefined {
    const cascadesOfLight = this.lights[index];
    if (!cascadesOfLight) return undefined;
    const { atlas, table, side } = this;
    const maps: ParallelMaps = { atlas, table, side, sampleCount };
    return cascadeVisibility(maps, cascadesOfLight.first, cascadesOfLight.count, event);
  }

  /** Updates the maps for an observer at `position`. */
  update(position: Vec3): void {
    const { side, table, origin, count } = this;
    const draws: AtlasDraw[] = [];
    this.lights.forEach((lightCascades, row) => {
      if (!lightCascades) return;
      const { light, box, first } = lightCascades;
      const tiles = Array.from(
        { length: lightCascades.count },
        (_, k): AtlasTile => ({ x: k * side, y: row * side, size: side }),
      );
      const penumbraSlope = penumbraSlopeOf(light.radius, light.direction, light.direction);
      cascades(box, position, { tiles, penumbraSlope }).forEach((layer, k) => {
        table.set(first + k, parallelLayerTexels({ ...layer, center: sub(layer.center, position) }));
        table.set(count + first + k, parallelLayerTexels({ ...layer, center: sub(layer.center, origin) }));
        draws.push({ layer: count + first + k });
      });
    });
    const key = table.keyOf(count, count);
    if (key === this.renderedKey || draws.length === 0) return;
    this.renderedKey = key;
    const columns = Math.max(...this.lights.map((lightCascades) => lightCascades?.count ?? 0));
    this.atlas.render(columns * side, this.lights.length * side, draws);
  }

  dispose(): void {
    this.atlas.dispose();
    this.poses.dispose();
  }
}
