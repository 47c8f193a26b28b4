import type { LoadedScene } from '../../nodes/services.ts';
import type { Diagnostic } from '../../scene/types.ts';

/** Where the worker finds a scene's files. */
export type SceneFiles =
  /** On the page's own server; `base` ends with '/'. */
  | { readonly kind: 'url'; readonly base: string; readonly entry: string }
  /** Chosen or dropped by the person. */
  | {
      readonly kind: 'local';
      readonly files: readonly (readonly [path: string, file: File])[];
      readonly entry: string;
    };

export type Stage = 'fetch' | 'parse';

export type LoaderReply =
  | { readonly kind: 'progress'; readonly part: number; readonly stage: Stage }
  | { readonly kind: 'done'; readonly loaded: LoadedScene }
  /** `diagnostic` where the reader refused the file; else something unforeseen. */
  | { readonly kind: 'failed'; readonly message: string; readonly diagnostic?: Diagnostic };
