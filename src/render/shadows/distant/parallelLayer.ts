import { addScaled, cross, dot, length, normalize, scale, type Vec3 } from '../../../math/vec3.ts';

// A shadow map is a parallel projection in coordinates that move with the occluder, ξ = x − β·ct: there light from a sun comes straight along s + β.

/** Where on a map's texture a layer is [texels]. */
export interface AtlasTile {
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

/** Two axes across the light, and the one towards where it comes from; unit. */
export interface LightAxes {
  readonly right: Vec3;
  readonly up: Vec3;
  readonly toLight: Vec3;
}

/** One parallel projection of things that move together. */
export interface ParallelLayer {
  readonly axes: LightAxes;
  /** Of the occluders [c]. */
  readonly beta: Vec3;
  /** What falls on the middle of the tile at time 0 [m]. Times are in metres of light, both from the event that all places are measured from. */
  readonly center: Vec3;
  /** Half of the side of what the tile holds besides its margin, and how far along the light occluders may be from the centre [m]. */
  readonly halfSide: number;
  readonly halfDepth: number;
  /** Half width of a penumbra over how far above the shaded the edge is that throws it. */
  readonly penumbraSlope: number;
  readonly tile: AtlasTile;
}

/** Texels of a layer in the table of layers. */
export const PARALLEL_LAYER_TEXELS = 5;
/** So many texels along the sides of a tile are left to what its filter reads [texels]. */
export const TILE_MARGIN = 12;

/**
 * The way back along the light in co-moving coordinates, s − kβ, for a ray whose time goes on by k for each metre towards the sun (unit s): −1 of
 * light; 0 where all is of one moment of the world; β_o·s of one moment of an observer's.
 */
export const comovingPathToLight = (s: Vec3, beta: Vec3, timePerMeter: number): Vec3 =>
  addScaled(s, beta, -timePerMeter);

/** `way`: any length but 0. The same for ways that differ little, but at one place. */
export function lightAxes(path: Vec3): LightAxes {
  const towards = normalize(path);
  const [x, y, z] = towards.map(Math.abs);
  const least: Vec3 = x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1];
  const across = normalize(cross(least, towards));
  return { right: across, up: cross(towards, across), toLight: towards };
}

/**
 * Half width of a penumbra per metre along the way, of a sun of this radius [rad] towards s. Its disc, as wide as it is distant, is seen along the
 * way as an ellipse, foreshortened by the cosine between s and the way; this is the radius of the circle of its area.
 */
export function penumbraSlopeOf(radius: number, s: Vec3, path: Vec3): number {
  const size = length(path);
  return (Math.tan(radius) / size) * Math.sqrt(Math.max(0, dot(s, path) / size));
}

/** Width of a texel on a surface across the light [m]. */
export const texelSize = ({ halfSide, tile }: ParallelLayer): number => (2 * halfSide) / (tile.size - 2 * TILE_MARGIN);

/**
 * An event (Δx, ct) → column, row and height towards the sun, all in widths of a texel, linear, as three rows (∂/∂x, ∂/∂y, ∂/∂z, constant);
 * (∂/∂ct of the three, width of a texel [m]); tile (x, y), spread, and the height of the highest occluders; the lowest have height 0.
 */
export function parallelLayerTexels(layer: ParallelLayer): readonly number[] {
  const { axes, beta, center, tile, halfDepth, penumbraSlope: spread } = layer;
  const texel = texelSize(layer);
  const row = (axis: Vec3, middle: number): readonly [...Vec3, number] => {
    const along = scale(axis, 1 / texel);
    return [...along, middle - dot(along, center)];
  };
  const rows = [
    row(axes.right, tile.x + tile.size / 2),
    row(axes.up, tile.y + tile.size / 2),
    row(axes.toLight, halfDepth / texel),
  ];
  const perTime = rows.map(([x, y, z]) => -dot([x, y, z], beta));
  return [...rows.flat(), ...perTime, texel, tile.x, tile.y, spread, (2 * halfDepth) / texel];
}
