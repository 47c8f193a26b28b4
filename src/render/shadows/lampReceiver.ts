import {
  abs,
  clamp,
  cross,
  dot,
  float,
  If,
  int,
  length,
  log2,
  max,
  min,
  normalize,
  round,
  sqrt,
  vec2,
  vec3,
} from 'three/tsl';
import type { Bool, Float, Int, Vec2, Vec3 } from '../../shaders/types.ts';
import type { LayerTable } from './layerTable.ts';
import { type Looked, times } from './lookups.ts';
import { along, cornerOf, faceOf, type PointRows, readPoint, type Tiling } from './pointward.ts';
import type { Event, ShadowLamp } from './receiver.ts';
import { softShare } from './softShare.ts';

/** The light of a lamp that comes to an event. */
export interface Beam extends ShadowLamp {
  /** How much later than the event it was sent out [m of light]. */
  readonly later: Float;
}

/** Lamps' tiles, and the numbers of their projections. */
export interface PointMaps {
  readonly map: Looked;
  readonly table: LayerTable;
  readonly tiling: Tiling;
  /** Lookups where edges are near. */
  readonly taps: number;
}

/** How far an event is lifted off its surface [texels]: always, and where light comes along the surface. */
const LIFT = [0.4, 1.1] as const;
/** Steepest surface across the light that is followed under the filter. */
const STEEPEST = 8;

/** What passes all that a lamp has round it: six tiles from one on, or one (`faces`). */
export function passingRound(maps: PointMaps, layer: Int | number, event: Event, beam: Beam): Float {
  const { map, table, tiling, taps } = maps;
  const rows = readPoint(table, layer);
  const [first, faces, focal] = rows.map(({ w }) => w);
  const source = rows[3].xyz;
  const d = along(rows, event.dx.sub(source)).toVar();
  const normal = along(rows, event.normal).toVar();
  const width = max(max(abs(d.x), abs(d.y)), abs(d.z)).div(focal);
  const at = d.add(normal.mul(liftOf(normal, d).mul(width))).toVar();
  const { face, onFace } = faceOf(at);
  const [place, n] = [onFace(at).toVar(), onFace(normal).toVar()];
  const tile = int(round(first)).add(face).toVar();
  const [A, B] = extentOf(beam).map((axis) =>
    onMap(onFace(along(rows, axis)), place)
      .mul(focal)
      .toVar(),
  );
  const surface = planeOf(place.z.reciprocal(), n, dot(normal, at), focal);
  const on = place.xy.mul(focal).div(place.z);
  const texels = cornerOf(tiling, tile)
    .add(on.add(tiling.side / 2))
    .toVar();
  // A lamp with one tile shines nowhere else; without any it is not told what is in its way.
  const there = float(face).lessThan(faces).and(isOnTile(maps, on)).toVar();
  const footprint = { place: there.select(texels, vec2(0)).toVar(), ...surface, A, B, square: isSquare(beam) };
  return softShare(map, footprint, taps, there);
}

/** From the surface, which is a plane through the lifted event: height, and what a texel changes it by. */
function planeOf(ground: Float, n: Vec3, distance: Float, focal: Float) {
  const grain = ground.div(focal).toVar();
  // The lamp is on the side to which the normal points.
  const slope = n.xy.div(min(distance, -1e-6).mul(focal)).toVar();
  return { ground: ground.toVar(), grain, slope: clamp(slope, grain.mul(-STEEPEST), grain.mul(STEEPEST)).toVar() };
}

function liftOf(normal: Vec3, fromLamp: Vec3): Float {
  const facing = clamp(dot(normal, normalize(fromLamp)), -1, 1).toVar();
  return sqrt(facing.mul(facing).oneMinus()).mul(LIFT[1]).add(LIFT[0]);
}

/** Half axes of what a lamp shows, in the world [m]. */
function extentOf({ kind, radius, shape, offset }: Beam): readonly [Vec3, Vec3] {
  if (kind === 'point') return [vec3(0), vec3(0)];
  if (shape && kind !== 'cylinder' && kind !== 'sphere') return [shape.X, shape.Y];
  const to = normalize(offset).toVar();
  if (shape && kind === 'cylinder') return [shape.X, normalize(cross(shape.X, to)).mul(radius)];
  // Across the way to a ball, along and across the least of its parts.
  const aside = abs(to.x)
    .lessThan(0.7)
    .select(vec3(1, 0, 0), vec3(0, 1, 0));
  const X = normalize(cross(to, aside)).toVar();
  return [X.mul(radius), cross(to, X).mul(radius)];
}

const isSquare = ({ kind }: Beam): boolean => kind === 'rect' || kind === 'cylinder';

