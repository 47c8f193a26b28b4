import { rotate } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { poseAt } from '../../scene/motion.ts';
import type { Lamp } from '../../scene/types.ts';
import type { LayerTable } from './layerTable.ts';
import { faceAxes, faceFocal, lampAxes, type PointLayer, pointTexels } from './pointLayer.ts';
import type { Tiling } from './pointward.ts';

/** Cones up to so far from their axis are on one tile [rad]. */
const WIDEST = 0.95;
/** A lamp with a size is not shaded by what is nearer than this [radii]: it may be its own bulb. */
const BULB = 1.05;
/** Nor any by what is nearer than this part of the scene. */
const LEAST_NEAR = 1e-4;

/** Tiles that a lamp's light falls on. */
export function facesOf({ kind, shaping }: Lamp): number {
  if (shaping && shaping.outer <= WIDEST) return 1;
  return kind === 'rect' || kind === 'disk' ? 5 : 6;
}

/** How a lamp looks round itself at a time [s]; c [m/s], `radius` of the scene [m]. */
export function lampLayer(
  lamp: Lamp,
  t: number,
  {
    c,
    radius,
    side,
    cell,
  }: { readonly c: number; readonly radius: number; readonly side: number; readonly cell: number },
): Omit<PointLayer, 'source'> {
  const { orientation } = poseAt(lamp.motion, t, c);
  const focal = faceFocal(side, cell);
  return {
    axes: lampAxes(rotate(orientation, [1, 0, 0]), rotate(orientation, [0, 1, 0])),
    focal: facesOf(lamp) === 1 && lamp.shaping ? focal / Math.tan(1.02 * Math.max(lamp.shaping.outer, 0.02)) : focal,
    near: Math.max(LEAST_NEAR * radius, 'radius' in lamp && lamp.kind !== 'disk' ? BULB * lamp.radius : 0),
  };
}

/** Middle of a tile [texels]. */
export const middleOf = ({ side, columns }: Tiling, tile: number): readonly [x: number, y: number] => [
  ((tile % columns) + 0.5) * side,
  (Math.floor(tile / columns) + 0.5) * side,
];

/** Puts a lamp's tiles, from `tile` on, at layers of a table: one of receivers, and from another on those of occluders, which are measured from elsewhere. */
export function setRoom(
  table: LayerTable,
  at: { readonly receivers: number; readonly occluders: number; readonly tile: number },
  layer: Omit<PointLayer, 'source'>,
  sources: { readonly receivers: Vec3; readonly occluders: Vec3 },
  faces: number,
  tiling: Tiling,
): void {
  table.set(at.receivers, pointTexels({ ...layer, source: sources.receivers }, at.tile, faces));
  faceAxes(layer.axes)
    .slice(0, faces)
    .forEach((axes, k) => {
      const face = { ...layer, axes, source: sources.occluders };
      table.set(at.occluders + k, pointTexels(face, ...middleOf(tiling, at.tile + k)));
    });
}
