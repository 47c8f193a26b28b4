import type { Interpolation } from '../../formats/readOptions.ts';
import type { LoadedScene } from '../../nodes/services.ts';
import type { Diagnostic } from '../../scene/types.ts';
import type { UserFile } from './userFiles.ts';

/** Where the worker finds a scene's files. */
export interface SceneFiles {
  /** Chosen or dropped by the person: looked at first. */
  readonly files: readonly (readonly [path: string, file: UserFile])[];
  /** Folder on the page's own server, ending with '/'; absent where the person gave all files. */
  readonly base?: string;
  readonly entry: string;
}

export interface LoadRequest extends SceneFiles {
  /** `set`, `option`. */
  readonly variants: readonly (readonly [string, string])[];
  readonly interpolation?: Interpolation;
  /** Give the files that reading it asks the server for, instead of the scene. */
  readonly collect?: true;
}

export type LoadStage = 'fetch' | 'parse';

export type LoaderReply =
  /** `part` 0 … 1; undefined where it cannot be known. */
  | { readonly kind: 'progress'; readonly part: number | undefined; readonly stage: LoadStage }
  | { readonly kind: 'done'; readonly loaded: LoadedScene }
  /** By their paths beside the scene. */
  | { readonly kind: 'collected'; readonly files: ReadonlyMap<string, Uint8Array> }
  /** `diagnostic` where the reader refused the file; else something unforeseen. */
  | { readonly kind: 'failed'; readonly message: string; readonly diagnostic?: Diagnostic };
