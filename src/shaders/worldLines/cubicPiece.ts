import { abs, Break, clamp, float, If, int, Loop, select } from 'three/tsl';
import { fullVelocity } from '../kinematics/fullVelocity.ts';
import type { Float, Int, Vec3, Vec4 } from '../types.ts';

/** The velocities [c] at the start and the end of the piece after a sample. */
export type EndVelocities = (index: Int) => { readonly begin: Vec3; readonly end: Vec3 };

/** x = a + s(begin + w(bend + w twist)), w = s/span: positions relative to the anchor [m], times in light-metres. docs/physics.md §4.8. */
export interface ShaderCubic {
  readonly a: Vec4;
  readonly b: Vec4;
  readonly begin: Vec3;
  readonly bend: Vec3;
  readonly twist: Vec3;
  readonly span: Float;
}

/** The cubic between two samples (x, y, z, t); twin of `cubicAt` in physics/. */
export function cubicPiece(a: Vec4, b: Vec4, { begin, end }: ReturnType<EndVelocities>): ShaderCubic {
  const span = b.w.sub(a.w).max(1e-30).toVar();
  const chord = b.xyz.sub(a.xyz).div(span).toVar();
  const first = begin.sub(chord).toVar();
  const last = end.sub(chord).toVar();
  return {
    a,
    b,
    span,
    begin: begin.toVar(),
    bend: first.mul(-2).sub(last).toVar(),
    twist: first.add(last).toVar(),
  };
}

/** Position and (v, 1 − v²) at the time `s` after the start of a piece. */
export function evaluateCubic(piece: ShaderCubic, s: Float): { readonly x: Vec3; readonly velocity: Vec4 } {
  const { a, begin, bend, twist, span } = piece;
  const w = s.div(span).toVar();
  const x = a.xyz.add(begin.add(bend.add(twist.mul(w)).mul(w)).mul(s)).toVar();
  const v = begin
    .add(
      bend
        .mul(2)
        .add(twist.mul(w.mul(3)))
        .mul(w),
    )
    .toVar();
  return { x, velocity: fullVelocity(v).toVar() };
}

/** Newton's iteration ends at a step below this fraction of the piece, or after `MAX_STEPS`. */
const RELATIVE_STEP = 3e-7;
const MAX_STEPS = 16;

/**
 * The time after the start of a piece at which `miss`, an increasing function with value and slope, is 0: Newton's steps from `guess`, replaced by
 * bisection where a step would leave the current bracket. Twin of `safeguardedNewton` in math/.
 */
export function cubicRoot(
  piece: ShaderCubic,
  guess: Float,
  miss: (s: Float, x: Vec3, velocity: Vec4) => { readonly value: Float; readonly slope: Float },
): Float {
  const s = clamp(guess, 0, piece.span).toVar();
  const low = float(0).toVar();
  const high = float(piece.span).toVar();
  Loop({ start: int(0), end: int(MAX_STEPS), type: 'int', condition: '<' }, () => {
    const { x, velocity } = evaluateCubic(piece, s);
    const { value, slope } = miss(s, x, velocity);
    const missed = value.toVar();
    If(missed.lessThanEqual(0), () => {
      low.assign(s);
    }).Else(() => {
      high.assign(s);
    });
    const newton = s.sub(missed.div(slope)).toVar();
    const inside = newton.greaterThanEqual(low).and(newton.lessThanEqual(high));
    const next = select(inside, newton, low.add(high).mul(0.5)).toVar();
    const step = abs(next.sub(s)).toVar();
    s.assign(next);
    If(step.lessThanEqual(piece.span.mul(RELATIVE_STEP)), () => {
      Break();
    });
  });
  return s;
}
