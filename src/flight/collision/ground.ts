import { addScaled, cross, distance, dot, length, negate, normalize, scale, type Vec3, ZERO } from '../../math/vec3.ts';
import type { FlightConditions } from '../arc.ts';
import { type Boost, compose, properVelocityOf, relativeBoost } from '../boost.ts';
import type { Ground } from '../controls.ts';
import type { FlightState } from '../flightState.ts';
import type { FlightMoment } from '../modes/flightMode.ts';
import { onSlope, withoutUp } from '../modes/slope.ts';
import type { FlownMoment, FlownPiece } from './collide.ts';
import {
  distanceTo,
  eventOf,
  frozen,
  inWallFrame,
  type Obstacles,
  segmentTo,
  type Wall,
  type WorldEvent,
} from './obstacles.ts';

export interface GroundRules {
  readonly obstacles: Obstacles;
  /** Of the eye above the ground, along the vertical of the frame where it rests [m]. */
  readonly height: number;
}

/** The steepest slope that is followed, as the cosine of its angle, 45°, and its rise over its way. */
const [STEEPEST, MAX_SLOPE] = [Math.SQRT1_2 * (1 - 1e-9), 1];
/** How far below one looks for ground to come down to [parts of the height]. */
const REACH = 10_000;
/** The highest step that is climbed, up or down [parts of the height]. */
const STEP = 0.25;
/** One looks for the ground again after that way [parts of the height], … */
const STRIDE = 0.25;
/** … but no more often in a moment. */
const MOST_STRIDES = 32;
/** Heights that differ by less are the same [parts of the height]. */
const SAME_HEIGHT = 1e-6;
/** Directions whose cosine is so near 1 are the same. */
const ALIGNED = 1 - 1e-12;
/** How often the slope of a stride is corrected by where it ends. */
const CORRECTIONS = 3;

/** Obstacles without what is driven on: what is not steeper than one climbs hides what is behind it. */
export const withoutGround = (obstacles: Obstacles, up: Vec3): Obstacles => ({
  first(segment, end) {
    const wall = obstacles.first(segment, end);
    return wall && isClimbed(wall.normal, up) ? undefined : wall;
  },
});

const isClimbed = (normal: Vec3, up: Vec3): boolean => Math.abs(dot(normal, up)) >= STEEPEST;

interface GroundBelow extends Wall {
  /** How far the eye is above it, along the vertical of the frame where it rests [m]. */
  readonly above: number;
}

/** The surface straight below an event in the world, within a distance [m], unless it is too steep; its normal is upwards. */
function surfaceBelow(
  event: WorldEvent,
  obstacles: Obstacles,
  reach: number,
  up: Vec3,
  { c, playing }: FlightConditions,
): GroundBelow | undefined {
  const met = obstacles.first({ start: event, dt: 0, dx: scale(up, -reach) }, 1);
  if (!met || !isClimbed(met.normal, up)) return undefined;
  const wall = playing ? met : frozen(met);
  const normal = dot(wall.normal, up) < 0 ? negate(wall.normal) : wall.normal;
  return { ...wall, normal, above: distanceTo({ ...wall, normal }, event, c) / dot(normal, up) };
}

/** What one stands on at an event: the surface below, at about the height of the eye. */
function groundBelow(
  event: WorldEvent,
  { obstacles, height }: GroundRules,
  up: Vec3,
  conditions: FlightConditions,
): GroundBelow | undefined {
  const below = surfaceBelow(event, obstacles, height * (1 + STEP), up, conditions);
  return below && Math.abs(below.above - height) <= height * STEP ? below : undefined;
}

/**
 * Where one comes down to from however high, at rest on the surface that is straight below in the world: at the height of the eye above
 * it, along the vertical of the frame where it rests. World frame: place [m] and γβ. Undefined where there is none, or it is too steep.
 */
export function comeDown(
  state: FlightState,
  { obstacles, height }: GroundRules,
  up: Vec3,
  conditions: FlightConditions,
): { readonly position: Vec3; readonly u: Vec3 } | undefined {
  const from = eventOf(state);
  const below = surfaceBelow(from, obstacles, height * REACH, up, conditions);
  if (!below || !(below.above > 0)) return undefined;
  // A plane in uniform motion: heights of one moment of the world are proportional to those of its frame.
  const inWorld = distance(from.x, below.event.x) / below.above;
  return { position: addScaled(below.event.x, up, height * inWorld), u: properVelocityOf(below.velocity) };
}

