import { abs, clamp, dot, float, If, int, length, log2, max, min, normalize, round, sqrt, vec2 } from 'three/tsl';
import type { Bool, Float, Int, Vec2, Vec3 } from '../../../shaders/types.ts';
import { lightShader } from '../../lights/lightShaders.ts';
import { type AtlasLookup, loopTimes } from '../atlas/atlasLookups.ts';
import type { LayerTable } from '../atlas/layerTable.ts';
import type { ReceiverEvent, ShadowedLight } from '../distant/parallelReceiver.ts';
import { pcssVisibility } from './pcss.ts';
import {
  cubeFaceOf,
  onLayerAxes,
  type PerspectiveRows,
  readPerspectiveRows,
  type TileGrid,
  tileCorner,
} from './perspectiveProjection.ts';

/** The light of a light that comes to an event. */
export interface IncomingLight extends ShadowedLight {
  /** How much later than the event it was sent out [m of light]. */
  readonly emissionDelay: Float;
}

/** Lights' tiles, and the numbers of their projections. */
export interface PerspectiveMaps {
  readonly atlas: AtlasLookup;
  readonly table: LayerTable;
  readonly tiles: TileGrid;
  /** Lookups where edges are near. */
  readonly sampleCount: number;
}

/** How far an event is lifted off its surface [texels]: always, and where light comes along the surface. */
const NORMAL_BIAS = [0.4, 1.1] as const;
/** Steepest surface across the light that is followed under the filter. */
const MAX_SLOPE = 8;

/** What passes all that a light has round it: six tiles from one on, or one (`faces`). */
export function surroundingsVisibility(
  maps: PerspectiveMaps,
  layer: Int | number,
  event: ReceiverEvent,
  beam: IncomingLight,
): Float {
  const { atlas, table, tiles, sampleCount } = maps;
  const shader = lightShader(beam.kind);
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
  const [A, B] = shader.silhouette(beam).map((axis) =>
    acrossPath(onFace(onLayerAxes(rows, axis)), place)
      .mul(focal)
      .toVar(),
  );
  const surface = planeOf(place.z.reciprocal(), n, dot(normal, at), focal);
  const on = place.xy.mul(focal).div(place.z);
  const texels = tileCorner(tiles, tile)
    .add(on.add(tiles.side / 2))
    .toVar();
  // A light with one tile shines nowhere else; without any it is not told what is in its way.
  const there = float(face).lessThan(faces).and(isOnTile(maps, on)).toVar();
  const footprint = {
    place: there.select(texels, vec2(0)).toVar(),
    ...surface,
    A,
    B,
    isParallelogram: shader.isParallelogram,
  };
  return pcssVisibility(atlas, footprint, sampleCount, there);
}

/** From the surface, which is a plane through the lifted event: height, and what a texel changes it by. */
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

/** Where a vector at the light, seen along the way to a place, is across the tile's axis [m]. */
const acrossPath = (v: Vec3, place: Vec3): Vec2 => v.xy.sub(place.xy.mul(v.z.div(place.z)));

/** Texels of a body's tile: those of `perspectiveLayerTexels`, with the tile's middle; its centre and radius, its velocity [c]. */
export const CASTER_TEXELS = 6;

/**
 * The share that passes some bodies: `count` layers from `first` on, each of one body, in coordinates that move with it, ξ = x − βct. There light goes straight, from
 * where the light was when it sent it out, and the tile knows the body as it looked from where it was when it sent out what the body's centre met: the
 * light's way is looked at where it is nearest to the centre. So it is right for what is flat there, whenever it is lit, and for all where the light goes with the body.
 */
