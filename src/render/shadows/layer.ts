import { addScaled, cross, dot, normalize, scale, type Vec3 } from '../../math/vec3.ts';

// A shadow map is a parallel projection in coordinates that move with the occluder, ξ = x − β·ct: there light from a sun comes straight along s + β.

/** Where on a map's texture a layer is [texels]. */
export interface Tile {
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

/** Two axes across the light, and the one towards where it comes from; unit. */
export interface LightAxes {
  readonly across: Vec3;
  readonly up: Vec3;
  readonly towards: Vec3;
}

/** One parallel projection of things that move together. */
export interface Layer {
  readonly axes: LightAxes;
  /** Of the occluders [c]. */
  readonly beta: Vec3;
  /** What falls on the middle of the tile at time 0 [m]. Times are in metres of light, both from the event that all places are measured from. */
  readonly centre: Vec3;
  /** Half of the tile's side, and how far along the light occluders may be from the centre [m]. */
  readonly half: number;
  readonly depth: number;
  readonly tile: Tile;
}

/** Texels of a layer in the table of layers. */
export const LAYER_TEXELS = 5;

/**
 * The way back along the light in co-moving coordinates, s − kβ, for a ray whose time goes on by k for each metre towards the sun (unit s): −1 of
 * light; 0 where all is of one moment of the world; β_o·s of one moment of an observer's.
 */
export const wayToSun = (s: Vec3, beta: Vec3, k: number): Vec3 => addScaled(s, beta, -k);

/** `way`: any length but 0. The same for ways that differ little, but at one place. */
export function lightAxes(way: Vec3): LightAxes {
  const towards = normalize(way);
  const [x, y, z] = towards.map(Math.abs);
  const least: Vec3 = x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1];
  const across = normalize(cross(least, towards));
  return { across, up: cross(towards, across), towards };
}

/** Width of a texel on a surface across the light [m]. */
export const texelOf = ({ half, tile }: Layer): number => (2 * half) / tile.size;

/**
 * An event (Δx, ct) → texel (column, row) and height (0 … 1 for occluders, more is nearer to the sun), linear, as three rows (∂/∂x, ∂/∂y, ∂/∂z, constant);
 * (∂/∂ct of the three, width of a texel [m]); tile (x, y, side) and ∂height/∂m.
 */
export function layerTexels(layer: Layer): readonly number[] {
  const { axes, beta, centre, tile, depth } = layer;
  const texel = texelOf(layer);
  const row = (axis: Vec3, unit: number, middle: number): readonly [...Vec3, number] => {
    const along = scale(axis, 1 / unit);
    return [...along, middle - dot(along, centre)];
  };
  const rows = [
    row(axes.across, texel, tile.x + tile.size / 2),
    row(axes.up, texel, tile.y + tile.size / 2),
    row(axes.towards, 2 * depth, 0.5),
  ];
  const perTime = rows.map(([x, y, z]) => -dot([x, y, z], beta));
  return [...rows.flat(), ...perTime, texel, tile.x, tile.y, tile.size, 1 / (2 * depth)];
}
