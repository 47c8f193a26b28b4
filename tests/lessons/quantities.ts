import { type FlightConditions, flyArc, flyArcs } from '../../src/flight/arc.ts';
import { type FlightState, flightOf } from '../../src/flight/flightState.ts';
import { durationOf, planTrip } from '../../src/flight/trip.ts';
import { degrees, radians } from '../../src/math/angle.ts';
import { IDENTITY } from '../../src/math/quat.ts';
import { type Vec3, ZERO } from '../../src/math/vec3.ts';
import { SPEED_OF_LIGHT } from '../../src/physics/constants.ts';
import { boost, gamma, properVelocity } from '../../src/physics/lorentz/boost.ts';
import { aberrate, terrellRotation } from '../../src/physics/optics/aberration.ts';
import { dopplerAtPixel } from '../../src/physics/optics/doppler.ts';
import { bolometricRadiance, observedWavelength } from '../../src/physics/optics/radiance.ts';

/** A quantity that lessons may claim, by the program's physics and by another route. */
interface CheckedQuantity {
  readonly computed: (...of: number[]) => number;
  readonly closedForm: (...of: number[]) => number;
}

/** A direction at an angle [°] from that of motion. */
const at = (angle: number): Vec3 => [Math.sin(radians(angle)), 0, Math.cos(radians(angle))];
const along = (beta: number): Vec3 => properVelocity([0, 0, beta]);
const angleFrom = (n: Vec3): number => degrees(Math.atan2(Math.hypot(n[0], n[1]), n[2]));

/** A Julian year [s]. */
const YEAR = 31_557_600;
/** An acceleration [m/s²] in light years a year². */
const perYear = (a: number): number => (a * YEAR) / SPEED_OF_LIGHT;
const REST: FlightState = flightOf({ t: 0, position: ZERO, u: ZERO, orientation: IDENTITY, properTime: 0 });
const YEARS: FlightConditions = { c: 1, lock: 'free', playing: true };
/** A trip over light years at a [m/s²], in years. */
const trip = (distance: number, a: number) =>
  planTrip(REST, [0, 0, distance], { c: 1, acceleration: perYear(a), limit: 300 });
/** Rapidity half-way. */
const halfWay = (distance: number, a: number): number => Math.acosh(1 + (perYear(a) * distance) / 2);

/** By the names of claims. Speeds in units of c, accelerations in m/s², distances in light years, angles in degrees from the direction of motion, wavelengths in nm. */
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
  /** Of a body with a length at rest [m]. */
  contractedLength: {
    computed: (own, beta) => own! / gamma(along(beta!)),
    closedForm: (own, beta) => own! * Math.cos(Math.asin(beta!)),
  },
  /** How far apart in time [s] events are for one who moves at β along the line [m] between them, and that are simultaneous where light goes at c [m/s]. */
  simultaneityShift: {
    computed: (distance, beta, c) => -boost([0, 0, 0, distance!], along(beta!))[0] / c!,
    closedForm: (distance, beta, c) => (Math.sinh(Math.atanh(beta!)) * distance!) / c!,
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
  /** How many times as bright a surface at rest is that is seen at an angle. */
  bolometric: {
    computed: (beta, angle) => bolometricRadiance(1, dopplerAtPixel(at(angle!), along(beta!))),
    closedForm: (beta, angle) => ((1 - beta! ** 2) / (1 - beta! * Math.cos(radians(angle!))) ** 2) ** 2,
  },
  /** Time in which a speed grows by c before relativity [years]. */
  newtonYears: {
    computed: (a) => 1 / perYear(a!),
    closedForm: (a) => SPEED_OF_LIGHT / a! / 86_400 / 365.25,
  },
  /** Speed after years of one's own at 9.81 m/s². */
  speedAfter: {
    computed: (own) => {
      const push = { direction: [0, 0, 1] as const, size: perYear(9.81) };
      return Math.tanh(flyArc(REST, { dTau: own!, push }, YEARS).velocity.rapidity);
    },
    closedForm: (own) => {
      const gained = Math.exp(2 * perYear(9.81) * own!);
      return (gained - 1) / (gained + 1);
    },
  },
  /** Greatest speed of a trip with a turn-around half-way. */
  tripTopSpeed: {
    computed: (distance, a) => {
      const [first] = trip(distance!, a!);
      return Math.tanh(flyArc(REST, first!, YEARS).velocity.rapidity);
    },
    closedForm: (distance, a) => Math.sqrt(1 - 1 / (1 + (perYear(a!) * distance!) / 2) ** 2),
  },
  /** Years that the trip takes on board. */
  tripOwnYears: {
    computed: (distance, a) => durationOf(trip(distance!, a!)),
    closedForm: (distance, a) => (2 * halfWay(distance!, a!)) / perYear(a!),
  },
  /** Years that it takes at home. */
  tripWorldYears: {
    computed: (distance, a) => flyArcs(REST, trip(distance!, a!), YEARS).t.value,
    closedForm: (distance, a) => Math.sqrt(distance! ** 2 + (4 * distance!) / perYear(a!)),
  },
};
