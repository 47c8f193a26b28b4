import type { DiagnosticCode } from '../../formats/diagnostics/diagnosticCodes.ts';
import { inEnglish, inLines, type LocalizedText, type Message, msg } from '../../messages/message.ts';
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

/** Of what a file asks for and a picture does not have. */
const OMISSIONS: ReadonlySet<string> = new Set<DiagnosticCode>([
  ...(['gltf.ignored-extension', 'gltf.instance-attributes', 'usd.material-input', 'usd.light-input'] as const),
  ...(['usd.mesh-light', 'mtlx.input', 'obj.ignored', 'stl.colors'] as const),
]);

const MAX_OMISSIONS = 5;

/** Prints to standard error what a picture lacks, the same said of several things once; `inspect` lists all. */
export function reportOmissions(diagnostics: readonly Diagnostic[]): void {
  const infos = diagnostics.filter(({ severity, code }) => severity === 'info' && OMISSIONS.has(code));
  const same = new Map<string, Diagnostic[]>();
  for (const info of infos) {
    const key = inEnglish(info.message);
    same.set(key, [...(same.get(key) ?? []), info]);
  }
  const groups = [...same.values()];
  for (const [first, ...others] of groups.slice(0, MAX_OMISSIONS)) {
    if (!first) continue;
    const { place, message } = first;
    const line = others.length > 0 ? msg`${place} and ${others.length} more: ${message}` : placed(first);
    console.error(localized(msg`${SEVERITIES.info}: ${line}`));
  }
  const left = groups.length - MAX_OMISSIONS;
  if (left > 0)
    console.error(localized(msg`info: ${left} more remarks of what is not drawn; slowlight inspect lists them`));
}
