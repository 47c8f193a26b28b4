import { dot, length, sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { gamma } from '../../lorentz/boost.ts';
import { type RetardedEvent, staticEmission } from '../emission.ts';
import { firstAfter, restsOutsideSamples, type SampledLine, samplePosition, samplesUntil } from '../samples.ts';
import { type SimultaneousEvent, uniformSlice } from '../slice.ts';
import type { ObserverEvent, WorldLineKind } from './worldLineKind.ts';

/** The piece of a line between samples i and i + 1; arguments as those of `WorldLineKind`. */
export interface PieceKind<W extends SampledLine> {
  positionAt(w: W, i: number, t: number): Vec3;
  velocityAt(w: W, i: number, t: number): Vec3;
  /** Given that the piece crosses the past light cone. */
  pastLightCone(w: W, i: number, observer: ObserverEvent, c: number): RetardedEvent;
  /** Given that the piece crosses the slice. */
  simultaneitySlice(w: W, i: number, observer: ObserverEvent, u: Vec3, c: number): SimultaneousEvent;
}

/** Sample i relative to the observer's event: Δx [m] and c(t − t_o) [m of light]. */
export const relativePosition = (w: SampledLine, i: number, { position }: ObserverEvent): Vec3 =>
  sub(samplePosition(w, i), position);
export const relativeTime = (w: SampledLine, i: number, { t }: ObserverEvent, c: number): number =>
  c * (w.times[i] - t);

type Shared = 'positionAt' | 'velocityAt' | 'pastLightCone' | 'simultaneitySlice' | 'asInertial' | 'referencePosition';

/** What kinds of sampled lines have in common: bisection finds the piece, which is solved by itself. docs/physics.md §4.7. */
export const sampledLine = <W extends SampledLine>(piece: PieceKind<W>): Pick<WorldLineKind<W>, Shared> => ({
  positionAt(w, t) {
    const i = samplesUntil(w.times, t);
    if (i === 0) return samplePosition(w, 0);
    if (i === w.times.length) return samplePosition(w, i - 1);
    return piece.positionAt(w, i - 1, t);
  },
  velocityAt: (w, t) => (restsOutsideSamples(w, t) ? ZERO : piece.velocityAt(w, samplesUntil(w.times, t) - 1, t)),
  /** f(t) = |x(t) − x_o| − c(t_o − t) increases while the speed is below c. */
  pastLightCone(w, observer, c) {
    const offset = (i: number) => relativePosition(w, i, observer);
    const after = firstAfter(w.times.length, (i) => length(offset(i)) + relativeTime(w, i, observer, c) <= 0);
    if (after === 0) return staticEmission(offset(0));
    if (after === w.times.length) return staticEmission(offset(after - 1));
    return piece.pastLightCone(w, after - 1, observer, c);
  },
  /** c(t − t_o) − β·Δx increases along the world line. */
  simultaneitySlice(w, observer, u, c) {
    const g = gamma(u);
    const offset = (i: number) => relativePosition(w, i, observer);
    const after = firstAfter(w.times.length, (i) => g * relativeTime(w, i, observer, c) - dot(u, offset(i)) <= 0);
    if (after === 0) return uniformSlice(offset(0), 0, ZERO, u);
    if (after === w.times.length) return uniformSlice(offset(after - 1), 0, ZERO, u);
    return piece.simultaneitySlice(w, after - 1, observer, u, c);
  },
  asInertial: () => undefined,
  referencePosition: (w) => samplePosition(w, 0),
});
