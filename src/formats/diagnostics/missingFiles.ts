import { listed, msg } from '../../messages/message.ts';
import type { Diagnostic, MissingFile } from '../../scene/types.ts';
import type { DiagnosticCode } from './diagnosticCodes.ts';

/** Diagnostic of a missing texture: its name and where it was searched for. */
export function missingTexture(
  name: string,
  lookedFor: readonly string[],
): Pick<Diagnostic, 'message'> & { code: DiagnosticCode; missing: MissingFile } {
  const message = msg`the texture ${name} is not there (looked for ${listed(lookedFor)}); shown without it`;
  return { code: 'file.missing-texture', message, missing: { name, lookedFor } };
}

/** Diagnostic of a missing spectrum table; `instead`: the fallback. */
export function missingSpectrum(
  name: string,
  lookedFor: readonly string[],
  instead = msg`its light is taken for daylight`,
): Pick<Diagnostic, 'message'> & { code: DiagnosticCode; missing: MissingFile } {
  const message = msg`the spectrum ${name} is not there (looked for ${listed(lookedFor)}); ${instead}`;
  return { code: 'file.missing-spectrum', message, missing: { name, lookedFor } };
}
