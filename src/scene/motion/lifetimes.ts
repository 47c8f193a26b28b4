import type { Lifetime } from './motionTypes.ts';

/** Whether something exists at a world time [s]: birth ≤ t < death, so that of two pieces, one of which follows the other, always one exists. */
export const isAlive = ({ birth, death }: Lifetime, t: number): boolean => t >= birth && t < death;

/** Whether something always exists. */
export const isEternal = ({ birth, death }: Lifetime): boolean =>
  birth === Number.NEGATIVE_INFINITY && death === Number.POSITIVE_INFINITY;

/** The time in which both lifetimes hold; undefined if there is none. */
export function commonLifetime(a: Lifetime, b: Lifetime): Lifetime | undefined {
  const birth = Math.max(a.birth, b.birth);
  const death = Math.min(a.death, b.death);
  return birth < death ? { birth, death } : undefined;
}

/** The times in which one of each list holds. Both lists, and the result, rise and do not overlap. */
export function commonLifetimes(a: readonly Lifetime[], b: readonly Lifetime[]): readonly Lifetime[] {
  const out: Lifetime[] = [];
  for (let i = 0, j = 0; i < a.length && j < b.length; ) {
    const common = commonLifetime(a[i], b[j]);
    if (common) out.push(common);
    if (a[i].death < b[j].death) i++;
    else j++;
  }
  return out;
}
