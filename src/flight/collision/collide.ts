import { addScaled, dot, length, negate } from '../../math/vec3.ts';
import { type FlightArc, type FlightConditions, firstArcs, flyArcs, type Lock, seekArcs, turnedFirst } from '../arc.ts';
import { type Boost, relativeBoost } from '../boost.ts';
import type { FlightState } from '../flightState.ts';
import type { FlightMode, FlightMoment } from '../modes/flightMode.ts';
import {
  distanceTo,
  eventOf,
  frozen,
  inWallFrame,
  type Obstacles,
  segmentTo,
  type Wall,
  type WorldEvent,
  type WorldSegment,
  worldNormal,
} from './obstacles.ts';
import { alongWall, slideAlong } from './slide.ts';

/** What happens at a wall. */
export type CollisionKind = 'stop' | 'slide';

export interface CollisionRules {
  readonly obstacles: Obstacles;
  readonly kind: CollisionKind;
  /** How far one stays from walls, in the frame where they rest [m]. */
  readonly radius: number;
}

/** Arcs from one state to another. Where a piece does not begin as the last ended, the velocity has jumped. */
export interface FlownPiece {
  readonly before: FlightState;
  readonly arcs: readonly FlightArc[];
  readonly after: FlightState;
}

/** What a wall does to a moment: one touches it, brakes before it, or is too fast to stop before it. */
export type Contact = 'touching' | 'braking' | 'too-fast';

export interface FlownMoment {
  readonly pieces: readonly FlownPiece[];
  readonly after: FlightState;
  readonly contact?: Contact;
}

/** Distances and moments [parts of the clearance] that are rounding. */
const TOLERANCE = 1e-9;
/** Velocities that differ by less rapidity are the same. */
const SAME_RAPIDITY = 1e-12;
/** How much more than the greatest proper acceleration one may need for a stop that was planned with just that. */
const PLANNED = 1e-6;
/** Who slides has no more rapidity into the wall than that. */
const SLIDING = 1e-9;
/** One slides along a wall that is no farther than that beyond the clearance [parts of it]. */
const BESIDE = 1e-6;
/** Walls in a moment, after which one stops: in a sharp corner. */
const MOST_WALLS = 4;
/** Where a wall is met at a small angle, one comes nearer: its plane may go on where the wall does not. The cosine of that angle. */
const GRAZING = 0.05;
const BISECTIONS = 60;

/**
 * Flies a moment of a mode among obstacles.
 *
 * *Stop*: one brakes with the mode's greatest proper acceleration a such that one is at rest, in the frame where the wall rests,
 * at the clearance before it: from the distance (γ − 1)c²/a on, along the motion. *Slide*: one brakes such that the velocity's
 * part into the wall is gone there, and the speed along it stays (`slideAlong`). Who is too fast brakes as well, and loses what is
 * left of it at once at the clearance. docs/physics.md §2.7.
 */
export function flyAmong(
  mode: FlightMode,
  moment: FlightMoment,
  conditions: FlightConditions,
  rules: CollisionRules,
): FlownMoment {
  const orientation = mode.orientation(moment);
  const pieces: FlownPiece[] = [];
  const walls: Wall[] = [];
  let contact: Contact | undefined;
  let now = moment.state;
  let left = moment.dt;
  const turned = (arcs: readonly FlightArc[]): readonly FlightArc[] =>
    pieces.length === 0 && orientation !== now.orientation ? turnedFirst(arcs, orientation) : arcs;
  const plan = (): readonly FlightArc[] => {
    const state = pieces.length === 0 ? { ...now, orientation } : now;
    const arcs = mode.arcs({ ...moment, state, dt: left });
    return turned(walls.reduce((free, wall) => alongWall(free, now.velocity, wall), arcs));
  };
  const fly = (arcs: readonly FlightArc[]): void => {
    const after = flyArcs(now, arcs, conditions);
    pieces.push({ before: now, arcs, after });
    now = after;
  };
  for (;;) {
    const free = new Course(now, plan(), left, conditions);
    const wall = conditions.lock === 'look' ? undefined : free.wallAhead(rules);
    const braked = wall && braking(free, wall, rules.kind, mode.strength(moment.rules));
    const course = braked ? new Course(now, turned(braked.arcs), left, conditions) : free;
    if (braked) contact = braked.contact;
    const until =
      wall &&
      course.timeTo(wall, rules.radius * TOLERANCE, rules.radius * (rules.kind === 'slide' ? BESIDE : TOLERANCE));
    if (!wall || until === undefined) {
      fly(course.arcs);
      return { pieces, after: now, ...(contact && { contact }) };
    }
    contact ??= 'touching';
    if (until > 0) fly(firstArcs(course.arcs, until));
    left -= until;
    walls.push(wall.wall);
    const stops = rules.kind === 'stop' || walls.length > MOST_WALLS;
    const velocity = stops ? wall.wall.velocity : slideAlong(now.velocity, wall.wall);
    if (relativeBoost(velocity, now.velocity).rapidity > SAME_RAPIDITY) now = { ...now, velocity };
    if (left <= 0 && pieces.length > 0) return { pieces, after: now, contact };
    if (!stops) continue;
    fly(turned([{ dTau: left }]));
    return { pieces, after: now, contact };
  }
}

