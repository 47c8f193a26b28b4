import { rotate } from '../../../math/quat.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import { poseAt } from '../../../scene/motion/motion.ts';
import type { LocalLight } from '../../../scene/types.ts';
import type { LayerTable } from '../atlas/layerTable.ts';
import {
  cubeFaceAxes,
  faceFocal,
  lightFrameAxes,
  type PerspectiveLayer,
  perspectiveLayerTexels,
} from './perspectiveLayer.ts';
import type { TileGrid } from './perspectiveProjection.ts';

/** Cones up to so far from their axis are on one tile [rad]. */
const MAX_SINGLE_TILE_ANGLE = 0.95;
/** A lamp with a size is not shaded by what is nearer than this [radii]: it may be its own bulb. */
const BULB_RADII = 1.05;
/** Nor any by what is nearer than this part of the scene. */
const MIN_NEAR = 1e-4;

/** Tiles that a lamp's light falls on. */
export function faceCountOf({ kind, shaping }: LocalLight): number {
  if (shaping && shaping.outer <= MAX_SINGLE_TILE_ANGLE) return 1;
  return kind === 'rect' || kind === 'disk' ? 5 : 6;
}

/** How a lamp looks round itself at a time [s]; c [m/s], `radius` of the scene [m]. */
export function lightLayer(
  lamp: LocalLight,
  t: number,
  {
    c,
    radius,
    side,
    cell,
  }: { readonly c: number; readonly radius: number; readonly side: number; readonly cell: number },
): Omit<PerspectiveLayer, 'source'> {
  const { orientation } = poseAt(lamp.motion, t, c);
  const focal = faceFocal(side, cell);
  return {
    axes: lightFrameAxes(rotate(orientation, [1, 0, 0]), rotate(orientation, [0, 1, 0])),
    focal:
      faceCountOf(lamp) === 1 && lamp.shaping ? focal / Math.tan(1.02 * Math.max(lamp.shaping.outer, 0.02)) : focal,
    near: Math.max(MIN_NEAR * radius, 'radius' in lamp && lamp.kind !== 'disk' ? BULB_RADII * lamp.radius : 0),
  };
}

/** Middle of a tile [texels]. */
export const tileCenter = ({ side, columns }: TileGrid, tile: number): readonly [x: number, y: number] => [
  ((tile % columns) + 0.5) * side,
  (Math.floor(tile / columns) + 0.5) * side,
];

/** Puts a lamp's tiles, from `tile` on, at layers of a table: one of receivers, and from another on those of occluders, which are measured from elsewhere. */
export function setLightTiles(
  table: LayerTable,
  at: { readonly receivers: number; readonly occluders: number; readonly tile: number },
  layer: Omit<PerspectiveLayer, 'source'>,
  sources: { readonly receivers: Vec3; readonly occluders: Vec3 },
  faces: number,
  tiling: TileGrid,
): void {
  table.set(at.receivers, perspectiveLayerTexels({ ...layer, source: sources.receivers }, at.tile, faces));
  cubeFaceAxes(layer.axes)
    .slice(0, faces)
    .forEach((axes, k) => {
      const face = { ...layer, axes, source: sources.occluders };
      table.set(at.occluders + k, perspectiveLayerTexels(face, ...tileCenter(tiling, at.tile + k)));
    });
}
