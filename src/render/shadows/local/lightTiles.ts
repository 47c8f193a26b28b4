import { rotate } from '../../../math/quat.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import { lightKind } from '../../../scene/lights/lightKinds.ts';
import { poseAt } from '../../../scene/motion/motion.ts';
import type { LocalLight } from '../../../scene/types.ts';
import { lightShader, lightShapeOf } from '../../lights/lightShaders.ts';
import type { LayerTable } from '../atlas/layerTable.ts';
import {
  cubeFaceAxes,
  faceFocal,
  lightFrameAxes,
  type PerspectiveLayer,
  perspectiveLayerTexels,
} from './perspectiveLayer.ts';
import type { TileGrid } from './perspectiveProjection.ts';

/** Shaped lights whose cone is within this angle of their axis have one tile [rad]. */
const MAX_SINGLE_TILE_ANGLE = 0.95;
/** What is nearer to a light than this may be its own bulb, and casts no shadow [radii]. */
const BULB_RADII = 1.05;
/** Least near distance of a layer, as a fraction of the scene's radius. */
const MIN_NEAR = 1e-4;

/** Number of tiles that a light shines on. */
export function faceCountOf(light: LocalLight): number {
  const { shaping } = light;
  if (shaping && shaping.outer <= MAX_SINGLE_TILE_ANGLE) return 1;
  return lightKind(light).isOneSided ? 5 : 6;
}

/** The projection of a light's surroundings at a time [s]; c [m/s], `radius` of the scene [m]; `side`, `cell` of its tiles [texels]. */
export function lightLayer(
  light: LocalLight,
  t: number,
  {
    c,
    radius,
    side,
    cell,
  }: { readonly c: number; readonly radius: number; readonly side: number; readonly cell: number },
): Omit<PerspectiveLayer, 'source'> {
  const { orientation } = poseAt(light.motion, t, c);
  const focal = faceFocal(side, cell);
  return {
    axes: lightFrameAxes(rotate(orientation, [1, 0, 0]), rotate(orientation, [0, 1, 0])),
    focal:
      faceCountOf(light) === 1 && light.shaping ? focal / Math.tan(1.02 * Math.max(light.shaping.outer, 0.02)) : focal,
    near: Math.max(MIN_NEAR * radius, BULB_RADII * lightShader(lightShapeOf(light)).bulbRadius(light)),
  };
}

/** Centre of a tile [texels]. */
export const tileCenter = ({ side, columns }: TileGrid, tile: number): readonly [x: number, y: number] => [
  ((tile % columns) + 0.5) * side,
  (Math.floor(tile / columns) + 0.5) * side,
];

/** Sets the layers of a light's tiles, from `tile` on: one for receivers, and one per face for occluders, which have another origin. */
export function setLightTiles(
  table: LayerTable,
  at: { readonly receivers: number; readonly occluders: number; readonly tile: number },
  layer: Omit<PerspectiveLayer, 'source'>,
  sources: { readonly receivers: Vec3; readonly occluders: Vec3 },
  faces: number,
  tiles: TileGrid,
): void {
  table.set(at.receivers, perspectiveLayerTexels({ ...layer, source: sources.receivers }, at.tile, faces));
  cubeFaceAxes(layer.axes)
    .slice(0, faces)
    .forEach((axes, k) => {
      const face = { ...layer, axes, source: sources.occluders };
      table.set(at.occluders + k, perspectiveLayerTexels(face, ...tileCenter(tiles, at.tile + k)));
    });
}
