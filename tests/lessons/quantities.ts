import { degrees, radians } from '../../src/math/angle.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { gamma, properVelocity } from '../../src/physics/lorentz/boost.ts';
import { aberrate, terrellRotation } from '../../src/physics/optics/aberration.ts';
import { dopplerAtPixel } from '../../src/physics/optics/doppler.ts';
import { observedWavelength } from '../../src/physics/optics/radiance.ts';

/** A quantity that lessons may claim, by the program's physics and by another route. */
interface CheckedQuantity {
  readonly computed: (...of: number[]) => number;
  readonly closedForm: (...of: number[]) => number;
}

/** A direction at an angle [°] from that of motion. */
const at = (angle: number): Vec3 => [Math.sin(radians(angle)), 0, Math.cos(radians(angle))];
const along = (beta: number): Vec3 => properVelocity([0, 0, beta]);
const angleFrom = (n: Vec3): number => degrees(Math.atan2(Math.hypot(n[0], n[1]), n[2]));

/** By the names of claims. Speeds in units of c, angles in degrees from the direction of motion, wavelengths in nm. */
export const QUANTITIES: Readonly<Record<string, CheckedQuantity>> = {
  gamma: {
    computed: (beta) => gamma(along(beta!)),
    closedForm: (beta) => Math.cosh(Math.atanh(beta!)),
  },
  /** Of a moving clock: 1/γ. */
  clockRate: {
    computed: (beta) => 1 / gamma(along(beta!)),
    closedForm: (beta) => Math.sqrt(1 - beta! ** 2),
  },
  contraction: {
    computed: (beta) => 1 / gamma(along(beta!)),
    closedForm: (beta) => Math.cos(Math.asin(beta!)),
  },
  /** Where a star at an angle is seen. */
  aberration: {
    computed: (beta, angle) => angleFrom(aberrate(at(angle!), along(beta!))),
    closedForm: (beta, angle) =>
      degrees(2 * Math.atan(Math.sqrt((1 - beta!) / (1 + beta!)) * Math.tan(radians(angle!) / 2))),
  },
  /** From where rain that falls upright at 1 comes for one who runs at β: velocities added as before relativity. */
  rainAngle: {
    computed: (beta) => angleFrom([1, 0, beta!]),
    closedForm: (beta) => degrees(Math.acos(beta! / Math.sqrt(1 + beta! ** 2))),
  },
  /** D of what rests and is seen at an angle. */
  doppler: {
    computed: (beta, angle) => dopplerAtPixel(at(angle!), along(beta!)),
    closedForm: (beta, angle) => Math.sqrt(1 - beta! ** 2) / (1 - beta! * Math.cos(radians(angle!))),
  },
  /** The wavelength with which light was emitted that is seen straight ahead with another. */
  emittedWavelength: {
    computed: (seen, beta) => observedWavelength(seen!, 1 / dopplerAtPixel([0, 0, 1], along(beta!))),
    closedForm: (seen, beta) => seen! * Math.exp(Math.atanh(beta!)),
  },
  /** The seen angle without a shift. */
  neutralAngle: {
    computed: (beta) => {
      let [low, high] = [0, 180];
      for (let i = 0; i < 60; i++) {
        const middle = (low + high) / 2;
        if (dopplerAtPixel(at(middle), along(beta!)) > 1) low = middle;
        else high = middle;
      }
      return low;
    },
    closedForm: (beta) => degrees(Math.acos(Math.tanh(Math.atanh(beta!) / 2))),
  },
  /** How far a body is turned that is seen at right angles to its motion. */
  terrellRotation: {
    computed: (beta) => degrees(terrellRotation([1, 0, 0], along(beta!))),
    closedForm: (beta) => degrees(Math.asin(beta!)),
  },
};
