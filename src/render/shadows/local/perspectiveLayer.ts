import { cross, dot, length, normalize, scale, type Vec3 } from '../../../math/vec3.ts';
import { type LightAxes, lightAxes } from '../distant/parallelLayer.ts';

// The map of a light is a central projection from its middle. A height on it is one over the depth along the tile's axis: flat things stay flat, what is
// nearer to the light is higher, and what is endlessly far away has height 0.

/** So many texels along the sides of a tile are left to what its filter reads: those of a cell of edgeMap.ts, and some more. */
export const tileMarginOf = (cell: number): number => cell + 2;

/** A light's tiles have so many cells of edgeMap.ts along a side; its filter is so wide at most, to either side. */
export const CELLS_PER_TILE = 16;

/** One central projection. */
export interface PerspectiveLayer {
  /** `towards`: the way into the scene. */
  readonly axes: LightAxes;
  /** The light [m], from where all places are measured. */
  readonly source: Vec3;
  /** Width of something as wide as it is deep [texels]. */
  readonly focal: number;
  /** What is less deep is not drawn [m]. */
  readonly near: number;
}

/** (across, x), (up, y), (towards, focal), (source, near): two numbers of its own with the first two axes. */
export function perspectiveLayerTexels(
  { axes, source, focal, near }: PerspectiveLayer,
  x: number,
  y: number,
): readonly number[] {
  return [...axes.right, x, ...axes.up, y, ...axes.toLight, focal, ...source, near];
}
export const PERSPECTIVE_LAYER_TEXELS = 4;

/** The six ways out of a light, by its own axes; the first is the way in which it looks. Their axes across are two of the three, as shaders choose them. */
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

/** Unit axes of a light that looks along −Z of its own. */
export const lightFrameAxes = (X: Vec3, Y: Vec3): LightAxes => ({ right: X, up: Y, toLight: normalize(cross(Y, X)) });

/** Focal length of a face of 90°, or of one that holds a ball from so far away; undefined from within it, or too near. */
export const faceFocal = (side: number, cell: number): number => side / 2 - tileMarginOf(cell);

/** A ball that is nearer to a light than so many of its radii, to its centre, fills more of the light's sky than one tile holds. */
const MIN_DISTANCE_RADII = 1.1;
export const isTooNear = (source: Vec3, radius: number): boolean => !(length(source) > MIN_DISTANCE_RADII * radius);

export function sphereLayer(
  source: Vec3,
  radius: number,
  { side, cell }: { readonly side: number; readonly cell: number },
): PerspectiveLayer | undefined {
  if (isTooNear(source, radius)) return undefined;
  const room = dot(source, source) - radius * radius;
  return {
    axes: lightAxes(scale(source, -1)),
    source,
    focal: (faceFocal(side, cell) * Math.sqrt(room)) / radius,
    near: (length(source) - radius) / 2,
  };
}