/** Where a vector at the lamp, seen along the way to a place, is across the tile's axis [m]. */
const onMap = (v: Vec3, place: Vec3): Vec2 => v.xy.sub(place.xy.mul(v.z.div(place.z)));

/** Texels of a body's tile: those of `pointTexels`, with the tile's middle; its centre and radius, its velocity [c]. */
export const BODY_TEXELS = 6;

/**
 * The share that passes some bodies: `count` layers from `first` on, each of one body, in coordinates that move with it, ξ = x − βct. There light goes straight, from
 * where the lamp was when it sent it out, and the tile knows the body as it looked from where it was when it sent out what the body's centre met: the
 * light's way is looked at where it is nearest to the centre. So it is right for what is flat there, whenever it is lit, and for all where the lamp goes with the body.
 */
export function passingBodies(maps: PointMaps, first: Int | number, count: number, event: Event, beam: Beam): Float {
  const { table } = maps;
  const [behind, found] = [int(0).toVar(), int(0).toVar()];
  const layerOf = (slot: Int | number): Int | number =>
    typeof first === 'number' && typeof slot === 'number' ? first + slot : whole(first).add(whole(slot));
  for (let slot = 0; slot < count; slot++) {
    const way = wayPast(table, layerOf(slot), event, beam);
    const isBehind = way.clearance.lessThan(0).toVar();
    behind.addAssign(isBehind.select(int(1 << slot), int(0)));
    found.addAssign(isBehind.select(int(1), int(0)));
  }
  const share = float(1).toVar();
  times(found, () => {
    const lowest = behind.bitAnd(behind.negate()).toVar();
    const slot = int(round(log2(max(float(lowest), 1)))).toVar();
    behind.subAssign(lowest);
    If(lowest.greaterThan(int(0)), () => {
      share.mulAssign(passingBody(maps, layerOf(slot), event, beam));
    });
  });
  return share;
}

const whole = (x: Int | number): Int => (typeof x === 'number' ? int(x) : x);

/** Events so many of a body's radii outside its sphere are not of its own surface, nor of what touches it [radii]. */
const APART = 0.5;

/** The light's way past a body, whether it enters its sphere (`clearance` < 0), and the place on it to look at: of events on the body they themselves. */
function wayPast(table: LayerTable, layer: Int | number, { dx, time }: Event, { offset, later }: Beam) {
  const [ball, motion] = [4, 5].map((k) => table.texel(layer, k).toVar());
  const here = dx.sub(motion.xyz.mul(time)).toVar();
  const way = offset.sub(motion.xyz.mul(later)).toVar();
  const s = clamp(dot(ball.xyz.sub(here), way).div(dot(way, way).max(1e-12)), 0, 1).toVar();
  const off = here.add(way.mul(s)).sub(ball.xyz).toVar();
  const { w: radius } = ball;
  const clearance = radius.greaterThan(0).select(dot(off, off).sub(radius.mul(radius)), float(1));
  const away = length(here.sub(ball.xyz)).div(radius).sub(1).div(APART);
  const beyond = s.mul(clamp(away, 0, 1)).toVar();
  return { way, looked: here.add(way.mul(beyond)), beyond, clearance };
}

/** Whether the filter finds all its texels on the tile; `on`: from its middle. */
const isOnTile = ({ map, tiling: { side } }: PointMaps, on: Vec2): Bool =>
  max(abs(on.x), abs(on.y)).lessThan(side / 2 - map.cell);

function passingBody(maps: PointMaps, layer: Int | number, event: Event, beam: Beam): Float {
  const { map, table, taps } = maps;
  const rows: PointRows = readPoint(table, layer);
  const [across, up, { w: focal }, source] = rows;
  const { way, looked, beyond } = wayPast(table, layer, event, beam);
  const d = along(rows, looked.sub(source.xyz)).toVar();
  const normal = along(rows, event.normal).toVar();
  // As deep as it is behind that place.
  const depth = d.z.add(length(way).mul(beyond)).max(1e-6).toVar();
  const lift = liftOf(normal, d).mul(depth.div(focal)).toVar();
  const at = d.add(normal.mul(lift)).toVar();
  const [A, B] = extentOf(beam).map((axis) => onMap(along(rows, axis), at).mul(focal).toVar());
  const surface = planeOf(
    depth.add(normal.z.mul(lift)).max(1e-6).reciprocal(),
    normal,
    dot(event.normal, way).negate(),
    focal,
  );
  const on = at.xy.mul(focal).div(at.z.max(1e-6)).toVar();
  const there = isOnTile(maps, on).toVar();
  const place = there.select(on.add(vec2(across.w, up.w)), vec2(0)).toVar();
  return softShare(map, { place, ...surface, A, B, square: isSquare(beam) }, taps, there);
}
