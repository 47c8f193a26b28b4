import { abs, clamp, dot, float, floor, If, int, log2, max, mix, normalize, round, sqrt, vec2, vec3 } from 'three/tsl';
import type { Bool, Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { LightAtEmission } from '../../lights/lightAtEmission.ts';
import type { LightTexels } from '../../lights/lightTexels.ts';
import {
  type AtlasLookup,
  edgeHeightNear,
  heightAt,
  loopTimes,
  MAX_SLOPE,
  MIN_FILTER_RADIUS,
  MIN_OCCLUDER_SLOPE,
  NORMAL_BIAS,
  rotateByGoldenAngle,
} from '../atlas/atlasLookups.ts';
import type { LayerTable } from '../atlas/layerTable.ts';
import { TILE_MARGIN } from './parallelLayer.ts';

/** An event on a surface that may be in shadow. */
export interface ShadowReceiver {
  /** Observer → event [m], and c(t − t_o) [m of light]. */
  readonly dx: Vec3;
  readonly time: Float;
  /** Unit normal in the rest frame. */
  readonly normal: Vec3;
  /** (v, 1 − v²) [c]; undefined if nothing in the scene moves. */
  readonly velocity: Vec4 | undefined;
}

/** The visibility of lights at an event, from 0 to 1. */
export interface LightVisibility {
  /** undefined if the light throws no shadows; `index`: the light's in the environment. */
  ofDistantLight(index: number | undefined, receiver: ShadowReceiver): Float | undefined;
  /** `slot`: the light's index among those with shadows. */
  ofLocalLight(slot: Int | number | undefined, receiver: ShadowReceiver, light: ShadowedLight): Float | undefined;
}

/** A light as a surface sees it: offset from the surface to the light when it emitted [m], its kind and size. */
export type ShadowedLight = Pick<LightAtEmission, 'offset' | 'shape'> & Pick<LightTexels, 'kind' | 'radius' | 'motion'>;

/** Layers of one kind: their atlas and their projections. */
export interface ParallelMaps {
  readonly atlas: AtlasLookup;
  readonly table: LayerTable;
  /** Side of a tile [texels]. */
  readonly side: number;
  /** Number of lookups where edges are near. */
  readonly sampleCount: number;
}

/** A receiver as layers use it; its normal is that of a slice of the world's time. */
export interface ReceiverEvent {
  readonly dx: Vec3;
  readonly time: Float;
  readonly normal: Vec3;
  /** Of the receiver [c]. */
  readonly velocity: Vec3;
  /** The gradient of c(t − t_o) on the hypersurface that is shown. */
  readonly timeGradient: Vec3;
  /** How far a curved surface that is seen may lie beside the drawn one [m]. */
  readonly drawingError: Float;
}

/**
 * The normal, of any length, of a surface as it is seen in coordinates ξ = x − βct: with dt = g·dx along what is shown, w = v − β, and N the normal in a slice
 * of the world's time, ∂ξ = (1 + w gᵀ/(1 − g·v)) ∂x has the normal N − g (w·N)/(1 − g·β) (docs/physics.md §6.10). All on the same axes.
 */
export function normalAsSeen(N: Vec3, velocity: Vec3, beta: Vec3, timeGradient: Vec3): Vec3 {
  const bend = dot(velocity.sub(beta), N).div(max(dot(timeGradient, beta).oneMinus(), 1e-6));
  return N.sub(timeGradient.mul(bend));
}

/** Normal of the surface in a slice of the world's time: that of the rest frame with n∥ → γ n∥ (docs/physics.md §6.3). */
export function sliceNormal({ normal, velocity }: Pick<ShadowReceiver, 'normal' | 'velocity'>): Vec3 {
  if (!velocity) return normal;
  const gamma = float(1)
    .div(sqrt(clamp(velocity.w, 1e-12, 1)))
    .toVar();
  const along = gamma.mul(gamma).div(gamma.add(1)).mul(dot(velocity.xyz, normal));
  return normalize(normal.add(velocity.xyz.mul(along)));
}

type ParallelRows = readonly [Vec4, Vec4, Vec4, Vec4];

export const readParallelRows = (layers: LayerTable, layer: Int | number): ParallelRows => {
  const [across, up, height, time] = [0, 1, 2, 3].map((k) => layers.texel(layer, k).toVar());
  return [across, up, height, time];
};

/** Tile (x, y), penumbra slope, and the height of the highest occluders. */
export const readTileTexel = (layers: LayerTable, layer: Int | number): Vec4 => layers.texel(layer, 4).toVar();

/** Place and height of an event on a layer (`parallelLayerTexels`). */
export const projectToLayer = ([across, up, height, time]: ParallelRows, dx: Vec3, at: Float): Vec3 =>
  vec3(dot(across.xyz, dx).add(across.w), dot(up.xyz, dx).add(up.w), dot(height.xyz, dx).add(height.w)).add(
    time.xyz.mul(at),
  );

/** Whether all texels that the filter may read are on the layer's tile. */
function isInside(tile: Vec4, side: number, place: Vec3): Bool {
  const local = place.xy.sub(tile.xy).toVar();
  const [least, most] = [TILE_MARGIN - 1, side - TILE_MARGIN + 1];
  return local.x
    .greaterThan(least)
    .and(local.y.greaterThan(least))
    .and(local.x.lessThan(most))
    .and(local.y.lessThan(most));
}

/** Whether the place is behind the sphere that fills the tile, or in it. */
function isBehindCaster(tile: Vec4, side: number, place: Vec3): Bool {
  const offset = place.xy
    .sub(tile.xy)
    .sub(side / 2)
    .toVar();
  return dot(offset, offset)
    .lessThan((side / 2 - TILE_MARGIN + 1) ** 2)
    .and(place.z.lessThan(tile.w));
}

/**
 * The fraction of the light's disc that is visible past the occluders of a layer. Where no edge is near, one lookup decides; elsewhere lookups cover the disc
 * as projected at the height of the edge (percentage-closer soft shadows, Fernando 2005). The receiver is taken as a plane under all of them.
 */
function layerVisibility(
  { atlas, table, sampleCount }: ParallelMaps,
  layer: Int,
  { dx, time, normal, velocity, timeGradient, drawingError }: ReceiverEvent,
): Float {
  const rows = readParallelRows(table, layer);
  const [across, up, height, { xyz: perTime, w: texel }] = rows;
  const penumbraSlope = readTileTexel(table, layer).z;
  const asSeen = table.texel(layer, 5).x;
  const onAxes = (v: Vec3): Vec3 => vec3(dot(across.xyz, v), dot(up.xyz, v), dot(height.xyz, v)).mul(texel).toVar();
  const atOnce = onAxes(normal);
  const seen = normalize(normalAsSeen(atOnce, onAxes(velocity), perTime.mul(texel).negate(), onAxes(timeGradient)));
  const n = mix(atOnce, seen, asSeen).toVar();
  const facing = clamp(n.z, 0, 1).toVar();
  const along = sqrt(facing.mul(facing).oneMinus());
  const lift = along.mul(NORMAL_BIAS[1]).add(NORMAL_BIAS[0]).add(drawingError.div(texel).mul(asSeen));
  const place = projectToLayer(rows, dx, time).add(n.mul(lift)).toVar();
  const slope = clamp(n.xy.div(max(facing, 1 / MAX_SLOPE)).negate(), -MAX_SLOPE, MAX_SLOPE).toVar();
  // Texels without an occluder have height 0.
  const ground = max(place.z, 0).toVar();
  const edge = edgeHeightNear(atlas, place.xy).toVar();
  const nearEdge = edge.greaterThan(ground).toVar();
  const radius = nearEdge
    .select(clamp(edge.sub(ground).mul(penumbraSlope), MIN_FILTER_RADIUS, atlas.cell), float(0))
    .toVar();
  const direction = vec2(1, 0).toVar();
  const occluded = float(0).toVar();
  const count = nearEdge.select(int(sampleCount), int(1)).toVar();
  loopTimes(count, (i) => {
    const away = sqrt(float(i).add(0.5).div(sampleCount)).mul(radius);
    const at = floor(place.xy.add(direction.mul(away))).toVar();
    const offset = at.add(0.5).sub(place.xy).toVar();
    const rise = max(abs(offset.x), abs(offset.y)).mul(MIN_OCCLUDER_SLOPE);
    const minHeight = max(max(dot(slope, offset), rise).add(place.z), 0);
    occluded.addAssign(heightAt(atlas, at).greaterThan(minHeight).select(float(1), float(0)));
    direction.assign(rotateByGoldenAngle(direction));
  });
  return occluded.div(float(count)).oneMinus();
}

/** The light visibility past the bodies at rest: from the finest of `count` layers that contains the event. */
export function cascadeVisibility(maps: ParallelMaps, first: number, count: number, event: ReceiverEvent): Float {
  const { table, side } = maps;
  const chosen = int(-1).toVar();
  for (let k = first + count - 1; k >= first; k--) {
    const inside = isInside(
      readTileTexel(table, k),
      side,
      projectToLayer(readParallelRows(table, k), event.dx, event.time),
    );
    chosen.assign(inside.select(int(k), chosen));
  }
  const visibility = float(1).toVar();
  If(chosen.greaterThanEqual(0), () => {
    visibility.assign(layerVisibility(maps, chosen, event));
  });
  return visibility;
}

/**
 * The light visibility past moving bodies: `count` layers from `first` on, one body each. All layers are first tested for whether the event is behind their
 * bodies, in an unrolled loop, because reading uniforms at constant indices is cheap; lookups are made only in those that pass.
 */
export function castersVisibility(maps: ParallelMaps, first: number, count: number, event: ReceiverEvent): Float {
  const { table, side } = maps;
  const [behind, casterCount] = [int(0).toVar(), int(0).toVar()];
  for (let slot = 0; slot < count; slot++) {
    const layer = first + slot;
    const behindCaster = isBehindCaster(
      readTileTexel(table, layer),
      side,
      projectToLayer(readParallelRows(table, layer), event.dx, event.time),
    ).toVar();
    behind.addAssign(behindCaster.select(int(1 << slot), int(0)));
    casterCount.addAssign(behindCaster.select(int(1), int(0)));
  }
  const visibility = float(1).toVar();
  loopTimes(casterCount, () => {
    const lowest = behind.bitAnd(behind.negate()).toVar();
    const layer = int(round(log2(max(float(lowest), 1))))
      .add(int(first))
      .toVar();
    behind.subAssign(lowest);
    visibility.mulAssign(layerVisibility(maps, layer, event));
  });
  return visibility;
}
