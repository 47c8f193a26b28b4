import type { Diagnostic } from '../../scene/types.ts';
import type { DiagnosticCode } from './diagnosticCodes.ts';

/** Of each kind of diagnostic so many are listed; a file with a million faults has one message more, not a million. */
export const MAX_PER_CODE = 100;

/** What is said about a file: the same thing about the same place once. */
export class DiagnosticList {
  readonly list: Diagnostic[] = [];
  private readonly said = new Set<string>();
  private readonly counts = new Map<string, number>();

  /** `file` is the place of what says that there are more. */
  add(diagnostic: Diagnostic & { readonly code: DiagnosticCode }, file: string): void {
    const { severity, code, place, message } = diagnostic;
    const key = `${code}\n${place}\n${message}`;
    const count = (this.counts.get(code) ?? 0) + 1;
    if (this.said.has(key) || count > MAX_PER_CODE + 1) return;
    this.counts.set(code, count);
    this.said.add(key);
    const more = `there are more of these; the first ${MAX_PER_CODE} are listed`;
    this.list.push(count <= MAX_PER_CODE ? diagnostic : { severity, code, place: file, message: more });
  }
}

/** What a reader or a writer has to say of one file. */
export class DiagnosticLog {
  private readonly said = new DiagnosticList();
  private readonly file: string;
  constructor(file: string) {
    this.file = file;
  }

  /** `what` names the thing in the file; empty: the file itself. `more`: what programs need of it besides. */
  add(
    severity: Diagnostic['severity'],
    code: DiagnosticCode,
    what: string,
    message: string,
    more: Partial<Omit<Diagnostic, 'code'>> = {},
  ): void {
    const place = what ? `${this.file}: ${what}` : this.file;
    this.said.add({ severity, code, place, message, ...more }, this.file);
  }

  list(): Diagnostic[] {
    return this.said.list;
  }
}
