import { random } from '../../../src/math/random.ts';
import type { Twin, TwinCase } from '../../../src/shaders/twins/twin.ts';

/** The largest error of one check relative to its tolerance, and its case. */
export interface TwinError {
  readonly check: string;
  readonly error: number;
  readonly tolerance: number;
  readonly stratum: string;
  readonly input: readonly number[];
  readonly gpu: readonly number[];
  readonly cpu: readonly number[];
}

/** The same cases in Node and in the page. */
export const casesOf = (twin: Twin, seed: number): readonly TwinCase[] => twin.cases(random(seed));

/** The worst case of every check. NaN counts as an infinite error. */
export function compareTwin(twin: Twin, cases: readonly TwinCase[], values: ArrayLike<number>): TwinError[] {
  const size = 4 * twin.outputs;
  const worst = new Map<string, TwinError>();
  cases.forEach(({ stratum, input }, i) => {
    const gpu = Array.from({ length: size }, (_, k) => values[i * size + k]);
    const cpu = twin.cpu(input);
    for (const { name, error, tolerance } of twin.checks) {
      const measured = error(gpu, cpu, input);
      const verdict: TwinError = {
        check: name,
        error: Number.isNaN(measured) ? Number.POSITIVE_INFINITY : measured,
        tolerance: tolerance(stratum),
        stratum: stratum.name,
        input,
        gpu,
        cpu,
      };
      const before = worst.get(name);
      if (!before || excess(verdict) > excess(before)) worst.set(name, verdict);
    }
  });
  return [...worst.values()];
}

const excess = ({ error, tolerance }: TwinError): number => (error === 0 ? 0 : error / tolerance);

export const failures = (verdicts: readonly TwinError[]): string[] =>
  verdicts
    .filter(({ error, tolerance }) => !(error <= tolerance))
    .map(
      (v) =>
        `${v.check}: ${v.error.toExponential(1)} > ${v.tolerance} at ${v.stratum}; input ${v.input.join(' ')}; GPU ${v.gpu.join(' ')}; CPU ${v.cpu.join(' ')}`,
    );

/** One line per check, for docs/performance.md and for changes of formulas. */
export const report = (twin: Twin, verdicts: readonly TwinError[]): string =>
  verdicts
    .map((v) => `${twin.name} | ${v.check} | ${v.error.toExponential(1)} of ${v.tolerance} | ${v.stratum}`)
    .join('\n');
