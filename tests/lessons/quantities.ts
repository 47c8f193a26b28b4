import { plannedFlight } from '../../src/editor/lessons/plannedFlight.ts';
import { type FlightConditions, flyArc, flyArcs } from '../../src/flight/arc.ts';
import { type FlightState, flightOf, observerOf } from '../../src/flight/flightState.ts';
import { FlightPlayback } from '../../src/flight/recording/playback.ts';
import { durationOf, planTrip } from '../../src/flight/trip.ts';
import { degrees, radians } from '../../src/math/angle.ts';
import { IDENTITY } from '../../src/math/quat.ts';
import { length, type Vec3, ZERO } from '../../src/math/vec3.ts';
import { SPEED_OF_LIGHT } from '../../src/physics/constants.ts';
import { boost, gamma, properVelocity, velocity } from '../../src/physics/lorentz/boost.ts';
import { addVelocities, fourAcceleration } from '../../src/physics/lorentz/velocity.ts';
import { aberrate, terrellRotation } from '../../src/physics/optics/aberration.ts';
import { dopplerAtPixel } from '../../src/physics/optics/doppler.ts';
import { bolometricRadiance, observedWavelength } from '../../src/physics/optics/radiance.ts';
import { properTimeBetween } from '../../src/physics/worldLines/properTime.ts';
import { positionAt, type WorldLine } from '../../src/physics/worldLines/worldLine.ts';
import { objectClocks } from '../../src/scene/clocks/clock.ts';
import { readClock } from '../../src/scene/clocks/readClock.ts';
import { makeObject, restingAt } from '../../src/scene/defaults.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';

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

/** The clock that stays at the origin. */
const [HOME] = objectClocks([makeObject({ path: '/Home', mesh: sphere(1), motion: restingAt(ZERO) })], 1);
/** What it shows, in two ways, to one who left it at 0 and has coasted at β for own seconds, then turned at once and coasted back for others. */
const homeClock = (beta: number, out: number, back?: number) => {
  const parts = [{ kind: 'coast', beta: [0, 0, beta], lasts: out } as const];
  const turned = back === undefined ? [] : [{ kind: 'coast', beta: [0, 0, -beta], lasts: back } as const];
  const flight = new FlightPlayback(plannedFlight([...parts, ...turned], REST, 1));
  // At the turn itself the later part is flown.
  const { seen, slice } = readClock(HOME!, observerOf(flight.stateAt(out + (back ?? 0))), 1);
  if (typeof seen === 'string' || typeof slice === 'string') throw new Error('the clock is always there');
  return { seen: seen.properTime, slice: slice.properTime };
};

/** A fall from rest by a height [m] under a constant force, 9.81 N for each kilogram: a constant proper acceleration. c [m/s]. */
const fallen = (height: number, c: number): FlightState => {
  // cosh − 1 without cancellation.
  const rapidity = 2 * Math.asinh(Math.sqrt((9.81 * height) / (2 * c ** 2)));
  const push = { direction: [0, 0, 1] as const, size: 9.81 };
  return flyArc(REST, { dTau: (rapidity * c) / 9.81, push }, { ...YEARS, c });
};

/** dp/dt = F along the circle: of proper velocity and angle below the level, by Runge and Kutta, until it is upright [s]. */
function quarterByMomentum(c: number): number {
  const speed = (u: number): number => (c * u) / gamma([0, 0, u]);
  const step = (u: number, angle: number, h: number): readonly [number, number] => {
    const rates = [[0, 0]];
    for (const part of [0, 0.5, 0.5, 1]) {
      const [du, da] = rates.at(-1)! as [number, number];
      rates.push([(9.81 * Math.cos(angle + part * h * da)) / c, speed(u + part * h * du)]);
    }
    const mean = (i: number) => (rates[1]![i]! + 2 * rates[2]![i]! + 2 * rates[3]![i]! + rates[4]![i]!) / 6;
    return [u + h * mean(0), angle + h * mean(1)];
  };
  let [t, u, angle] = [0, 0, 0];
  for (let h = 1e-4; h > 1e-14; ) {
    const [after, below] = step(u, angle, h);
    if (below > Math.PI / 2) h /= 2;
    else [t, u, angle] = [t + h, after, below];
  }
  return t;
}

