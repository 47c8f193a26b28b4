import type { Diagnostic } from '../../scene/types.ts';
import { CliError, EXIT } from './exitCodes.ts';

const line = ({ severity, place, message }: Diagnostic): string => `${severity}: ${place}: ${message}`;

/** Prints warnings to standard error; throws one error with all errors. */
export function reportDiagnostics(diagnostics: readonly Diagnostic[]): void {
  for (const diagnostic of diagnostics) {
    if (diagnostic.severity === 'warning') console.error(line(diagnostic));
  }
  const errors = diagnostics.filter(({ severity }) => severity === 'error');
  if (errors.length > 0)
    throw new CliError(EXIT.input, errors.map(({ place, message }) => `${place}: ${message}`).join('\n'));
}
