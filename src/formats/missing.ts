import type { Diagnostic, MissingFile } from '../scene/types.ts';

/** What every reader says of a picture that is not there: what was asked for, and where it was looked for. */
export function missingTexture(
  name: string,
  lookedFor: readonly string[],
): Pick<Diagnostic, 'code' | 'message'> & { missing: MissingFile } {
  const message = `the texture ${name} is not there (looked for ${lookedFor.join(', ')}); shown without it`;
  return { code: 'file.missing-texture', message, missing: { name, lookedFor } };
}
