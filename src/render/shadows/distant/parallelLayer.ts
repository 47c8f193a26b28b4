import { addScaled, cross, dot, length, normalize, scale, type Vec3 } from '../../../math/vec3.ts';

// A shadow map is a parallel projection in coordinates that move with the occluder, ξ = x − β·ct, in which light from a distant light travels straight along
// s + β (docs/physics.md §6.10).

/** Where a layer is in the atlas [texels]. */
export interface AtlasTile {
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

/** Two unit axes across the light, and one towards where it comes from. */
export interface LightAxes {
  readonly right: Vec3;
  readonly up: Vec3;
  readonly toLight: Vec3;
}

/** One parallel projection of bodies that move together. */
export interface ParallelLayer {
  readonly axes: LightAxes;
  /** Velocity of the occluders [c]. */
  readonly beta: Vec3;
  /** The place at the centre of the tile at time 0 [m]. Places and times [m of light] are relative to one event. */
  readonly center: Vec3;
  /** Half of the side of the tile without its margin, and the largest distance along the light of occluders from the centre [m]. */
  readonly halfSide: number;
  readonly halfDepth: number;
  /** Half width of a penumbra over the height of the edge that throws it above the receiver. */
  readonly penumbraSlope: number;
  readonly tile: AtlasTile;
  /** Whether the occluder is drawn as it is seen, each point at its own event; else as it is at one event. */
  readonly asSeen?: boolean;
}

/** Texels of a layer in the table of layers. */
export const PARALLEL_LAYER_TEXELS = 6;
/** Margin at each side of a tile that is read by the filter [texels]. */
export const TILE_MARGIN = 12;

/**
 * The path back to the light in comoving coordinates, s − kβ, of a ray whose time changes by k per metre towards the distant light (unit vector s): k = −1 on
 * the past light cone, 0 in a slice of the world's time, β_o·s in the observer's slice of simultaneity.
 */
export const comovingPathToLight = (s: Vec3, beta: Vec3, timePerMeter: number): Vec3 =>
  addScaled(s, beta, -timePerMeter);

/** `path`: of any length but 0. The axes change continuously with it, except where the least component changes. */
export function lightAxes(path: Vec3): LightAxes {
  const toLight = normalize(path);
  const [x, y, z] = toLight.map(Math.abs);
  const least: Vec3 = x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1];
  const across = normalize(cross(least, toLight));
  return { right: across, up: cross(toLight, across), toLight };
}

/**
 * Half width of a penumbra per metre along the path, of a distant light of this angular radius [rad] in the direction s. Its disc is seen along the path as
 * an ellipse, foreshortened by the cosine between s and the path; this is the radius of the circle of equal area.
 */
export function penumbraSlopeOf(radius: number, s: Vec3, path: Vec3): number {
  const size = length(path);
  return (Math.tan(radius) / size) * Math.sqrt(Math.max(0, dot(s, path) / size));
}

/** Width of a texel across the light [m]. */
export const texelSize = ({ halfSide, tile }: ParallelLayer): number => (2 * halfSide) / (tile.size - 2 * TILE_MARGIN);

/**
 * A layer as shaders read it. Three rows (∂/∂x, ∂/∂y, ∂/∂z, constant) map an event (Δx, ct) to column, row and height towards the light, in texels; then
 * (their derivatives ∂/∂ct, width of a texel [m]); then the tile's (x, y), the penumbra slope, and the height of the highest occluders; then 1 if it is
 * drawn as it is seen. The lowest occluders have height 0.
 */
export function parallelLayerTexels(layer: ParallelLayer): readonly number[] {
  const { axes, beta, center, tile, halfDepth, penumbraSlope, asSeen = false } = layer;
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
  return [
    ...rows.flat(),
    ...perTime,
    texel,
    tile.x,
    tile.y,
    penumbraSlope,
    (2 * halfDepth) / texel,
    Number(asSeen),
    0,
    0,
    0,
  ];
}
