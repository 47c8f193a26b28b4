/** A picture on a surface. */
export interface Texture {
  /** Its origin, for messages. */
  readonly name: string;
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
  /** RGBA, rows from the top. */
  readonly data: Uint8Array;
  /** How its numbers are encoded; alpha is always linear. */
  readonly colorSpace: 'srgb' | 'linear';
  /** How it is sampled between texels. */
  readonly filter: 'nearest' | 'linear';
  /** Outside 0 … 1 across. */
  readonly wrapS: TextureWrap;
  /** Outside 0 … 1 upwards. */
  readonly wrapT: TextureWrap;
}
/** A texture of radiance, which may exceed 1. */
export interface RadianceTexture extends Omit<Texture, 'data'> {
  /** RGBA as halves, linear sRGB of 0 … 65504, rows from the top. */
  readonly data: Uint16Array;
}
/** Sampling outside 0 … 1; `black` is transparent too. */
export type TextureWrap = 'repeat' | 'clamp' | 'mirror' | 'black';

/** One channel of a texture as a number: `scale` times its linear value plus `bias`, clamped to 0 … 1. */
export interface TextureChannel {
  /** Linear. */
  readonly texture: Texture;
  /** Red, green, blue, alpha. */
  readonly channel: 0 | 1 | 2 | 3;
  /** Factor of the linear value. */
  readonly scale: number;
  /** Added after `scale`. */
  readonly bias: number;
}

/**
 * Tangent-space normals: x in the direction of rising u, y in that of rising v, both perpendicular to the surface's own normal, and z along it.
 * A texel (r, g, b) means (strength_x (2r − 1), strength_y (2g − 1), 2b − 1), of any length.
 */
export interface NormalTexture {
  /** Linear. */
  readonly texture: Texture;
  /** Factors of x and y. */
  readonly strength: readonly [x: number, y: number];
}