/** A wall ahead, and how far from its plane one stays [m]. */
interface WallAhead {
  readonly wall: Wall;
  readonly clearance: number;
}

/** What is flown in a moment from a state. */
class Course {
  readonly start: FlightState;
  readonly arcs: readonly FlightArc[];
  /** [s] */
  readonly duration: number;
  private readonly conditions: FlightConditions;

  constructor(start: FlightState, arcs: readonly FlightArc[], duration: number, conditions: FlightConditions) {
    this.start = start;
    this.arcs = arcs;
    this.duration = duration;
    this.conditions = conditions;
  }

  get lock(): Lock {
    return this.conditions.lock;
  }

  get c(): number {
    return this.conditions.c;
  }

  stateAt(dTau: number): FlightState {
    const arcs = dTau < this.duration ? firstArcs(this.arcs, dTau) : this.arcs;
    return flyArcs(this.start, arcs, this.conditions);
  }

  /** How far one is before the place where one stays from a wall [m], after a part of the moment. */
  gapAt(dTau: number, { wall, clearance }: WallAhead): number {
    return distanceTo(wall, eventOf(this.stateAt(dTau)), this.c) - clearance;
  }

  /** The first wall on the straight line from the beginning to the end of the moment, and beyond. Its normal is towards the ship. */
  wallAhead(rules: CollisionRules): WallAhead | undefined {
    const here = eventOf(this.start);
    const segment = segmentTo(here, eventOf(this.stateAt(this.duration)));
    const met = rules.obstacles.first(segment, Number.POSITIVE_INFINITY);
    if (!met) return undefined;
    const seen = this.conditions.playing ? met : frozen(met);
    const way = inWallFrame(seen, segment, this.c);
    const approach = dot(way, seen.normal);
    const normal = approach > 0 ? negate(seen.normal) : seen.normal;
    const away = Math.abs(approach) * partTo(segment, met.event, this.c);
    const wall = footOf({ ...seen, normal }, here, away, this.c);
    const steepness = Math.abs(approach) / (length(way) * GRAZING);
    if (steepness >= 1 || isBeside(wall, here, away, rules, this.c)) return { wall, clearance: rules.radius };
    return { wall, clearance: rules.radius * steepness };
  }

  /** When one comes to where one stays from a wall [s], at once if it is no farther than `beside` [m]; undefined if not in this moment. */
  timeTo(ahead: WallAhead, tolerance: number, beside: number): number | undefined {
    const [first, last] = [this.gapAt(0, ahead), this.gapAt(this.duration, ahead)];
    if (last >= Math.min(0, first) - tolerance) return undefined;
    return first <= beside ? 0 : bisect((dTau) => this.gapAt(dTau, ahead) > 0, this.duration);
  }
}

/** How far along a line of events one of its events is. */
function partTo({ start, dt, dx }: WorldSegment, event: WorldEvent, c: number): number {
  const way = segmentTo(start, event);
  return Math.hypot(c * way.dt, length(way.dx)) / Math.hypot(c * dt, length(dx));
}

/**
 * A wall's plane with the event on it that is straight across from `here`, `away` [m] from it, at one moment of the frame where it
 * rests: a wall that is met at a small angle is met far away, where distances have fewer digits.
 */
