import { abs, clamp, dot, float, If, int, length, log2, max, min, mix, normalize, round, sqrt, vec2 } from 'three/tsl';
import type { Bool, Float, Int, Vec2, Vec3 } from '../../../shaders/types.ts';
import { lightShader } from '../../lights/lightShaders.ts';
import { type AtlasLookup, loopTimes, MAX_SLOPE, NORMAL_BIAS } from '../atlas/atlasLookups.ts';
import type { LayerTable } from '../atlas/layerTable.ts';
import { normalAsSeen, type ReceiverEvent, type ShadowedLight } from '../distant/parallelReceiver.ts';
import { pcssVisibility } from './pcss.ts';
import {
  cubeFaceOf,
  onLayerAxes,
  type PerspectiveRows,
  readPerspectiveRows,
  type TileGrid,
  tileCorner,
} from './perspectiveProjection.ts';

/** The light that reaches an event from a local light. */
export interface IncomingLight extends ShadowedLight {
  /** Emission time of this light, relative to the event [m of light]. */
  readonly emissionDelay: Float;
}

/** The tiles of local lights and their projections. */
export interface PerspectiveMaps {
  readonly atlas: AtlasLookup;
  readonly table: LayerTable;
  readonly tiles: TileGrid;
  /** Number of lookups where edges are near. */
  readonly sampleCount: number;
}

/** The light visibility past a light's surroundings, on six tiles from its first on, or on one (`faces`). */
export function surroundingsVisibility(
  maps: PerspectiveMaps,
  layer: Int | number,
  event: ReceiverEvent,
  incoming: IncomingLight,
): Float {
  const { atlas, table, tiles, sampleCount } = maps;
  const shader = lightShader(incoming.kind);
  const rows = readPerspectiveRows(table, layer);
  const [first, faces, focal] = rows.map(({ w }) => w);
  const source = rows[3].xyz;
  const d = onLayerAxes(rows, event.dx.sub(source)).toVar();
  const normal = onLayerAxes(rows, event.normal).toVar();
  const width = max(max(abs(d.x), abs(d.y)), abs(d.z)).div(focal);
  const at = d.add(normal.mul(normalBiasOf(normal, d).mul(width))).toVar();
  const { face, onFace } = cubeFaceOf(at);
  const [place, n] = [onFace(at).toVar(), onFace(normal).toVar()];
  const tile = int(round(first)).add(face).toVar();
  const [A, B] = shader.silhouette(incoming).map((axis) =>
    acrossPath(onFace(onLayerAxes(rows, axis)), place)
      .mul(focal)
      .toVar(),
  );
  const surface = planeOf(place.z.reciprocal(), n, dot(normal, at), focal);
  const on = place.xy.mul(focal).div(place.z);
  const texels = tileCorner(tiles, tile)
    .add(on.add(tiles.side / 2))
    .toVar();
  // A light with one tile shines nowhere else. Off the tiles nothing is known of occluders, and the light counts as visible.
  const onTile = float(face).lessThan(faces).and(isOnTile(maps, on)).toVar();
  const footprint = {
    place: onTile.select(texels, vec2(0)).toVar(),
    ...surface,
    A,
    B,
    isParallelogram: shader.isParallelogram,
  };
  return pcssVisibility(atlas, footprint, sampleCount, onTile);
}

/** The receiver as a plane through the lifted event: its height, and the height's change per texel. */
function planeOf(ground: Float, n: Vec3, distance: Float, focal: Float) {
  const grain = ground.div(focal).toVar();
  // The light is on the side to which the normal points.
  const slope = n.xy.div(min(distance, -1e-6).mul(focal)).toVar();
  return { ground: ground.toVar(), grain, slope: clamp(slope, grain.mul(-MAX_SLOPE), grain.mul(MAX_SLOPE)).toVar() };
}

function normalBiasOf(normal: Vec3, fromLight: Vec3): Float {
  const facing = clamp(dot(normal, normalize(fromLight)), -1, 1).toVar();
  return sqrt(facing.mul(facing).oneMinus()).mul(NORMAL_BIAS[1]).add(NORMAL_BIAS[0]);
}

/** A vector at the light, seen along the path to a place, across the tile's axis [m]. */
const acrossPath = (v: Vec3, place: Vec3): Vec2 => v.xy.sub(place.xy.mul(v.z.div(place.z)));

/** Texels of a body's tile: `perspectiveLayerTexels` with the tile's centre; then the body's centre and radius; then its velocity [c], and 1 if it is drawn as it is seen. */
export const CASTER_TEXELS = 6;

/**
 * The light visibility past some bodies: `count` layers from `first` on, each of one body, in coordinates that move with it, ξ = x − βct. In these, light
 * travels straight from where the light was when it emitted. A tile shows its body as seen from the emission event that meets the body's centre, so the
 * light's path is looked up where it is nearest to the centre. This is exact for bodies that are flat there, at any emission time, and for all bodies if the
 * light moves with the body.
 */
