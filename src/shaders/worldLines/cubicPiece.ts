import { abs, Break, clamp, float, If, int, Loop, length, select, vec4 } from 'three/tsl';
import type { Float, Int, Vec3, Vec4 } from '../types.ts';

/** The velocities [c] with which the piece after a sample begins and ends. */
export type EndVelocities = (index: Int) => { readonly begin: Vec3; readonly end: Vec3 };

/** x = a + s(begin + w(bend + w twist)), w = s/span: places relative to the anchor [m], times in light-metres. */
export interface ShaderCubic {
  readonly a: Vec4;
  readonly b: Vec4;
  readonly begin: Vec3;
  readonly bend: Vec3;
  readonly twist: Vec3;
  readonly span: Float;
}

/** The cubic between two samples (x, y, z, t). As `cubicAt` of physics/. */
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

/** Place and (v, 1 − v²) so long after the beginning of a piece. */
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
  const speed = length(v).toVar();
  return { x, velocity: vec4(v, speed.oneMinus().mul(speed.add(1))).toVar() };
}

/** Newton's steps end when they are smaller than this share of the piece, and after so many. */
const RELATIVE_STEP = 3e-7;
const MAX_STEPS = 16;

/**
 * How long after the beginning of a piece `miss` is 0, a function that rises along it; its slope too. Newton's steps from `guess`; one that
 * would leave the bracket that is known by then halves it instead. As `safeguardedNewton` of math/.
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
