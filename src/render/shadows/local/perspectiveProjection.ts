import { abs, dot, float, int, max, select, vec2, vec3, vec4 } from 'three/tsl';
import type { Float, Int, Vec2, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { EdgeLayout } from '../atlas/edgeMap.ts';
import type { LayerTable } from '../atlas/layerTable.ts';
import type { ShadowAtlas } from '../atlas/shadowAtlas.ts';
import type { LayerProjection } from '../casters/casterMesh.ts';

/** The tiles of a light's map, in rows. */
export interface TileGrid {
  /** [texels] */
  readonly side: number;
  readonly columns: number;
}

/** The corner of a tile with the least coordinates [texels]. */
export const tileCorner = ({ side, columns }: TileGrid, tile: Int): Vec2 =>
  vec2(tile.mod(int(columns)), tile.div(int(columns))).mul(side);

/**
 * Least change of slope that may be an edge. A texel's width is the depth over the focal length, so a rise by it changes the height (1/depth) by height/focal
 * length; here for the shortest focal length.
 */
export const perspectiveEdgeThreshold =
  (side: number): EdgeLayout['threshold'] =>
  (highest) =>
    highest.mul(2 / side);

/** The rows of a projection (`perspectiveLayerTexels`). */
export type PerspectiveRows = readonly [across: Vec4, up: Vec4, towards: Vec4, source: Vec4];
export const readPerspectiveRows = (table: LayerTable, layer: Int | number): PerspectiveRows => {
  const [across, up, towards, source] = [0, 1, 2, 3].map((k) => table.texel(layer, k).toVar());
  return [across, up, towards, source];
};

/** The components of a vector along a projection's axes. */
export const onLayerAxes = ([across, up, towards]: PerspectiveRows, v: Vec3): Vec3 =>
  vec3(dot(across.xyz, v), dot(up.xyz, v), dot(towards.xyz, v));

/** The cube face that a direction, on a light's axes, belongs to (`cubeFaceAxes`), and a function that maps vectors to the axes of that face. */
export function cubeFaceOf(direction: Vec3): { readonly face: Int; readonly onFace: (v: Vec3) => Vec3 } {
  const size = abs(direction).toVar();
  const ahead = size.z.greaterThanEqual(max(size.x, size.y)).toVar();
  const aside = ahead.not().and(size.x.greaterThanEqual(size.y)).toVar();
  const depth = (v: Vec3): Float => select(ahead, v.z, select(aside, v.x, v.y));
  const behind = depth(direction).lessThan(0).toVar();
  const pair = select(ahead, int(0), select(aside, int(1), int(3)));
  return {
    face: pair.add(select(behind, select(ahead, int(5), int(1)), int(0))).toVar(),
    onFace: (v) =>
      vec3(
        select(aside, v.z, v.x),
        select(ahead.or(aside), v.y, v.z),
        depth(v).mul(select(behind, float(-1), float(1))),
      ),
  };
}

/** Projects occluders onto layers of a local light; `table` has the centre of each tile [texels]. */
export const perspectiveProjection = (map: ShadowAtlas, table: LayerTable, side: number): LayerProjection => ({
  project(layer, x) {
    const rows = readPerspectiveRows(table, layer);
    const [across, up, towards, source] = rows;
    const at = onLayerAxes(rows, x.sub(source.xyz)).toVar();
    const onTile = at.xy.mul(towards.w).toVar();
    const texels = vec2(across.w, up.w).mul(at.z).add(onTile);
    return { clip: vec4(map.clipOf(texels, at.z), map.depthOf(source.w, at.z), at.z), spot: vec3(at.z, onTile) };
  },
  heightOf({ x: depth, y, z }) {
    const outside = max(abs(y), abs(z)).greaterThan(depth.mul(side / 2));
    return { height: depth.reciprocal(), outside };
  },
});
