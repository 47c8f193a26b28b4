import type { Message } from '../../messages/message.ts';
import type { LoadedScene, SceneReadOptions } from '../../nodes/services.ts';
import type { Diagnostic } from '../../scene/types.ts';
import type { UserFile } from './userFiles.ts';

/** Where the worker finds a scene's files. */
export interface SceneFiles {
  /** Files from the user, searched first. */
  readonly files: readonly (readonly [path: string, file: UserFile])[];
  /** Folder on the page's server, ending with '/'; absent if the user supplied all files. */
  readonly base?: string;
  readonly entry: string;
}

export interface LoadRequest extends SceneFiles {
  readonly how: SceneReadOptions;
  /** Return the files that reading requests from the server, instead of the scene. */
  readonly collect?: true;
}

export type LoadStage = 'fetch' | 'parse';

export type LoaderReply =
  /** `part` 0 … 1; undefined if unknown. */
  | { readonly kind: 'progress'; readonly part: number | undefined; readonly stage: LoadStage }
  | { readonly kind: 'done'; readonly loaded: LoadedScene }
  /** By their paths relative to the scene. */
  | { readonly kind: 'collected'; readonly files: ReadonlyMap<string, Uint8Array> }
  /** With `diagnostic` if the reader refused the file; otherwise an unexpected error. */
  | { readonly kind: 'failed'; readonly message: Message; readonly diagnostic?: Diagnostic };
