import { inEnglish, type LocalizedText, type Message, msg } from '../../messages/message.ts';
import type { Diagnostic } from '../../scene/types.ts';
import { MAX_PER_CODE } from '../../scene/validation/diagnosticCodes.ts';
import type { DiagnosticCode } from './diagnosticCodes.ts';

/** What is off by less is told in one line [m]. */
const SMALL = 1e-3;

interface SmallRemarks {
  readonly first: Diagnostic;
  /** In the list. */
  readonly place: number;
  count: number;
  /** [m] */
  most: number;
}

/** Diagnostics of a file, without duplicates. Those of one code that tell of less than a millimetre are one. */
export class DiagnosticList {
  readonly list: Diagnostic[] = [];
  private readonly small = new Map<string, SmallRemarks>();
  private readonly said = new Set<string>();
  private readonly counts = new Map<string, number>();

  /** `file`: place of the message that summarizes further ones. */
  add(diagnostic: Diagnostic & { readonly code: DiagnosticCode }, file: LocalizedText): void {
    const { severity, code, place, message, off } = diagnostic;
    if (off !== undefined && off < SMALL) {
      this.addSmall(diagnostic, off, file);
      return;
    }
    const count = (this.counts.get(code) ?? 0) + 1;
    if (count > MAX_PER_CODE + 1) return;
    const key = `${code}\n${inEnglish(place)}\n${inEnglish(message)}`;
    if (this.said.has(key)) return;
    this.counts.set(code, count);
    this.said.add(key);
    const more = msg`there are more of these; the first ${MAX_PER_CODE} are listed`;
    this.list.push(count <= MAX_PER_CODE ? diagnostic : { severity, code, place: file, message: more });
  }

  private addSmall(diagnostic: Diagnostic, off: number, file: LocalizedText): void {
    const { severity, code } = diagnostic;
    const known = this.small.get(code);
    if (!known) {
      this.small.set(code, { first: diagnostic, place: this.list.length, count: 1, most: off });
      this.list.push(diagnostic);
      return;
    }
    known.count++;
    known.most = Math.max(known.most, off);
    const { first, place, count, most } = known;
    const message = msg`${count} things are elsewhere by less than a millimetre, at most ${(1000 * most).toPrecision(2)} mm; the first is ${first.place}: ${first.message}`;
    this.list[place] = { severity, code, place: file, message, off: most };
  }
}

/** The place of a part of a file. */
const placeIn = (file: string, what: LocalizedText): Message => msg`${file}: ${what}`;

/** The part of a file that a place names, where the file need not be said. */
export function partOf(file: string, place: LocalizedText): LocalizedText {
  if (typeof place === 'string' || place.template !== placeIn('', '').template || place.values[0] !== file)
    return place;
  return place.values[1] as LocalizedText;
}

/** Diagnostics of one file, for its reader or writer. */
export class DiagnosticLog {
  private readonly said = new DiagnosticList();
  private readonly file: string;
  constructor(file: string) {
    this.file = file;
  }

  /** `what`: the part of the file; empty: the file itself. `more`: further data for programs. */
  add(
    severity: Diagnostic['severity'],
    code: DiagnosticCode,
    what: LocalizedText,
    message: Message,
    more: Partial<Omit<Diagnostic, 'code'>> = {},
  ): void {
    const place = what ? placeIn(this.file, what) : this.file;
    this.said.add({ severity, code, place, message, ...more }, this.file);
  }

  list(): Diagnostic[] {
    return this.said.list;
  }
}