function footOf(wall: Wall, here: WorldEvent, away: number, c: number): Wall {
  const [ct, x, y, z] = worldNormal(wall);
  return { ...wall, event: { t: here.t - (away * ct) / c, x: addScaled(here.x, [x, y, z], -away) } };
}

/** Whether a wall is beside an event, not only its plane: a probe across, however long, meets it. */
function isBeside(
  wall: Wall,
  here: WorldEvent,
  away: number,
  { obstacles, radius }: CollisionRules,
  c: number,
): boolean {
  const across = footOf(wall, here, Math.max(away, radius * PLANNED), c);
  return obstacles.first(segmentTo(here, across.event), 1 + PLANNED) !== undefined;
}

/** The last time in 0 … `end` up to which something holds that holds at first. */
function bisect(holds: (dTau: number) => boolean, end: number): number {
  let [low, high] = [0, end];
  for (let i = 0; i < BISECTIONS; i++) {
    const middle = (low + high) / 2;
    if (holds(middle)) low = middle;
    else high = middle;
  }
  return low;
}

/**
 * The distance to a wall's plane times the proper acceleration, that it takes to lose the velocity into it [m²/s²]. With δ from the
 * present velocity to that at the wall, of γ₁ there, it is in the frame where the wall rests
 *
 *     c² tanh(δ/2) γβ_⊥,  of a stop c² (cosh φ − 1) cos α;  with the lock `fly` c² ln cosh δ cos α/γ₁
 *
 * On this arc the speed along the wall does not change, nor does the aim of a slide: a plan that is made anew is the same.
 */
function effortOf(velocity: Boost, aim: Boost, wall: Wall, lock: Lock, c: number): number {
  const { direction, rapidity } = relativeBoost(velocity, wall.velocity);
  const into = Math.max(0, -dot(direction, wall.normal));
  const lost = relativeBoost(aim, velocity).rapidity;
  if (lock === 'free') return c * c * Math.tanh(lost / 2) * Math.sinh(rapidity) * into;
  const along = relativeBoost(aim, wall.velocity).rapidity;
  // A stop loses all of the motion, at the angle α to the normal; a slide loses what is straight into the wall.
  return (c * c * Math.log1p(2 * Math.sinh(lost / 2) ** 2) * (along === 0 ? into : 1)) / Math.cosh(along);
}

/**
 * The arcs of a moment in which one has to brake for a wall with a proper acceleration of at most `greatest` [m/s²]; undefined if
 * there is time left. With the lock `fly`, where clocks are the world's, only walls at rest are braked for.
 */
function braking(
  course: Course,
  ahead: WallAhead,
  kind: CollisionKind,
  greatest: number,
): { readonly arcs: readonly FlightArc[]; readonly contact: Contact } | undefined {
  const { c, duration, lock } = course;
  const { wall } = ahead;
  if (lock === 'fly' && wall.velocity.rapidity > 0) return undefined;
  const aimOf = ({ velocity }: FlightState): Boost => (kind === 'stop' ? wall.velocity : slideAlong(velocity, wall));
  const effort = (state: FlightState): number => effortOf(state.velocity, aimOf(state), wall, lock, c);
  const canStop = (dTau: number, tolerance = 0): boolean =>
    course.gapAt(dTau, ahead) * (1 - tolerance) >= effort(course.stateAt(dTau)) / greatest;
  if (canStop(duration)) return undefined;
  const { start } = course;
  const isSliding = kind === 'slide' && relativeBoost(aimOf(start), start.velocity).rapidity <= SLIDING;
  if (isSliding && course.gapAt(0, ahead) <= ahead.clearance * BESIDE) return undefined;
  const begin = canStop(0, TOLERANCE) ? bisect(canStop, duration) : 0;
  const state = course.stateAt(begin);
  const gap = course.gapAt(begin, ahead);
  const needed = gap > 0 ? effort(state) / gap : 0;
  if (needed === 0) return undefined;
  const tooFast = kind === 'stop' && needed > greatest * (1 + PLANNED);
  const brake = seekArcs(state.velocity, aimOf(state), Math.min(needed, greatest), duration - begin, c);
  const before = begin > 0 ? firstArcs(course.arcs, begin) : [];
  return { arcs: [...before, ...brake], contact: tooFast ? 'too-fast' : 'braking' };
}
