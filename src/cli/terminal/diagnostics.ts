import { inLines, type LocalizedText, type Message, msg } from '../../messages/message.ts';
import type { Diagnostic } from '../../scene/types.ts';
import { CliError, EXIT } from './exitCodes.ts';
import { localized } from './language.ts';

const SEVERITIES: Readonly<Record<Diagnostic['severity'], Message>> = {
  error: msg`error`,
  warning: msg`warning`,
  info: msg`info`,
};

/** `place: message` */
export const placed = ({ place, message }: { readonly place: LocalizedText; readonly message: Message }): Message =>
  msg`${place}: ${message}`;

/** `warning: place: message` */
export const diagnosticLine = (diagnostic: Diagnostic): Message =>
  msg`${SEVERITIES[diagnostic.severity]}: ${placed(diagnostic)}`;

/** Prints warnings to standard error; throws one error with all errors. */
export function reportDiagnostics(diagnostics: readonly Diagnostic[]): void {
  for (const diagnostic of diagnostics) {
    if (diagnostic.severity === 'warning') console.error(localized(diagnosticLine(diagnostic)));
  }
  const errors = diagnostics.filter(({ severity }) => severity === 'error');
  if (errors.length > 0) throw new CliError(EXIT.input, inLines(errors.map(placed)));
}
