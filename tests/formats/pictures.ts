import { encodePng } from '../../src/formats/image/encodePng.ts';
import { writeExr } from '../../src/formats/image/exr.ts';

/** A picture of one red pixel. */
export const PIXEL: Uint8Array = encodePng(1, 1, Uint8Array.of(255, 0, 0, 255));

/** The first bytes of a WebP. */
export const WEBP: Uint8Array = new TextEncoder().encode('RIFF0000WEBPVP8 ');

/** Four pixels of WebP without loss, by ffmpeg: red, green; blue, and a brown that is half transparent. */
export const FOUR_PIXELS_WEBP: Uint8Array = Uint8Array.from(
  atob('UklGRjYAAABXRUJQVlA4TCoAAAAvAUAAEB8gECB49b9gQyCQ5G821QIBgiX/bwQERdctF/jJUYUbMET0PwQ='),
  (letter) => letter.charCodeAt(0),
);

/** 16 × 16 pixels of WebP with loss, by ffmpeg, in one pink. */
export const PINK_WEBP: Uint8Array = Uint8Array.from(
  atob('UklGRjgAAABXRUJQVlA4ICwAAABwAQCdASoQABAAAMASJaACdAGIQAD+771RV6vMq//Qof/+hQ//9Ch/88IAAA=='),
  (letter) => letter.charCodeAt(0),
);

/** A pixel of OpenEXR, half as bright as white. */
export const GRAY_EXR: Uint8Array = writeExr({
  width: 1,
  height: 1,
  channels: ['R', 'G', 'B'].map((name) => ({ name, type: 'half', data: Float32Array.of(0.5) })),
});
