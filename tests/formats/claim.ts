import type { DiagnosticCode } from '../../src/formats/diagnostics/diagnosticCodes.ts';
import type { ReadOptions } from '../../src/formats/readOptions.ts';
import type { Scene } from '../../src/scene/types.ts';

/** By path; the first is opened. */
export type Files = Readonly<Record<string, string | Uint8Array>>;

export type Example = Files | (() => Promise<Files>);

/** A feature of a format and how it is read: a claim, and an example that tests it. */
export interface FormatClaim {
  /** In Markdown. */
  readonly what: string;
  readonly becomes: string;
  readonly how: 'read' | 'approximated' | 'left out' | 'refused';
  /** One or several examples, all of which satisfy the claim. */
  readonly files: Example | readonly Example[];
  readonly options?: ReadOptions;
  /** Expected diagnostic. */
  readonly says?: DiagnosticCode;
  /** Assertions on the scene. */
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
