import { abs, clamp, dot, float, floor, If, int, log2, max, normalize, round, sqrt, vec2, vec3 } from 'three/tsl';
import type { Bool, Float, Int, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { LightAtEmission } from '../../lights/lightAtEmission.ts';
import type { LightTexels } from '../../lights/lightTexels.ts';
import { type AtlasLookup, edgeHeightNear, heightAt, loopTimes, rotateByGoldenAngle } from '../atlas/atlasLookups.ts';
import type { LayerTable } from '../atlas/layerTable.ts';
import { TILE_MARGIN } from './parallelLayer.ts';

/** An event on a surface that may be in shadow. */
export interface ShadowReceiver {
  /** Observer → event [m], and c(t − t_o) [m of light]. */
  readonly dx: Vec3;
  readonly time: Float;
  /** Unit, in the rest frame. */
  readonly normal: Vec3;
  /** (v, 1 − v²); undefined where all things rest. */
  readonly velocity: Vec4 | undefined;
}

/** Says which share of a light comes to an event. */
export interface LightVisibility {
  /** undefined of a sun without shadows; `sun`: its place in the environment. */
  ofDistantLight(sun: number | undefined, receiver: ShadowReceiver): Float | undefined;
  /** Of a light's. `slot`: its place among those with shadows. */
  ofLocalLight(slot: Int | number | undefined, receiver: ShadowReceiver, light: ShadowedLight): Float | undefined;
}

/** A light as a surface sees it: surface → light when it sent its light out [m], its kind and size. */
export type ShadowedLight = Pick<LightAtEmission, 'offset' | 'shape'> & Pick<LightTexels, 'kind' | 'radius' | 'motion'>;

/** Layers of one kind: what is in their maps, and the numbers of their projections. */
export interface ParallelMaps {
  readonly atlas: AtlasLookup;
  readonly table: LayerTable;
  /** Side of a tile [texels]. */
  readonly side: number;
  /** Lookups where edges are near. */
  readonly sampleCount: number;
}

/** As a receiver's layer sees it; its normal is of one moment of the world. */
export interface ReceiverEvent {
  readonly dx: Vec3;
  readonly time: Float;
  readonly normal: Vec3;
}

/** How far an event is lifted off its surface [texels]: always, and where light comes along the surface. */
const NORMAL_BIAS = [0.4, 1.1] as const;
/** Steepest surface across the light that is followed under the filter. */
const MAX_SLOPE = 8;
/** What rises beside the surface no steeper than so, as the floor at the foot of a wall does, is not above it. */
const MIN_OCCLUDER_SLOPE = 1.5;
/** The sun's disc on the map is taken to have at least this radius [texels], and at most a cell of edgeMap.ts. */
const MIN_FILTER_RADIUS = 0.8;

/** Normal of the surface as it is at one moment of the world: n∥ → γ n∥ of that of the rest frame. */
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

/** Tile (x, y), spread, and the height of the highest occluders. */
export const readTileTexel = (layers: LayerTable, layer: Int | number): Vec4 => layers.texel(layer, 4).toVar();

/** Place and height of an event on a layer (`parallelLayerTexels`). */
export const projectToLayer = ([across, up, height, time]: ParallelRows, dx: Vec3, at: Float): Vec3 =>
  vec3(dot(across.xyz, dx).add(across.w), dot(up.xyz, dx).add(up.w), dot(height.xyz, dx).add(height.w)).add(
    time.xyz.mul(at),
  );

/** Whether the filter finds all its texels on the layer's tile. */
function isInside(tile: Vec4, side: number, place: Vec3): Bool {
  const local = place.xy.sub(tile.xy).toVar();
  const [least, most] = [TILE_MARGIN - 1, side - TILE_MARGIN + 1];
  return local.x
    .greaterThan(least)
    .and(local.y.greaterThan(least))
    .and(local.x.lessThan(most))
    .and(local.y.lessThan(most));
}

/** Whether it is behind the ball that fills the tile, or in it. */
function isBehindCaster(tile: Vec4, side: number, place: Vec3): Bool {
  const off = place.xy
    .sub(tile.xy)
    .sub(side / 2)
    .toVar();
  return dot(off, off)
    .lessThan((side / 2 - TILE_MARGIN + 1) ** 2)
    .and(place.z.lessThan(tile.w));
}

/**
 * The share of the sun's disc that is seen past the occluders of a layer. Where no edge is near, one lookup tells; else those which fall on the part
 * of the map that the disc covers in the height of the edge (percentage-closer soft shadows, Fernando 2005). The surface itself is taken for a
 * plane under all of them.
 */
function layerVisibility(
  { atlas, table, sampleCount }: ParallelMaps,
  layer: Int,
  { dx, time, normal }: ReceiverEvent,
): Float {
  const rows = readParallelRows(table, layer);
  const [across, up, height, { w: texel }] = rows;
  const spread = readTileTexel(table, layer).z;
  const n = vec3(dot(across.xyz, normal), dot(up.xyz, normal), dot(height.xyz, normal)).mul(texel).toVar();
  const facing = clamp(n.z, 0, 1).toVar();
  const along = sqrt(facing.mul(facing).oneMinus());
  const place = projectToLayer(rows, dx, time)
    .add(n.mul(along.mul(NORMAL_BIAS[1]).add(NORMAL_BIAS[0])))
    .toVar();
  const slope = clamp(n.xy.div(max(facing, 1 / MAX_SLOPE)).negate(), -MAX_SLOPE, MAX_SLOPE).toVar();
  // A texel without an occluder is 0.
  const ground = max(place.z, 0).toVar();
  const edge = edgeHeightNear(atlas, place.xy).toVar();
  const near = edge.greaterThan(ground).toVar();
  const radius = near.select(clamp(edge.sub(ground).mul(spread), MIN_FILTER_RADIUS, atlas.cell), float(0)).toVar();
  const direction = vec2(1, 0).toVar();
  const held = float(0).toVar();
  const count = near.select(int(sampleCount), int(1)).toVar();
  loopTimes(count, (i) => {
    const away = sqrt(float(i).add(0.5).div(sampleCount)).mul(radius);
    const at = floor(place.xy.add(direction.mul(away))).toVar();
    const off = at.add(0.5).sub(place.xy).toVar();
    const aside = max(abs(off.x), abs(off.y)).mul(MIN_OCCLUDER_SLOPE);
    const clear = max(max(dot(slope, off), aside).add(place.z), 0);
    held.addAssign(heightAt(atlas, at).greaterThan(clear).select(float(1), float(0)));
    direction.assign(rotateByGoldenAngle(direction));
  });
  return held.div(float(count)).oneMinus();
}

/** The share that passes all that rests: from the finest of `count` layers which holds the event. */
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
  const share = float(1).toVar();
  If(chosen.greaterThanEqual(0), () => {
    share.assign(layerVisibility(maps, chosen, event));
  });
  return share;
}

/**
 * The share that passes what moves: `count` layers from `first` on, each of one body. First all are asked whether the event is behind their bodies,
 * one by one, for numbers at places that are known before the shader runs are cheap; lookups are made only in those.
 */
export function castersVisibility(maps: ParallelMaps, first: number, count: number, event: ReceiverEvent): Float {
  const { table, side } = maps;
  const [behind, found] = [int(0).toVar(), int(0).toVar()];
  for (let slot = 0; slot < count; slot++) {
    const layer = first + slot;
    const isBehind = isBehindCaster(
      readTileTexel(table, layer),
      side,
      projectToLayer(readParallelRows(table, layer), event.dx, event.time),
    ).toVar();
    behind.addAssign(isBehind.select(int(1 << slot), int(0)));
    found.addAssign(isBehind.select(int(1), int(0)));
  }
  const share = float(1).toVar();
  loopTimes(found, () => {
    const lowest = behind.bitAnd(behind.negate()).toVar();
    const layer = int(round(log2(max(float(lowest), 1))))
      .add(int(first))
      .toVar();
    behind.subAssign(lowest);
    share.mulAssign(layerVisibility(maps, layer, event));
  });
  return share;
}
