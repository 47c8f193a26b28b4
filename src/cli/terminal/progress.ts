/** One line on a terminal that is written over; silent where standard error is not a terminal. */
export class Progress {
  private shown = false;
  private readonly began = performance.now();
  /** What it is that is being made, before all that is said of frames. */
  private readonly what: string;

  constructor(what = '') {
    this.what = what;
  }

  show(text: string): void {
    if (!process.stderr.isTTY) return;
    process.stderr.write(`\r\x1b[2K${text}`);
    this.shown = true;
  }

  /** `done` of `total` frames, with the time that is left if it goes on so; parts of a frame count. */
  frames(done: number, total: number): void {
    const elapsed = (performance.now() - this.began) / 1000;
    const left = done > 0 ? `, ${duration((elapsed / done) * (total - done))} left` : '';
    const part = done % 1 > 0 ? ` ${Math.floor(100 * (done % 1))} %` : '';
    this.show(`${this.what}frame ${Math.floor(done)}/${total}${part}${left}`);
  }

  /** What a node of a project is at. */
  readonly node = (id: string, part: number | undefined): void =>
    this.show(part === undefined ? `${id} …` : `${id}: ${Math.round(100 * part)} %`);

  /** A line that stays. */
  note(text: string): void {
    this.clear();
    console.error(text);
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
