export interface Texture {
  /** Its origin, for messages. */
  readonly name: string;
  readonly width: number;
  readonly height: number;
  /** RGBA, rows from the top. */
  readonly data: Uint8Array;
  readonly colorSpace: 'srgb' | 'linear';
  readonly filter: 'nearest' | 'linear';
  readonly wrapS: TextureWrap;
  readonly wrapT: TextureWrap;
}
/** A texture of radiance, which may exceed 1. */
export interface RadianceTexture extends Omit<Texture, 'data'> {
  /** RGBA as halves, linear sRGB of 0 … 65504, rows from the top. */
  readonly data: Uint16Array;
}
/** Sampling outside 0 … 1; `black` is transparent too. */
export type TextureWrap = 'repeat' | 'clamp' | 'mirror' | 'black';
