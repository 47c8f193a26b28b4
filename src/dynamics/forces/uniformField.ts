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
  const add = (sum: Float64Array): void => {
    for (let i = 0, j = 0; i < amounts.length; i++, j += 3) {
      sum[j] += amounts[i] * fx;
      sum[j + 1] += amounts[i] * fy;
      sum[j + 2] += amounts[i] * fz;
    }
  };
  return {
    data: { kind: 'uniform', amounts, field: [fx, fy, fz] },
    energy(x) {
      let sum = 0;
      for (let i = 0, j = 0; i < amounts.length; i++, j += 3)
        sum -= amounts[i] * (fx * x[j] + fy * x[j + 1] + fz * x[j + 2]);
      return sum;
    },
    add: (_, sum) => add(sum),
    addDiscreteGradient: (_, __, sum) => add(sum),
    stiffness: () => NO_STIFFNESS,
    addStiffnessBound: () => {},
  };
}

const NO_STIFFNESS: Stiffness = { multiply: () => {}, addBlocks: () => {} };
