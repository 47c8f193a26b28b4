import { encodePng } from '../../src/formats/image/encodePng.ts';

/** A picture of one red pixel. */
export const PIXEL: Uint8Array = encodePng(1, 1, Uint8Array.of(255, 0, 0, 255));

/** The first bytes of a WebP. */
export const WEBP: Uint8Array = new TextEncoder().encode('RIFF0000WEBPVP8 ');
