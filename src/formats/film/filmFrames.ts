import type { FilmTrack } from '../../scene/film/film.ts';

/** A decoded frame: sRGB, rows from the top. */
export interface FilmFrame {
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
  /** RGBA, 4 numbers per pixel. */
  readonly data: Uint8Array;
}

/** The frames of a film, by a decoder of the host. One frame is decoded at a time; quickest in the order in which they are shown. */
export interface FilmFrames {
  /** The frame with this index in `FilmTrack.times`. Rejects with a MessageError where it cannot be decoded. */
  frame(index: number): Promise<FilmFrame>;
  /** Gives the decoder back. */
  close(): void;
}

/** Opens a film for decoding. */
export type OpenFilmFrames = (track: FilmTrack) => FilmFrames;
