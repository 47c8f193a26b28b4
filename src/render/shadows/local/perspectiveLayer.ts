import { cross, dot, length, normalize, scale, type Vec3 } from '../../../math/vec3.ts';
import { type LightAxes, lightAxes } from '../distant/parallelLayer.ts';

// A local light's map is a central projection from its centre. Heights on it are one over the depth along the tile's axis: planes stay planes, what is nearer
// to the light is higher, and infinity has height 0 (docs/physics.md §6.10).

/** Margin at each side of a tile that is read by the filter [texels]: a cell of the edge map, and two more. */
export const tileMarginOf = (cell: number): number => cell + 2;

/** Cells of the edge map along a side of a tile; the filter's radius is at most one cell. */
export const CELLS_PER_TILE = 16;

/** One central projection. */
export interface PerspectiveLayer {
  /** `toLight` here points from the light into the scene. */
  readonly axes: LightAxes;
  /** Place of the light [m], relative to the layer's origin. */
  readonly source: Vec3;
  /** Width of something that is as wide as it is deep [texels]. */
  readonly focal: number;
  /** Nothing nearer than this depth is drawn [m]. */
  readonly near: number;
}

/** (right, x), (up, y), (toLight, focal), (source, near); x and y are two numbers that depend on the kind of layer. */
export function perspectiveLayerTexels(
  { axes, source, focal, near }: PerspectiveLayer,
  x: number,
  y: number,
): readonly number[] {
  return [...axes.right, x, ...axes.up, y, ...axes.toLight, focal, ...source, near];
}
export const PERSPECTIVE_LAYER_TEXELS = 4;

/**
 * The six faces of a light's cube map on its own axes; the first is its forward direction. The axes across are two of the three, as `cubeFaceOf` selects them
 * in shaders.
 */
export function cubeFaceAxes({ right: across, up, toLight }: LightAxes): readonly LightAxes[] {
  const back = (v: Vec3) => scale(v, -1);
  return [
    { right: across, up, toLight },
    { right: toLight, up, toLight: across },
    { right: toLight, up, toLight: back(across) },
    { right: across, up: toLight, toLight: up },
    { right: across, up: toLight, toLight: back(up) },
    { right: across, up, toLight: back(toLight) },
  ];
}

/** Unit axes of a light that looks along its own −Z. */
export const lightFrameAxes = (X: Vec3, Y: Vec3): LightAxes => ({ right: X, up: Y, toLight: normalize(cross(Y, X)) });

/** Focal length of a face of 90° [texels]. */
export const faceFocal = (side: number, cell: number): number => side / 2 - tileMarginOf(cell);

/** A sphere whose centre is nearer to a light than this many of its radii covers more of the light's sky than one tile can hold. */
const MIN_DISTANCE_RADII = 1.1;
export const isTooNear = (source: Vec3, radius: number): boolean => !(length(source) > MIN_DISTANCE_RADII * radius);

/** The layer of a tile that holds a sphere, with the light at `source` relative to the sphere's centre. Returns undefined if it is too near. */
export function sphereLayer(
  source: Vec3,
  radius: number,
  { side, cell }: { readonly side: number; readonly cell: number },
): PerspectiveLayer | undefined {
  if (isTooNear(source, radius)) return undefined;
  const tangentSquared = dot(source, source) - radius * radius;
  return {
    axes: lightAxes(scale(source, -1)),
    source,
    focal: (faceFocal(side, cell) * Math.sqrt(tangentSquared)) / radius,
    near: (length(source) - radius) / 2,
  };
}
