import type { FisheyeLens } from '../scene/view/lenses/fisheyeLens.ts';
import type { OpenFilmFrames } from './film/filmFrames.ts';
import type { DecodePicture } from './image/foreignPictures.ts';

/** Between time samples: straight, or along cubics. */
export type Interpolation = 'linear' | 'cubic';

/** Options for reading a scene. */
export interface ReadOptions {
  /** Name or index of the animation to load. Default: the first. */
  readonly animation?: string | number;
  /** Maximum error of a resampled path, relative to the object's size. */
  readonly chordTolerance?: number;
  /** Path of the prim that is read, with everything below it; what it inherits from above stays. Absent: everything. */
  readonly prim?: string;
  /** USD: interpolation between time samples; USD specifies linear. */
  readonly interpolation?: Interpolation;
  /** Levels to which subdivision surfaces are refined, 0 … 8; 0: drawn as their polygons. Default: 2, up to 4 for meshes of few faces, or what faces there are for. */
  readonly subdivision?: number;
  /** Name of a variant set → the option to show. Default: what the file itself chooses. */
  readonly variants?: ReadonlyMap<string, string>;
  /** USD: fallback variants by variant set, in order of preference, where nothing is selected. */
  readonly variantFallbacks?: ReadonlyMap<string, readonly string[]>;
  /** USD: memory for samples of deforming meshes [bytes]; larger ones in crate files are streamed from disk. */
  readonly sampleMemory?: number;
  /** Pictures and films of all directions: the fisheye whose picture it is, a circle in its middle. Absent: as the file says, or by its shape. */
  readonly fisheye?: FisheyeLens;
  /** glTF: decodes WebP and AVIF. Absent: what has no other picture is shown without. */
  readonly decodePicture?: DecodePicture;
  /** Decodes the frames of films. Absent: films are refused. */
  readonly openFilm?: OpenFilmFrames;
  /** Called with the fraction of a long cache that is read. */
  readonly progress?: (part: number) => void;
}