/**
 * Flies a moment of `Drive` over the ground: along the plane below, in the frame where it rests. Where the ground bends, the
 * motion turns into its new plane at once, and keeps its rapidity there; what then is missing of the eye's height is made up for
 * along the way, no steeper than one climbs. Without ground one goes on level. `fly`: the moment, with the ground in its rules.
 */
export function flyOnGround(
  moment: FlightMoment,
  conditions: FlightConditions,
  rules: GroundRules,
  fly: (moment: FlightMoment) => FlownMoment,
): FlownMoment {
  if (conditions.lock === 'look') return fly(moment);
  const way = Math.sinh(moment.state.velocity.rapidity) * conditions.c * moment.dt;
  const strides = Math.max(1, Math.min(MOST_STRIDES, Math.ceil(way / (rules.height * STRIDE))));
  const pieces: FlownPiece[] = [];
  let [after, contact]: [FlightState, FlownMoment['contact']] = [moment.state, undefined];
  for (let i = 0; i < strides; i++) {
    const controls = i === 0 ? moment.controls : { ...moment.controls, turn: ZERO };
    const flown = stride({ ...moment, state: after, controls, dt: moment.dt / strides }, conditions, rules, fly);
    pieces.push(...flown.pieces);
    contact = flown.contact ?? contact;
    after = flown.after;
  }
  return { pieces, after, ...(contact && { contact }) };
}

function stride(
  moment: FlightMoment,
  conditions: FlightConditions,
  rules: GroundRules,
  fly: (moment: FlightMoment) => FlownMoment,
): FlownMoment {
  const { up } = moment.rules;
  const start = eventOf(moment.state);
  const below = groundBelow(start, rules, up, conditions);
  if (!below) return fly(moment);
  let ground: Ground = { velocity: below.velocity, normal: below.normal };
  for (let i = 0; ; i++) {
    const velocity = turnedInto(moment.state.velocity, ground, up);
    const state = velocity === moment.state.velocity ? moment.state : { ...moment.state, velocity };
    const flown = fly({ ...moment, state, rules: { ...moment.rules, ground } });
    const end = eventOf(flown.after);
    const there = i < CORRECTIONS && groundBelow(end, rules, up, conditions);
    const missing = there ? rules.height - there.above : 0;
    if (Math.abs(missing) <= rules.height * SAME_HEIGHT) return flown;
    const way = inWallFrame(ground, segmentTo(start, end), conditions.c);
    const tilted = tiltedBy(ground, way, missing, up);
    if (!tilted) return flown;
    ground = tilted;
  }
}

/** A velocity turned into the plane of the ground: in the frame where that rests, its heading and its rapidity stay. */
function turnedInto(velocity: Boost, ground: Ground, up: Vec3): Boost {
  const { direction, rapidity } = relativeBoost(velocity, ground.velocity);
  const heading = normalize(withoutUp(direction, up));
  // Who falls or rises rather than drives is braked by the mode.
  if (rapidity === 0 || dot(direction, heading) < STEEPEST) return velocity;
  const along = onSlope(heading, ground.normal, up);
  return dot(along, direction) > ALIGNED ? velocity : compose(ground.velocity, { direction: along, rapidity });
}

/** The ground with another slope along the way [m, its frame], that ends higher by `missing` [m]; undefined where it cannot. */
function tiltedBy({ velocity, normal }: Ground, way: Vec3, missing: number, up: Vec3): Ground | undefined {
  const level = withoutUp(way, up);
  const size = length(level);
  if (size === 0) return undefined;
  const before = dot(way, up) / size;
  const slope = Math.max(-MAX_SLOPE, Math.min(MAX_SLOPE, before + missing / size));
  if (Math.abs(slope - before) <= SAME_HEIGHT) return undefined;
  const forward = scale(level, 1 / size);
  const side = onSlope(cross(up, forward), normal, up);
  return { velocity, normal: normalize(cross(addScaled(forward, up, slope), side)) };
}
