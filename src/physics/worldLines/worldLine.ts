import { scale, type Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../lorentz/boost.ts';
import { CIRCULAR_LINE, type CircularLine } from './kinds/circularLine.ts';
import { CUBIC_LINE, type CubicLine } from './kinds/cubicLine.ts';
import { HYPERBOLIC_LINE, type HyperbolicLine } from './kinds/hyperbolicLine.ts';
import { POLYLINE_LINE, type PolylineLine } from './kinds/polylineLine.ts';
import { STATIC_LINE, type StaticLine } from './kinds/staticLine.ts';
import { UNIFORM_LINE, type UniformLine } from './kinds/uniformLine.ts';
import type { InertialLine, WorldLineKind } from './kinds/worldLineKind.ts';
import type { SampledLine } from './samples.ts';

/** The world line of one point in the world frame; SI units. */
export type WorldLine = StaticLine | UniformLine | HyperbolicLine | CircularLine | PolylineLine | CubicLine;

/** The kinds of world lines, a record each (docs/adr/0022-motion-kinds.md). */
const WORLD_LINES: { readonly [K in WorldLine['kind']]: WorldLineKind<Extract<WorldLine, { readonly kind: K }>> } = {
  static: STATIC_LINE,
  uniform: UNIFORM_LINE,
  hyperbolic: HYPERBOLIC_LINE,
  circular: CIRCULAR_LINE,
  polyline: POLYLINE_LINE,
  cubic: CUBIC_LINE,
};

export const worldLineKind = ({ kind }: WorldLine): WorldLineKind<WorldLine> => WORLD_LINES[kind];

// What the functions mean: kinds/worldLineKind.ts.

/**
 * x(t) in the world frame [m]; t: world time [s]; c [m/s] is used only for hyperbolic motion.
 * @example
 * // Constant proper acceleration of 10 m/s², with c = 10 m/s: x = (c²/a)(√(1 + (at/c)²) − 1).
 * const line: WorldLine = { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: [10, 0, 0], t0: 0 };
 * positionAt(line, 1, 10); // [4.142, 0, 0] m
 */
export const positionAt = (w: WorldLine, t: number, c: number): Vec3 => worldLineKind(w).positionAt(w, t, c);

/**
 * dx/dt in the world frame [m/s]. At a sample, the velocity of the piece that starts there.
 * @example
 * const line: WorldLine = { kind: 'hyperbolic', position: [0, 0, 0], properAcceleration: [10, 0, 0], t0: 0 };
 * velocityAt(line, 1, 10); // [7.071, 0, 0] m/s
 */
export const velocityAt = (w: WorldLine, t: number, c: number): Vec3 => worldLineKind(w).velocityAt(w, t, c);

/** γβ in the world frame, finite also where the velocity is c to the last bit. */
export const properVelocityAt = (w: WorldLine, t: number, c: number): Vec3 =>
  worldLineKind(w).properVelocityAt?.(w, t, c) ?? properVelocity(scale(velocityAt(w, t, c), 1 / c));

export const asInertial = (w: WorldLine): InertialLine | undefined => worldLineKind(w).asInertial(w);
export const asPolyline = (w: WorldLine): SampledLine | undefined => worldLineKind(w).asPolyline(w);
export const referencePosition = (w: WorldLine): Vec3 => worldLineKind(w).referencePosition(w);
export const hullPoints = (w: WorldLine, from: number, to: number, c: number): readonly Vec3[] =>
  worldLineKind(w).hullPoints(w, from, to, c);
