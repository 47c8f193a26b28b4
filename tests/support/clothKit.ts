import type { Faces } from '../../src/dynamics/nets.ts';
import { type Frame, type Order, run, type Stop } from '../../src/dynamics/run.ts';
import type { Vec3 } from '../../src/math/vec3.ts';

/** n × n points of a level square of a metre, by quads. `at`: of its first corner [m]. */
export function sheet(n: number, at: Vec3 = [0, 0, 0]): { readonly x: Float64Array; readonly faces: Faces } {
  const x = new Float64Array(3 * n * n);
  const corners: number[] = [];
  for (let i = 0; i < n; i++)
    for (let j = 0; j < n; j++) {
      const a = i * n + j;
      x.set([at[0] + j / (n - 1), at[1], at[2] + i / (n - 1)], 3 * a);
      if (i + 1 < n && j + 1 < n) corners.push(a, a + 1, a + n + 1, a + n);
    }
  return { x, faces: { counts: new Uint8Array((n - 1) ** 2).fill(4), corners } };
}

/** All that a run gives. */
export interface Ran {
  readonly frames: readonly Frame[];
  readonly stop: Stop | undefined;
}

export function ranThrough(order: Order): Ran {
  const frames: Frame[] = [];
  const running = run(order);
  for (let next = running.next(); ; next = running.next()) {
    if (next.done) return { frames, stop: next.value };
    frames.push(next.value);
  }
}
