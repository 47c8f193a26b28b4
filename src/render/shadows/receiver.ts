import { abs, clamp, dot, float, floor, If, int, log2, max, normalize, round, sqrt, vec2, vec3 } from 'three/tsl';
import type { Bool, Float, Int, Vec3, Vec4 } from '../../shaders/types.ts';
import type { SeenLamp } from '../lampSeen.ts';
import type { LampTexels } from '../lampTable.ts';
import { MARGIN } from './layer.ts';
import type { LayerTable } from './layerTable.ts';
import { edgeNear, heightAt, type Looked, times, turned } from './lookups.ts';

/** An event on a surface that may be in shadow. */
export interface Receiver {
  /** Observer → event [m], and c(t − t_o) [m of light]. */
  readonly dx: Vec3;
  readonly time: Float;
  /** Unit, in the rest frame. */
  readonly normal: Vec3;
  /** (v, 1 − v²); undefined where all things rest. */
  readonly velocity: Vec4 | undefined;
}

/** Says which share of a light comes to an event. */
export interface Shadowing {
  /** undefined of a sun without shadows; `sun`: its place in the environment. */
  share(sun: number | undefined, receiver: Receiver): Float | undefined;
  /** Of a lamp's. `slot`: its place among those with shadows. */
  ofLamp(slot: Int | number | undefined, receiver: Receiver, lamp: ShadowLamp): Float | undefined;
}

/** A lamp as a surface sees it: surface → lamp when it sent its light out [m], its kind and size. */
export type ShadowLamp = Pick<SeenLamp, 'offset' | 'shape'> & Pick<LampTexels, 'kind' | 'radius' | 'path'>;

/** Layers of one kind: what is in their maps, and the numbers of their projections. */
export interface LayerMaps {
  readonly map: Looked;
  readonly table: LayerTable;
  /** Side of a tile [texels]. */
  readonly side: number;
  /** Lookups where edges are near. */
  readonly taps: number;
}

/** As a receiver's layer sees it; its normal is of one moment of the world. */
export interface Event {
  readonly dx: Vec3;
  readonly time: Float;
  readonly normal: Vec3;
}

/** How far an event is lifted off its surface [texels]: always, and where light comes along the surface. */
const LIFT = [0.4, 1.1] as const;
/** Steepest surface across the light that is followed under the filter. */
const STEEPEST = 8;
/** What rises beside the surface no steeper than so, as the floor at the foot of a wall does, is not above it. */
const RISE = 1.5;
/** The sun's disc on the map is taken to have at least this radius [texels], and at most a cell of edges.ts. */
const LEAST_RADIUS = 0.8;

/** Normal of the surface as it is at one moment of the world: n∥ → γ n∥ of that of the rest frame. */
export function sliceNormal({ normal, velocity }: Pick<Receiver, 'normal' | 'velocity'>): Vec3 {
  if (!velocity) return normal;
  const gamma = float(1)
    .div(sqrt(clamp(velocity.w, 1e-12, 1)))
    .toVar();
  const along = gamma.mul(gamma).div(gamma.add(1)).mul(dot(velocity.xyz, normal));
  return normalize(normal.add(velocity.xyz.mul(along)));
}

type Rows = readonly [Vec4, Vec4, Vec4, Vec4];

export const readRows = (layers: LayerTable, layer: Int | number): Rows => {
  const [across, up, height, time] = [0, 1, 2, 3].map((k) => layers.texel(layer, k).toVar());
  return [across, up, height, time];
};

/** Tile (x, y), spread, and the height of the highest occluders. */
export const readTile = (layers: LayerTable, layer: Int | number): Vec4 => layers.texel(layer, 4).toVar();

/** Place and height of an event on a layer (`layerTexels`). */
export const onLayer = ([across, up, height, time]: Rows, dx: Vec3, at: Float): Vec3 =>
  vec3(dot(across.xyz, dx).add(across.w), dot(up.xyz, dx).add(up.w), dot(height.xyz, dx).add(height.w)).add(
    time.xyz.mul(at),
  );

/** Whether the filter finds all its texels on the layer's tile. */
function isInside(tile: Vec4, side: number, place: Vec3): Bool {
  const local = place.xy.sub(tile.xy).toVar();
  const [least, most] = [MARGIN - 1, side - MARGIN + 1];
  return local.x
    .greaterThan(least)
    .and(local.y.greaterThan(least))
    .and(local.x.lessThan(most))
    .and(local.y.lessThan(most));
}

