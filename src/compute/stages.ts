/** What one pass over all points does, all in a row: p is pushed, x goes on, air takes its share of p, x goes on. */
export interface Stage {
  /** p += kick · F(x) [s] */
  readonly kick: number;
  /** x += drift · v [s] */
  readonly drift: number;
  /** p −= damp · p */
  readonly damp: number;
  /** x += after · v, with the new p [s] */
  readonly after: number;
  /** What x went on by since the pass before [s]; 0: F is not asked for. */
  readonly before: number;
}

/**
 * Steps of a splitting, as passes each of which asks for the force once: the half drifts at the end of a step and at the beginning of the next one belong to one pass. `begin` comes once, `within` in each step, then
 * `between` two steps, and `end` after the last. `shares`: as of a `Method`; air: half before a step and half after it.
 */
export interface Stages {
  readonly begin: Stage;
  readonly within: readonly Stage[];
  readonly between: Stage;
  readonly end: Stage;
}

export function stagesOf(shares: readonly number[], h: number, drag: number): Stages {
  const drift = (k: number): number => (((shares[k - 1] ?? 0) + (shares[k] ?? 0)) * h) / 2;
  const [first, last] = [drift(0), drift(shares.length)];
  const damp = (share: number): number => -Math.expm1(-share * drag * h);
  const across = { before: shares.length === 1 ? first + last : drift(shares.length - 1) };
  const inner = shares.slice(0, -1).map((share, k): Stage => {
    const before = k === 0 ? first + last : drift(k);
    return { kick: share * h, drift: drift(k + 1), damp: 0, after: 0, before };
  });
  const kick = shares.at(-1)! * h;
  return {
    begin: { kick: 0, drift: 0, damp: damp(0.5), after: first, before: 0 },
    within: inner,
    between: { kick, drift: last, damp: damp(1), after: first, ...across },
    end: { kick, drift: last, damp: damp(0.5), after: 0, ...across },
  };
}
