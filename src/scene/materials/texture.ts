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
