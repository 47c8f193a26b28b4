import type { Code } from '../../src/formats/codes.ts';
import type { ReadOptions } from '../../src/formats/registry.ts';
import type { Scene } from '../../src/scene/types.ts';

/** By path; the first is opened. */
export type Files = Readonly<Record<string, string | Uint8Array>>;

export type Example = Files | (() => Promise<Files>);

/** Something that a file can hold, and what becomes of it: a claim, and an example that shows whether it is true. */
export interface Row {
  /** In Markdown. */
  readonly what: string;
  readonly becomes: string;
  readonly how: 'read' | 'approximated' | 'left out' | 'refused';
  /** One example or several, of which all of this is true. */
  readonly files: Example | readonly Example[];
  readonly options?: ReadOptions;
  /** What is said of it; of what is read, a remark. */
  readonly says?: Code;
  /** What must be true of the scene. */
  readonly check?: (scene: Scene) => void;
}

export interface Group {
  readonly title: string;
  readonly rows: readonly Row[];
}

type Examples = Row['files'];

export const read = (
  what: string,
  becomes: string,
  files: Examples,
  check: (scene: Scene) => void,
  more: Pick<Row, 'says' | 'options'> = {},
): Row => ({ what, becomes, how: 'read', files, check, ...more });

const lesser =
  (how: 'approximated' | 'left out') =>
  (
    what: string,
    becomes: string,
    says: Code,
    files: Examples,
    check?: (scene: Scene) => void,
    options?: ReadOptions,
  ): Row => ({
    what,
    becomes,
    how,
    says,
    files,
    ...(check && { check }),
    ...(options && { options }),
  });

export const approximated = lesser('approximated');
export const leftOut = lesser('left out');

export const refused = (what: string, becomes: string, says: Code, files: Examples, options?: ReadOptions): Row => ({
  what,
  becomes,
  how: 'refused',
  says,
  files,
  ...(options && { options }),
});
