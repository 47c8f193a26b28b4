import type { DiagnosticCode } from '../../src/formats/diagnostics/diagnosticCodes.ts';
import type { ReadOptions } from '../../src/formats/readOptions.ts';
import type { Scene } from '../../src/scene/types.ts';

/** By path; the first is opened. */
export type Files = Readonly<Record<string, string | Uint8Array>>;

export type Example = Files | (() => Promise<Files>);

/** Something that a file can hold, and what becomes of it: a claim, and an example that shows whether it is true. */
export interface FormatClaim {
  /** In Markdown. */
  readonly what: string;
  readonly becomes: string;
  readonly how: 'read' | 'approximated' | 'left out' | 'refused';
  /** One example or several, of which all of this is true. */
  readonly files: Example | readonly Example[];
  readonly options?: ReadOptions;
  /** What is said of it; of what is read, a remark. */
  readonly says?: DiagnosticCode;
  /** What must be true of the scene. */
  readonly check?: (scene: Scene) => void;
}

export interface ClaimGroup {
  readonly title: string;
  readonly rows: readonly FormatClaim[];
}

type Examples = FormatClaim['files'];

export const read = (
  what: string,
  becomes: string,
  files: Examples,
  check: (scene: Scene) => void,
  more: Pick<FormatClaim, 'says' | 'options'> = {},
): FormatClaim => ({ what, becomes, how: 'read', files, check, ...more });

const lesser =
  (how: 'approximated' | 'left out') =>
  (
    what: string,
    becomes: string,
    says: DiagnosticCode,
    files: Examples,
    check?: (scene: Scene) => void,
    options?: ReadOptions,
  ): FormatClaim => ({
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

export const refused = (
  what: string,
  becomes: string,
  says: DiagnosticCode,
  files: Examples,
  options?: ReadOptions,
): FormatClaim => ({
  what,
  becomes,
  how: 'refused',
  says,
  files,
  ...(options && { options }),
});
