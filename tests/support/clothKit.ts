import type { FaceTopology } from '../../src/dynamics/meshSprings.ts';
import { type EarlyStop, integrate, type RunOptions, type SimulationFrame } from '../../src/dynamics/run.ts';
import type { Vec3 } from '../../src/math/vec3.ts';

/** n × n points of a horizontal square metre with quad faces. `at`: position of its first corner [m]. */
export function sheet(n: number, at: Vec3 = [0, 0, 0]): { readonly x: Float64Array; readonly faces: FaceTopology } {
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

/** All frames of a run, and its early stop. */
export interface RecordedRun {
  readonly frames: readonly SimulationFrame[];
  readonly stop: EarlyStop | undefined;
}

export function recordRun(options: RunOptions): RecordedRun {
  const frames: SimulationFrame[] = [];
  const running = integrate(options);
  for (let next = running.next(); ; next = running.next()) {
    if (next.done) return { frames, stop: next.value };
    frames.push(next.value);
  }
}
