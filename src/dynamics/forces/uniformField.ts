import type { Vec3 } from '../../math/vec3.ts';
import type { Force, Stiffness } from './force.ts';

/**
 * A uniform field, scaled per point: V = −Σ a_i f·x_i. Weight: a = m, f = g [m/s²]; an electric field: a = q, f = E
 * [V/m].
 * @example
 * // Half a kilogram, 2 m up.
 * uniformField(Float64Array.of(0.5), [0, -9.81, 0]).energy(Float64Array.of(0, 2, 0)); // 9.81 J
 */
export function uniformField(amounts: Float64Array, [fx, fy, fz]: Vec3): Force {
  const add = (sum: Float64Array): void => addField(sum, amounts, fx, fy, fz, 0, amounts.length);
  return {
    data: { kind: 'uniform', amounts, field: [fx, fy, fz] },
    energy(x) {
      let sum = 0;
      for (let i = 0, j = 0; i < amounts.length; i++, j += 3)
        sum -= amounts[i] * (fx * x[j] + fy * x[j + 1] + fz * x[j + 2]);
      return sum;
    },
    add: (_, sum) => add(sum),
    bind: (_, sum, first, end) => () => addField(sum, amounts, fx, fy, fz, first, end),
    addDiscreteGradient: (_, __, sum) => add(sum),
    stiffness: () => NO_STIFFNESS,
    addStiffnessBound: () => {},
  };
}

function addField(
  sum: Float64Array,
  amounts: Float64Array,
  fx: number,
  fy: number,
  fz: number,
  first: number,
  end: number,
): void {
  for (let i = first, j = 3 * first; i < end; i++, j += 3) {
    sum[j] += amounts[i] * fx;
    sum[j + 1] += amounts[i] * fy;
    sum[j + 2] += amounts[i] * fz;
  }
}

const NO_STIFFNESS: Stiffness = { multiply: () => {}, addBlocks: () => {} };
