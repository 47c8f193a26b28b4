import type { Vec3 } from '../../math/vec3.ts';
import type { Force, Stiffness } from './force.ts';

/** The same force everywhere, times what a point has of it: V = −Σ a_i f·x_i. Weight: a = m, f = g [m/s²]; an electric field: a = q, f = E [V/m]. */
export function uniform(amounts: Float64Array, f: Vec3): Force {
  const add = (sum: Float64Array): void => {
    for (let i = 0; i < amounts.length; i++) for (let k = 0; k < 3; k++) sum[3 * i + k] += amounts[i] * f[k];
  };
  return {
    energy(x) {
      let sum = 0;
      for (let i = 0; i < amounts.length; i++)
        sum -= amounts[i] * (f[0] * x[3 * i] + f[1] * x[3 * i + 1] + f[2] * x[3 * i + 2]);
      return sum;
    },
    add: (_, sum) => add(sum),
    addMean: (_, __, sum) => add(sum),
    stiffness: () => NONE,
    addRigidity: () => {},
  };
}

const NONE: Stiffness = { multiply: () => {}, addBlocks: () => {} };
