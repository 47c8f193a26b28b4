import type { RoundSolid } from './roundSolid.ts';

/** A surface bounds at most two stretches of a straight line; a curved one may cross more often. */
const MAX_CANDIDATES = 64;

/**
 * The places on a ray where it enters and leaves a solid. Candidates are the roots of the surfaces that bound it, in any order; between two of them the ray
 * is either inside or outside, which is tested halfway. So entering and leaving alternate, and no ray slips through where two surfaces meet.
 */
export class Crossings {
  readonly s = new Float64Array(MAX_CANDIDATES);
  /** The surface that is crossed. */
  readonly part = new Uint8Array(MAX_CANDIDATES);
  count = 0;

  clear(): void {
    this.count = 0;
  }

  /** Inserts a candidate by increasing s. */
  add(s: number, part: number): void {
    if (this.count === MAX_CANDIDATES || !Number.isFinite(s)) return;
    let i = this.count++;
    for (; i > 0 && this.s[i - 1] > s; i--) {
      this.s[i] = this.s[i - 1];
      this.part[i] = this.part[i - 1];
    }
    this.s[i] = s;
    this.part[i] = part;
  }

  /** Calls `visit` for each crossing between `from` and `to`, by increasing s, until it returns true. `contains`: whether the ray is inside the solid at s. */
  visit(
    from: number,
    to: number,
    contains: (s: number) => boolean,
    visit: (s: number, part: number, entering: boolean) => boolean,
  ): void {
    const { s, part, count } = this;
    if (count === 0) return;
    let inside = contains((Math.max(from, Math.min(s[0], to)) + from) / 2);
    for (let i = 0; i < count; i++) {
      const after = contains((s[i] + (i + 1 < count ? s[i + 1] : to)) / 2);
      if (after === inside) continue;
      inside = after;
      if (visit(s[i], part[i], after)) return;
    }
  }
}

/** Adds the roots of a solid's surfaces on the straight line o + s d in its axes (o x y z, d x y z); o has to be near the solid for accuracy. */
export function addLineRoots({ surfaces }: RoundSolid, line: ArrayLike<number>, crossings: Crossings): void {
  const [ox, oy, oz, dx, dy, dz] = [line[0], line[1], line[2], line[3], line[4], line[5]];
  for (const { a, b, c, d, part } of surfaces) {
    const square = a * (dx * dx + dy * dy) + b * dz * dz;
    const half = a * (ox * dx + oy * dy) + (b * oz + c / 2) * dz;
    const start = a * (ox * ox + oy * oy) + (b * oz + c) * oz + d;
    const discriminant = half * half - square * start;
    if (!(discriminant >= 0)) continue;
    const q = -(half + (half < 0 ? -1 : 1) * Math.sqrt(discriminant));
    crossings.add(q / square, part);
    crossings.add(start / q, part);
  }
}