export function castersVisibility(
  maps: PerspectiveMaps,
  first: Int | number,
  count: number,
  event: ReceiverEvent,
  incoming: IncomingLight,
): Float {
  const { table } = maps;
  const [behind, casterCount] = [int(0).toVar(), int(0).toVar()];
  const layerOf = (slot: Int | number): Int | number =>
    typeof first === 'number' && typeof slot === 'number' ? first + slot : intNode(first).add(intNode(slot));
  for (let slot = 0; slot < count; slot++) {
    const { clearance } = pathPastCaster(table, layerOf(slot), event, incoming);
    const isBehind = clearance.lessThan(0).toVar();
    behind.addAssign(isBehind.select(int(1 << slot), int(0)));
    casterCount.addAssign(isBehind.select(int(1), int(0)));
  }
  const visibility = float(1).toVar();
  loopTimes(casterCount, () => {
    const lowest = behind.bitAnd(behind.negate()).toVar();
    const slot = int(round(log2(max(float(lowest), 1)))).toVar();
    behind.subAssign(lowest);
    If(lowest.greaterThan(int(0)), () => {
      visibility.mulAssign(casterVisibility(maps, layerOf(slot), event, incoming));
    });
  });
  return visibility;
}

const intNode = (x: Int | number): Int => (typeof x === 'number' ? int(x) : x);

/** Events farther outside the sphere of a body than this do not belong to its surface or to what touches it [radii]. */
const SURFACE_DISTANCE = 0.5;

/**
 * The light's path past a body, whether it enters the body's sphere (`clearance` < 0), and the position on it to look up; for events on the body, the event
 * itself.
 */
function pathPastCaster(
  table: LayerTable,
  layer: Int | number,
  { dx, time }: ReceiverEvent,
  { offset, emissionDelay }: IncomingLight,
) {
  const [sphere, motion] = [4, 5].map((k) => table.texel(layer, k).toVar());
  const here = dx.sub(motion.xyz.mul(time)).toVar();
  const path = offset.sub(motion.xyz.mul(emissionDelay)).toVar();
  const s = clamp(dot(sphere.xyz.sub(here), path).div(dot(path, path).max(1e-12)), 0, 1).toVar();
  const fromCenter = here.add(path.mul(s)).sub(sphere.xyz).toVar();
  const { w: radius } = sphere;
  const clearance = radius.greaterThan(0).select(dot(fromCenter, fromCenter).sub(radius.mul(radius)), float(1));
  const away = length(here.sub(sphere.xyz)).div(radius).sub(1).div(SURFACE_DISTANCE);
  const beyond = s.mul(clamp(away, 0, 1)).toVar();
  return { path, lookupPosition: here.add(path.mul(beyond)), beyond, clearance };
}

/** Whether all texels that the filter may read are on the tile; `on`: relative to the tile's centre. */
const isOnTile = ({ atlas, tiles: { side } }: PerspectiveMaps, on: Vec2): Bool =>
  max(abs(on.x), abs(on.y)).lessThan(side / 2 - atlas.cell);

function casterVisibility(
  maps: PerspectiveMaps,
  layer: Int | number,
  event: ReceiverEvent,
  incoming: IncomingLight,
): Float {
  const { atlas, table, sampleCount } = maps;
  const shader = lightShader(incoming.kind);
  const rows: PerspectiveRows = readPerspectiveRows(table, layer);
  const [across, up, { w: focal }, source] = rows;
  const { path, lookupPosition, beyond } = pathPastCaster(table, layer, event, incoming);
  const d = onLayerAxes(rows, lookupPosition.sub(source.xyz)).toVar();
  const motion = table.texel(layer, 5).toVar();
  const seenNormal = normalize(normalAsSeen(event.normal, event.velocity, motion.xyz, event.timeGradient));
  const eventNormal = mix(event.normal, seenNormal, motion.w).toVar();
  const normal = onLayerAxes(rows, eventNormal).toVar();
  // As far behind that position as the event is.
  const depth = d.z.add(length(path).mul(beyond)).max(1e-6).toVar();
  const lift = normalBiasOf(normal, d).mul(depth.div(focal)).add(event.drawingError.mul(motion.w)).toVar();
  const at = d.add(normal.mul(lift)).toVar();
  const [A, B] = shader.silhouette(incoming).map((axis) => acrossPath(onLayerAxes(rows, axis), at).mul(focal).toVar());
  const surface = planeOf(
    depth.add(normal.z.mul(lift)).max(1e-6).reciprocal(),
    normal,
    dot(eventNormal, path).negate(),
    focal,
  );
  const on = at.xy.mul(focal).div(at.z.max(1e-6)).toVar();
  const onTile = isOnTile(maps, on).toVar();
  const place = onTile.select(on.add(vec2(across.w, up.w)), vec2(0)).toVar();
  return pcssVisibility(
    atlas,
    { place, ...surface, A, B, isParallelogram: shader.isParallelogram },
    sampleCount,
    onTile,
  );
}