/** Whether it is behind the ball that fills the tile, or in it. */
function isUnder(tile: Vec4, side: number, place: Vec3): Bool {
  const off = place.xy
    .sub(tile.xy)
    .sub(side / 2)
    .toVar();
  return dot(off, off)
    .lessThan((side / 2 - MARGIN + 1) ** 2)
    .and(place.z.lessThan(tile.w));
}

/**
 * The share of the sun's disc that is seen past the occluders of a layer. Where no edge is near, one lookup tells; else those which fall on the part
 * of the map that the disc covers in the height of the edge (percentage-closer soft shadows, Fernando 2005). The surface itself is taken for a
 * plane under all of them.
 */
function passing({ map, table, taps }: LayerMaps, layer: Int, { dx, time, normal }: Event): Float {
  const rows = readRows(table, layer);
  const [across, up, height, { w: texel }] = rows;
  const spread = readTile(table, layer).z;
  const n = vec3(dot(across.xyz, normal), dot(up.xyz, normal), dot(height.xyz, normal)).mul(texel).toVar();
  const facing = clamp(n.z, 0, 1).toVar();
  const along = sqrt(facing.mul(facing).oneMinus());
  const place = onLayer(rows, dx, time)
    .add(n.mul(along.mul(LIFT[1]).add(LIFT[0])))
    .toVar();
  const slope = clamp(n.xy.div(max(facing, 1 / STEEPEST)).negate(), -STEEPEST, STEEPEST).toVar();
  // A texel without an occluder is 0.
  const ground = max(place.z, 0).toVar();
  const edge = edgeNear(map, place.xy).toVar();
  const near = edge.greaterThan(ground).toVar();
  const radius = near.select(clamp(edge.sub(ground).mul(spread), LEAST_RADIUS, map.cell), float(0)).toVar();
  const direction = vec2(1, 0).toVar();
  const held = float(0).toVar();
  const count = near.select(int(taps), int(1)).toVar();
  times(count, (i) => {
    const away = sqrt(float(i).add(0.5).div(taps)).mul(radius);
    const at = floor(place.xy.add(direction.mul(away))).toVar();
    const off = at.add(0.5).sub(place.xy).toVar();
    const aside = max(abs(off.x), abs(off.y)).mul(RISE);
    const clear = max(max(dot(slope, off), aside).add(place.z), 0);
    held.addAssign(heightAt(map, at).greaterThan(clear).select(float(1), float(0)));
    direction.assign(turned(direction));
  });
  return held.div(float(count)).oneMinus();
}

/** The share that passes all that rests: from the finest of `count` layers which holds the event. */
export function passingResting(maps: LayerMaps, first: number, count: number, event: Event): Float {
  const { table, side } = maps;
  const chosen = int(-1).toVar();
  for (let k = first + count - 1; k >= first; k--) {
    const inside = isInside(readTile(table, k), side, onLayer(readRows(table, k), event.dx, event.time));
    chosen.assign(inside.select(int(k), chosen));
  }
  const share = float(1).toVar();
  If(chosen.greaterThanEqual(0), () => {
    share.assign(passing(maps, chosen, event));
  });
  return share;
}

/**
 * The share that passes what moves: `count` layers from `first` on, each of one body. First all are asked whether the event is behind their bodies,
 * one by one, for numbers at places that are known before the shader runs are cheap; lookups are made only in those.
 */
export function passingMoving(maps: LayerMaps, first: number, count: number, event: Event): Float {
  const { table, side } = maps;
  const [behind, found] = [int(0).toVar(), int(0).toVar()];
  for (let slot = 0; slot < count; slot++) {
    const layer = first + slot;
    const isBehind = isUnder(
      readTile(table, layer),
      side,
      onLayer(readRows(table, layer), event.dx, event.time),
    ).toVar();
    behind.addAssign(isBehind.select(int(1 << slot), int(0)));
    found.addAssign(isBehind.select(int(1), int(0)));
  }
  const share = float(1).toVar();
  times(found, () => {
    const lowest = behind.bitAnd(behind.negate()).toVar();
    const layer = int(round(log2(max(float(lowest), 1))))
      .add(int(first))
      .toVar();
    behind.subAssign(lowest);
    share.mulAssign(passing(maps, layer, event));
  });
  return share;
}
