import { addScaled, dot, sub, type Vec3 } from '../../math/vec3.ts';
import { mapVectors } from '../../math/vec3Arrays.ts';
import { gamma, velocity } from '../lorentz/boost.ts';
import type { ObserverEvent } from './kinds/worldLineKind.ts';
import type { NewtonOptions } from './lightCone.ts';
import type { SimultaneousEvent } from './slice.ts';
import { positionAt, velocityAt, type WorldLine, worldLineKind } from './worldLine.ts';

// Events with Δt′ = 0 in the observer's frame (docs/physics.md §5).

/**
 * The event of `w` with Δt′ = 0 for an observer with proper velocity u at `observer`, in relative form. c [m/s]. docs/physics.md §5.1.
 * @example
 * // What rests 5 m ahead, at the moment of an observer at 0.6 c: 3 m of light later than in the world.
 * const line: WorldLine = { kind: 'static', position: [5, 0, 0] };
 * simultaneitySlice(line, { t: 0, position: [0, 0, 0] }, [0.75, 0, 0], 10); // { offset: [5, 0, 0], ahead: 3 } m
 */
export const simultaneitySlice = (w: WorldLine, observer: ObserverEvent, u: Vec3, c: number): SimultaneousEvent =>
  worldLineKind(w).simultaneitySlice(w, observer, u, c);

/**
 * World time [s] of the event of `w` that is simultaneous with the observer's event in the observer's frame:
 * c(t − t_o) = β·(x(t) − x_o). u: the observer's γβ, world frame. c [m/s].
 * @example
 * const line: WorldLine = { kind: 'static', position: [5, 0, 0] };
 * simultaneousTime(line, { t: 0, position: [0, 0, 0] }, [0.75, 0, 0], 10); // 0.3 s
 */
export const simultaneousTime = (w: WorldLine, observer: ObserverEvent, u: Vec3, c: number): number =>
  observer.t + simultaneitySlice(w, observer, u, c).ahead / c;

/**
 * Damped Newton iteration t ← t − k f/f′, started at t_o, for comparison with `simultaneousTime`: f = c(t − t_o) − β·(x(t) − x_o), f′ = c − β·v > 0.
 * World time after the last step [s]. u: the observer's γβ, world frame. c [m/s]. docs/physics.md §5.6.
 * @example
 * const line: WorldLine = { kind: 'static', position: [5, 0, 0] };
 * const observer = { t: 0, position: [0, 0, 0] } as const;
 * newtonSimultaneousTime(line, observer, [0.75, 0, 0], 10, { iterations: 1, damping: 0.5 }); // 0.15 s
 * newtonSimultaneousTime(line, observer, [0.75, 0, 0], 10, { iterations: 1, damping: 1 }); // 0.3 s
 */
export function newtonSimultaneousTime(
  w: WorldLine,
  observer: ObserverEvent,
  u: Vec3,
  c: number,
  options: NewtonOptions,
): number {
  const beta = velocity(u);
  let t = observer.t;
  for (let i = 0; i < options.iterations; i++) {
    const miss = c * (t - observer.t) - dot(beta, sub(positionAt(w, t, c), observer.position));
    t -= (options.damping * miss) / (c - dot(beta, velocityAt(w, t, c)));
  }
  return t;
}

/**
 * `simultaneousTime` of many world lines [s].
 * @example
 * const lines: WorldLine[] = [{ kind: 'static', position: [5, 0, 0] }, { kind: 'static', position: [-5, 0, 0] }];
 * simultaneousTimes(lines, { t: 0, position: [0, 0, 0] }, [0.75, 0, 0], 10); // [0.3, -0.3] s
 */
export function simultaneousTimes(
  lines: readonly WorldLine[],
  observer: ObserverEvent,
  u: Vec3,
  c: number,
  out = new Float64Array(lines.length),
): Float64Array {
  for (let i = 0; i < lines.length; i++) out[i] = simultaneousTime(lines[i], observer, u, c);
  return out;
}

/**
 * Position of a simultaneous event in the observer's frame: Δx′ = Δx − γ/(γ + 1)(β·Δx)β, for Δx with cΔt = β·Δx.
 * Δx [m]: world frame, observer → event. u: the observer's γβ. docs/physics.md §5.5.
 * @example
 * simultaneousPosition([5, 0, 1], [0.75, 0, 0]); // [4, 0, 1] m
 */
export function simultaneousPosition(dx: Vec3, u: Vec3): Vec3 {
  const g = gamma(u);
  return addScaled(dx, u, -dot(u, dx) / (g * (g + 1)));
}

/**
 * `simultaneousPosition` of many events, 3 numbers each [m]. `out` may be `dx` itself.
 * @example
 * simultaneousPositions(new Float64Array([5, 0, 1, 0, 5, 0]), [0.75, 0, 0]); // [4, 0, 1, 0, 5, 0]
 */
export const simultaneousPositions = (dx: Float64Array, u: Vec3, out = new Float64Array(dx.length)): Float64Array =>
  mapVectors(dx, out, (v) => simultaneousPosition(v, u));

/**
 * Lorentz contraction: the offset between two points of a rigid body at one world time, from the offset in its rest frame.
 * Lengths along u are divided by γ. The same formula as `simultaneousPosition` (docs/physics.md §5.5); not what is seen.
 * offset [m]: rest frame (axes carried by the pure boost) → world frame. u: the body's γβ.
 * @example
 * contraction([5, 0, 1], properVelocity([0.6, 0, 0])); // [4, 0, 1] m
 */
export const contraction = (offset: Vec3, u: Vec3): Vec3 => simultaneousPosition(offset, u);