export function castersVisibility(
  maps: PerspectiveMaps,
  first: Int | number,
  count: number,
  event: ReceiverEvent,
  beam: IncomingLight,
): Float {
  const { table } = maps;
  const [behind, found] = [int(0).toVar(), int(0).toVar()];
  const layerOf = (slot: Int | number): Int | number =>
    typeof first === 'number' && typeof slot === 'number' ? first + slot : intNode(first).add(intNode(slot));
  for (let slot = 0; slot < count; slot++) {
    const way = pathPastCaster(table, layerOf(slot), event, beam);
    const isBehind = way.clearance.lessThan(0).toVar();
    behind.addAssign(isBehind.select(int(1 << slot), int(0)));
    found.addAssign(isBehind.select(int(1), int(0)));
  }
  const share = float(1).toVar();
  loopTimes(found, () => {
    const lowest = behind.bitAnd(behind.negate()).toVar();
    const slot = int(round(log2(max(float(lowest), 1)))).toVar();
    behind.subAssign(lowest);
    If(lowest.greaterThan(int(0)), () => {
      share.mulAssign(casterVisibility(maps, layerOf(slot), event, beam));
    });
  });
  return share;
}

const intNode = (x: Int | number): Int => (typeof x === 'number' ? int(x) : x);

/** Events so many of a body's radii outside its sphere are not of its own surface, nor of what touches it [radii]. */
const SURFACE_DISTANCE = 0.5;

/** The light's way past a body, whether it enters its sphere (`clearance` < 0), and the place on it to look at: of events on the body they themselves. */
function pathPastCaster(
  table: LayerTable,
  layer: Int | number,
  { dx, time }: ReceiverEvent,
  { offset, emissionDelay }: IncomingLight,
) {
  const [ball, motion] = [4, 5].map((k) => table.texel(layer, k).toVar());
  const here = dx.sub(motion.xyz.mul(time)).toVar();
  const way = offset.sub(motion.xyz.mul(emissionDelay)).toVar();
  const s = clamp(dot(ball.xyz.sub(here), way).div(dot(way, way).max(1e-12)), 0, 1).toVar();
  const off = here.add(way.mul(s)).sub(ball.xyz).toVar();
  const { w: radius } = ball;
  const clearance = radius.greaterThan(0).select(dot(off, off).sub(radius.mul(radius)), float(1));
  const away = length(here.sub(ball.xyz)).div(radius).sub(1).div(SURFACE_DISTANCE);
  const beyond = s.mul(clamp(away, 0, 1)).toVar();
  return { way, looked: here.add(way.mul(beyond)), beyond, clearance };
}

/** Whether the filter finds all its texels on the tile; `on`: from its middle. */
const isOnTile = ({ atlas, tiles: { side } }: PerspectiveMaps, on: Vec2): Bool =>
  max(abs(on.x), abs(on.y)).lessThan(side / 2 - atlas.cell);

function casterVisibility(
  maps: PerspectiveMaps,
  layer: Int | number,
  event: ReceiverEvent,
  beam: IncomingLight,
): Float {
  const { atlas, table, sampleCount } = maps;
  const shader = lightShader(beam.kind);
  const rows: PerspectiveRows = readPerspectiveRows(table, layer);
  const [across, up, { w: focal }, source] = rows;
  const { way, looked, beyond } = pathPastCaster(table, layer, event, beam);
  const d = onLayerAxes(rows, looked.sub(source.xyz)).toVar();
  const normal = onLayerAxes(rows, event.normal).toVar();
  // As deep as it is behind that place.
  const depth = d.z.add(length(way).mul(beyond)).max(1e-6).toVar();
  const lift = normalBiasOf(normal, d).mul(depth.div(focal)).toVar();
  const at = d.add(normal.mul(lift)).toVar();
  const [A, B] = shader.silhouette(beam).map((axis) => acrossPath(onLayerAxes(rows, axis), at).mul(focal).toVar());
  const surface = planeOf(
    depth.add(normal.z.mul(lift)).max(1e-6).reciprocal(),
    normal,
    dot(event.normal, way).negate(),
    focal,
  );
  const on = at.xy.mul(focal).div(at.z.max(1e-6)).toVar();
  const there = isOnTile(maps, on).toVar();
  const place = there.select(on.add(vec2(across.w, up.w)), vec2(0)).toVar();
  return pcssVisibility(
    atlas,
    { place, ...surface, A, B, isParallelogram: shader.isParallelogram },
    sampleCount,
    there,
  );
}
