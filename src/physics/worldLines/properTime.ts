import { length, scale } from '../../math/vec3.ts';
import { oneMinusBetaSquared } from '../lorentz/boost.ts';
import { type SampledLine, samplePosition } from './samples.ts';
import { asInertial, asPolyline, type WorldLine } from './worldLine.ts';

/**
 * τ = ∫√(1 − β²) dt [s]: what a clock on the world line, set to 0 at world time 0, shows at world time t [s]. c [m/s].
 * undefined on circles and cubics. docs/physics.md §4.13.
 * @example
 * properTimeAt({ kind: 'uniform', position: [0, 0, 0], velocity: [6, 0, 0] }, 5, 10); // 4 s
 */
export function properTimeAt(w: WorldLine, t: number, c: number): number | undefined {
  const inertial = asInertial(w);
  if (inertial) return t * Math.sqrt(oneMinusBetaSquared(scale(inertial.velocity, 1 / c)));
  if (w.kind === 'hyperbolic') {
    const rate = length(w.properAcceleration) / c;
    return (Math.asinh(rate * (t - w.t0)) + Math.asinh(rate * w.t0)) / rate;
  }
  const straight = asPolyline(w);
  return straight && t - lostOn(straight, Math.min(0, t), Math.max(0, t), c) * Math.sign(t);
}

/** ∫(1 − √(1 − β²)) dt over the pieces between two times, without cancellation at low speeds [s]. */
function lostOn(w: SampledLine, from: number, to: number, c: number): number {
  let lost = 0;
  for (let k = 0; k + 1 < w.times.length; k++) {
    const [start, end] = [w.times[k], w.times[k + 1]];
    const part = Math.min(end, to) - Math.max(start, from);
    if (part <= 0) continue;
    const [a, b] = [samplePosition(w, k), samplePosition(w, k + 1)];
    const beta = scale([b[0] - a[0], b[1] - a[1], b[2] - a[2]], 1 / (c * (end - start)));
    lost += (part * length(beta) ** 2) / (1 + Math.sqrt(oneMinusBetaSquared(beta)));
  }
  return lost;
}
