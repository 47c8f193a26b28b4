import type { Diagnostic } from '../scene/types.ts';

/** Most things of one kind that are listed. */
const MAX_PER_CODE = 100;

/** What a reader has to say of one file, each thing once. */
export class Notes {
  readonly #byKey = new Map<string, Diagnostic>();
  readonly #counts = new Map<string, number>();
  readonly #entry: string;
  readonly #format: string;
  /** `format` begins every code: `gltf`. */
  constructor(entry: string, format: string) {
    this.#entry = entry;
    this.#format = format;
  }

  /**
   * `what` names the thing in the file; empty: the file itself. A code with a dot is one that all formats share. `more`: what
   * programs need of it besides.
   */
  add(
    severity: Diagnostic['severity'],
    code: string,
    what: string,
    message: string,
    more: Partial<Diagnostic> = {},
  ): void {
    const key = `${code} ${what} ${message}`;
    const count = (this.#counts.get(code) ?? 0) + 1;
    if (this.#byKey.has(key) || count > MAX_PER_CODE + 1) return;
    this.#counts.set(code, count);
    const isMore = count > MAX_PER_CODE;
    this.#byKey.set(key, {
      severity,
      code: code.includes('.') ? code : `${this.#format}.${code}`,
      place: what && !isMore ? `${this.#entry}: ${what}` : this.#entry,
      message: isMore ? `there are more of these; the first ${MAX_PER_CODE} are listed` : message,
      ...(isMore ? {} : more),
    });
  }

  list(): Diagnostic[] {
    return [...this.#byKey.values()];
  }
}
