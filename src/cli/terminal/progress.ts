import { type LocalizedText, msg } from '../../messages/message.ts';
import { localized } from './language.ts';

/** A progress line that is overwritten; nothing is printed if standard error is not a terminal. */
export class Progress {
  private shown = false;
  private readonly began = performance.now();
  /** Name of what frames are counted of. */
  private readonly name: string;

  constructor(name = '') {
    this.name = name;
  }

  show(text: LocalizedText): void {
    if (!process.stderr.isTTY) return;
    process.stderr.write(`\r\x1b[2K${localized(text)}`);
    this.shown = true;
  }

  /** Shows `done` of `total` frames with the estimated remaining time; `done` may have a fraction. */
  frames(done: number, total: number): void {
    const elapsed = (performance.now() - this.began) / 1000;
    const part = done % 1 > 0 ? ` ${Math.floor(100 * (done % 1))} %` : '';
    const count = msg`frame ${`${Math.floor(done)}/${total}${part}`}`;
    const named = this.name ? msg`${this.name}: ${count}` : count;
    this.show(done > 0 ? msg`${named}, ${duration((elapsed / done) * (total - done))} left` : named);
  }

  /** Progress of a node, `part` 0 … 1 if known. */
  readonly node = (id: string, part: number | undefined): void =>
    this.show(part === undefined ? `${id} …` : msg`${id}: ${`${Math.round(100 * part)} %`}`);

  /** Prints a permanent line. */
  note(text: LocalizedText): void {
    this.clear();
    console.error(localized(text));
  }

  clear(): void {
    if (this.shown) process.stderr.write('\r\x1b[2K');
    this.shown = false;
  }
}

/** 75 → `1 min 15 s`. */
function duration(seconds: number): string {
  const whole = Math.ceil(seconds);
  return whole < 60 ? `${whole} s` : `${Math.floor(whole / 60)} min ${whole % 60} s`;
}
