/** A measurement with its description; docs/performance.md is generated from these. */
export interface Bench {
  /** Its name in `npm run bench -- NAME`. */
  readonly name: string;
  readonly title: string;
  /** What is measured and how, what it is compared with, and why the comparison is fair. */
  readonly about: string;
  /** `files`: those named behind the benchmark's name. */
  run(files: readonly string[]): Promise<readonly Table[]>;
}

export interface Table {
  readonly columns: readonly string[];
  readonly rows: readonly (readonly (string | number)[])[];
  /** What the results show, in a sentence. */
  readonly remark?: string;
}

export function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const half = sorted.length >> 1;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

/** Three significant digits, without an exponent unless very small or large. */
export function figure(value: number): string {
  if (!Number.isFinite(value)) return '–';
  if (value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e6)) return value.toExponential(1);
  return Math.abs(value) >= 100 ? value.toFixed(0) : value.toPrecision(3);
}

/** Wall time of `work` [ms]. */
export async function timed(work: () => void | Promise<void>): Promise<number> {
  const began = performance.now();
  await work();
  return performance.now() - began;
}

/** CPU time of `work`, garbage collection included [ms]. */
export async function cpuTimed(work: () => void | Promise<void>): Promise<number> {
  const before = process.cpuUsage();
  await work();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}

/** Median times of several kinds of work that alternate, so that other load affects them equally [ms]. */
export async function interleaved(
  works: readonly (() => void | Promise<void>)[],
  rounds: number,
  clock = timed,
): Promise<readonly number[]> {
  const times = works.map((): number[] => []);
  for (let round = 0; round <= rounds; round++) {
    for (const [i, work] of works.entries()) {
      const ms = await clock(work);
      // The first round is a warm-up.
      if (round > 0) times[i].push(ms);
    }
  }
  return times.map(median);
}

export function markdown({ columns, rows, remark }: Table): string {
  const line = (cells: readonly (string | number)[]): string =>
    `| ${cells.map((cell) => (typeof cell === 'number' ? figure(cell) : cell)).join(' | ')} |`;
  const head = [line(columns), `|${columns.map(() => '---').join('|')}|`];
  return [...head, ...rows.map(line), ...(remark ? ['', remark] : [])].join('\n');
}
