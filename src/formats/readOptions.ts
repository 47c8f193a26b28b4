export type Interpolation = 'linear' | 'cubic';

/** What a user may choose when a scene is read. */
export interface ReadOptions {
  /** Name or place of the animation to show, where a file has several. Default: the first. */
  readonly animation?: string | number;
  /** Greatest distance between a resampled path and the true one, as a fraction of the object's size. */
  readonly chordTolerance?: number;
  /** USD: how things move between samples; linear is what USD says. */
  readonly interpolation?: Interpolation;
  /** Levels to which subdivision surfaces are refined, 0 … 8; 0: drawn as their polygons. Default: 2, up to 4 for meshes of few faces, or what faces there are for. */
  readonly subdivision?: number;
  /** Name of a variant set → the option to show. Default: what the file itself chooses. */
  readonly variants?: ReadonlyMap<string, string>;
  /** USD: variants by the name of a set, the best first, where nothing is chosen. */
  readonly variantFallbacks?: ReadonlyMap<string, readonly string[]>;
  /** USD: memory for samples of deforming meshes [bytes]; those of crate files that take more stay there and are read when they are needed. */
  readonly sampleMemory?: number;
  /** Told the part of a long cache that is read, and which file. */
  readonly progress?: (part: number) => void;
}