/** ∫ ds/v with γ = 1 + gh/c², by Simpson over the root of the angle, in which it is smooth [s]. */
function quarterByEnergy(c: number): number {
  const rate = (s: number): number => {
    if (s === 0) return 2 / Math.sqrt(2 * 9.81);
    const excess = (9.81 * Math.sin(s * s)) / c ** 2;
    return (2 * s * (1 + excess)) / (c * Math.sqrt(excess * (2 + excess)));
  };
  const [n, end] = [20_000, Math.sqrt(Math.PI / 2)];
  let sum = rate(0) + rate(end);
  for (let i = 1; i < n; i++) sum += (i % 2 === 1 ? 4 : 2) * rate((i * end) / n);
  return (sum * end) / (3 * n);
}

const flownTrip = (distance: number, acceleration: number, c: number): FlightPlayback =>
  new FlightPlayback(plannedFlight([{ kind: 'trip', by: [0, 0, distance], acceleration }], REST, c));

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
  /** Time on a clock that moves, while the world's is t [s]. */
  ownTime: {
    computed: (beta, t) => {
      const line: WorldLine = { kind: 'uniform', position: ZERO, velocity: [0, 0, beta!] };
      return properTimeBetween(line, 0, t!, 1);
    },
    closedForm: (beta, t) => t! * Math.sqrt(1 - beta! ** 2),
  },
  /** What one sees pass on a clock at rest while one flies from it for own seconds. */
  seenAway: {
    computed: (beta, own) => homeClock(beta!, own!).seen,
    closedForm: (beta, own) => own! * Math.exp(-Math.atanh(beta!)),
  },
  /** The same on the way back, of equal duration. */
  seenBack: {
    computed: (beta, own) => homeClock(beta!, own!, own!).seen - homeClock(beta!, own!, 0).seen,
    closedForm: (beta, own) => own! * Math.exp(Math.atanh(beta!)),
  },
  /** What a clock at rest shows in the slice of one who has flown from it for own seconds. */
  sliceAway: {
    computed: (beta, own) => homeClock(beta!, own!).slice,
    closedForm: (beta, own) => own! * Math.sqrt(1 - beta! ** 2),
  },
  /** The same after he has turned round. */
  sliceReturn: {
    computed: (beta, own) => homeClock(beta!, own!, 0).slice,
    closedForm: (beta, own) => own! * Math.cosh(Math.atanh(beta!)) * (1 + beta! ** 2),
  },
  /** By how much it differs before and after. */
  sliceJump: {
    computed: (beta, own) => homeClock(beta!, own!, 0).slice - homeClock(beta!, own!).slice,
    closedForm: (beta, own) => 2 * own! * Math.sinh(Math.atanh(beta!)) * beta!,
  },
  /** When one who stays sees the turn of one who comes back after t [s]. */
  turnSeen: {
    computed: (beta, t) => {
      const line: WorldLine = { kind: 'uniform', position: ZERO, velocity: [0, 0, beta!] };
      return t! / 2 + length(positionAt(line, t! / 2, 1));
    },
    closedForm: (beta, t) => (t! * (1 + beta!)) / 2,
  },
  /** Of a circle with a radius [m]. */
  circumference: {
    computed: (radius) => 2 * Math.PI * radius!,
    closedForm: (radius) => 8 * radius! * Math.atan(1),
  },
  /** Of a rim that goes round at β, by rulers that lie on it. */
  rimLength: {
    computed: (radius, beta) => 2 * Math.PI * radius! * gamma(along(beta!)),
    closedForm: (radius, beta) => (2 * Math.PI * radius!) / Math.cos(Math.asin(beta!)),
  },
  /** How far a wheel rolls with one turn whose axle moves at β: the event of its axle, in the frame of the road. */
  rolledDistance: {
    computed: (radius, beta) => boost([(2 * Math.PI * radius!) / beta!, 0, 0, 0], along(-beta!))[3],
    closedForm: (radius, beta) => (2 * Math.PI * radius! * Math.sinh(Math.atanh(beta!))) / beta!,
  },
  /** The part of a rolling wheel’s rim that is above the axle at one moment of the road. */
  upperShare: {
    computed: (beta) => {
      // At the height of the axle, ahead and behind, the axle’s time at that moment; the rim turns by β radians in a unit of it.
      const [ahead, behind] = [1, -1].map((x) => boost([0, 0, 0, x / gamma(along(beta!))], along(beta!))[0]);
      return (Math.PI + beta! * (behind! - ahead!)) / (2 * Math.PI);
    },
    closedForm: (beta) => 1 / 2 + beta! ** 2 / Math.PI,
  },
  /** Of a mass of which the rest energy is 1. */
  kinetic: {
    computed: (beta) => gamma(along(beta!)) - 1,
    closedForm: (beta) => 2 * Math.sinh(Math.atanh(beta!) / 2) ** 2,
  },
  classicalKinetic: {
    computed: (beta) => beta! ** 2 / 2,
    closedForm: (beta) => (Math.cosh(2 * Math.atanh(beta!)) - 1) / (Math.cosh(2 * Math.atanh(beta!)) + 1) / 2,
  },
  kineticRatio: {
    computed: (beta) => (gamma(along(beta!)) - 1) / (beta! ** 2 / 2),
    closedForm: (beta) => (Math.cosh(Math.atanh(beta!)) / Math.cosh(Math.atanh(beta!) / 2)) ** 2,
  },
  rapidity: {
    computed: (beta) => Math.asinh(length(along(beta!))),
    closedForm: (beta) => Math.log((1 + beta!) / (1 - beta!)) / 2,
  },
  /** Of both axes of one who moves, in a spacetime diagram. */
  axisTilt: {
    computed: (beta) => {
      const [t, , , x] = boost([1, 0, 0, 0], along(-beta!));
      return degrees(Math.atan2(x, t));
    },
    closedForm: (beta) => degrees(Math.atan(beta!)),
  },
  /** Where light goes that goes at an angle for one at rest. */
  lightDirection: {
    computed: (beta, angle) => {
      const [, x, y, z] = boost([1, ...at(angle!)], along(beta!));
      return angleFrom([x, y, z]);
    },
    closedForm: (beta, angle) => {
      const cosine = Math.cos(radians(angle!));
      return degrees(Math.acos((cosine - beta!) / (1 - beta! * cosine)));
    },
  },
  /** γ³, which a mass at β resists with along its way. */
  longitudinal: {
    // dp/dt = (m/γ) dU/dτ for an acceleration of 1.
    computed: (beta) => fourAcceleration(along(beta!), [0, 0, 1])[3] / gamma(along(beta!)),
    closedForm: (beta) => Math.cosh(Math.atanh(beta!)) ** 3,
  },
  /** After a fall from rest by a height [m] under 9.81 m/s², where light goes at c [m/s]. */
  fallenGamma: {
    computed: (height, c) => Math.cosh(fallen(height!, c!).velocity.rapidity),
    closedForm: (height, c) => 1 + (9.81 * height!) / c! ** 2,
  },
  fallenBeta: {
    computed: (height, c) => Math.tanh(fallen(height!, c!).velocity.rapidity),
    closedForm: (height, c) => Math.sqrt(1 - (1 + (9.81 * height!) / c! ** 2) ** -2),
  },
  fallTime: {
    computed: (height, c) => fallen(height!, c!).t.value,
    closedForm: (height, c) => Math.sqrt((height! / c!) ** 2 + (2 * height!) / 9.81),
  },
  /** Its speed before relativity [m/s]: where light is very fast. */
  newtonFall: {
    computed: (height) => Math.tanh(fallen(height!, 1e6).velocity.rapidity) * 1e6,
    closedForm: (height) => Math.sqrt(2 * 9.81 * height!),
  },
  /** Of a pendulum of a metre that is let go level, under 9.81 m/s² [s]. By its momentum, step by step; and by its energy. */
  pendulumPeriod: {
    computed: (c) => 4 * quarterByMomentum(c!),
    closedForm: (c) => 4 * quarterByEnergy(c!),
  },
  /** Of velocities along one line. */
  velocitySum: {
    computed: (a, b) => length(velocity(addVelocities(along(a!), along(b!)))),
    closedForm: (a, b) => Math.tanh(Math.atanh(a!) + Math.atanh(b!)),
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
  /** The same for a distance [m] at a [m/s²] where light goes at c [m/s], as a lesson flies it: on board and at home [s]. */
  tripOwnSeconds: {
    computed: (distance, a, c) => flownTrip(distance!, a!, c!).duration,
    closedForm: (distance, a, c) => ((2 * c!) / a!) * Math.acosh(1 + (a! * distance!) / (2 * c! ** 2)),
  },
  tripWorldSeconds: {
    computed: (distance, a, c) => flownTrip(distance!, a!, c!).worldSpan()![1],
    closedForm: (distance, a, c) => Math.sqrt((distance! / c!) ** 2 + (4 * distance!) / a!),
  },
};
