import {
  acos,
  atan,
  clamp,
  cos,
  cross,
  dot,
  float,
  If,
  int,
  Loop,
  length,
  min,
  mix,
  normalize,
  select,
  sin,
  vec3,
} from 'three/tsl';
import type { Float, Int, Vec3 } from '../shaders/types.ts';

/** What a lamp covers of the sky above a place: `count` corners, one after the other, relative to that place. */
export interface Outline {
  readonly count: number;
  corner(k: Int): Vec3;
}

/** A face with the half axes X and Y: 4 corners for a rectangle, 16 with the area of the circle for a disk. */
export function faceOutline(kind: 'rect' | 'disk', centre: Vec3, X: Vec3, Y: Vec3): Outline {
  const [count, first] = kind === 'rect' ? [4, Math.PI / 4] : [16, 0];
  const step = (2 * Math.PI) / count;
  const reach = kind === 'rect' ? Math.SQRT2 : Math.sqrt(step / Math.sin(step));
  return {
    count,
    corner: (k) => {
      const angle = float(k).mul(step).add(first).toVar();
      return centre.add(X.mul(cos(angle).mul(reach))).add(Y.mul(sin(angle).mul(reach)));
    },
  };
}

/** Each end of a tube has so many corners. */
const END = 7;

/**
 * The side of a tube with the half axis X, as it is seen: between the two lines where it turns away, with half a circle at each end.
 * From its inside nothing.
 */
export function tubeOutline(centre: Vec3, X: Vec3, radius: Float): Outline {
  const axis = normalize(X).toVar();
  const across = centre.sub(axis.mul(dot(centre, axis))).toVar();
  const away = length(across).max(1e-9).toVar();
  const e = across.div(away).negate().toVar();
  const s = cross(axis, e).toVar();
  const open = acos(min(radius.div(away), 1)).toVar();
  return {
    count: 2 * END,
    corner: (k) => {
      const far = k.greaterThanEqual(int(END));
      const step = float(select(far, int(2 * END - 1).sub(k), k)).div((END - 1) / 2);
      const phi = open.mul(step.sub(1)).toVar();
      const rim = e
        .mul(cos(phi))
        .add(s.mul(sin(phi)))
        .mul(radius);
      return centre.add(X.mul(select(far, float(-1), float(1)))).add(rim);
    },
  };
}

/**
 * Irradiance on a surface with the unit normal N, over the radiance of all that is within an outline of unit directions: ½ Σ θ (a × b)·N/sin θ
 * over its edges, cut off at the horizon. Source: Lambert 1760, Photometria; Baum et al. 1989, "Improving radiosity solutions", SIGGRAPH, eq. 3.
 */
export function outlineIrradiance({ count, corner }: Outline, N: Vec3): Float {
  const sum = float(0).toVar();
  const [rises, sets] = [vec3(0).toVar(), vec3(0).toVar()];
  const a = corner(int(count - 1)).toVar();
  Loop({ start: int(0), end: int(count), type: 'int', condition: '<' }, ({ i }) => {
    const b = corner(int(i)).toVar();
    const [ha, hb] = [dot(a, N).toVar(), dot(b, N).toVar()];
    const crossing = normalize(mix(a, b, clamp(ha.div(ha.sub(hb)), 0, 1))).toVar();
    const [up, down] = [ha.greaterThanEqual(0).toVar(), hb.lessThan(0).toVar()];
    If(up.and(down), () => {
      sum.addAssign(edge(a, crossing, N));
      sets.assign(crossing);
    })
      .ElseIf(up, () => {
        sum.addAssign(edge(a, b, N));
      })
      .ElseIf(down.not(), () => {
        sum.addAssign(edge(crossing, b, N));
        rises.assign(crossing);
      });
    a.assign(b);
  });
  return sum
    .add(edge(sets, rises, N))
    .abs()
    .mul(0.5);
}

/** θ (a × b)·N/sin θ; 0 where there is no edge. */
function edge(a: Vec3, b: Vec3, N: Vec3): Float {
  const turn = cross(a, b).toVar();
  const sine = length(turn).toVar();
  const rate = select(sine.greaterThan(1e-4), atan(sine, dot(a, b)).div(sine.max(1e-6)), float(1));
  return rate.mul(dot(turn, N));
}
