import { length, normalize, select, vec4 } from 'three/tsl';
import type { Bool, Float, Vec3 } from '../shaders/types.ts';
import { lampEvent } from './lampEvent.ts';
import type { LampShape, LampTexels } from './lampTable.ts';
import { AT_REST, type Rest, restFrame } from './restFrame.ts';
import { turn } from './samples.ts';
import type { Uniforms } from './uniforms.ts';

/** A lamp as a surface sees it. */
export interface SeenLamp {
  /** Surface → lamp, unit, world. */
  readonly n: Vec3;
  /** The same, to where it was when it sent out what meets the surface [m]. */
  readonly offset: Vec3;
  /** Its rest frame at the event; its axes, and what follows, are given there. */
  readonly frame: Rest;
  /** Surface → its middle [m]. */
  readonly centre: Vec3;
  /** Absent of what shines alike to all sides. */
  readonly shape?: LampShape;
  /** 1 where it shone when what meets the surface left it: its middle, or a place of it [m from the surface, its frame]. */
  readonly shining?: (place?: Vec3) => Float;
}

/**
 * A lamp where and when it sent out what meets a surface event at `dx` [m] from the observer and `time` [m of light] after his: on the event's own past light
 * cone; in the views of one moment, at that moment. Its velocity and axes are taken as constant while its light crosses it.
 */
export function lampSeen(lamp: LampTexels, dx: Vec3, time: Float, uniforms: Uniforms): SeenLamp {
  const d = lamp.place.sub(dx).toVar();
  const late =
    lamp.life && select(uniforms.lightTravels.greaterThan(0.5), lamp.life.z.sub(time).add(length(d)), 0).toVar();
  const { offset, elapsed, velocity, orientation, exists } = lampEvent(lamp.path, d, late);
  const n = normalize(offset).toVar();
  const frame = velocity ? restFrame(velocity, uniforms) : AT_REST;
  const distance = length(offset);
  const centre = frame.doppler
    ? frame
        .into(n)
        .mul(distance.mul(frame.doppler(n)))
        .toVar()
    : offset;
  const { shape, life } = lamp;
  const turned = orientation &&
    shape && { ...shape, X: turn(orientation, shape.X).toVar(), Y: turn(orientation, shape.Y).toVar() };
  const alive = life && elapsed && { life, exists, middle: life.z.add(elapsed).toVar() };
  return {
    n,
    offset,
    frame,
    centre,
    ...(shape && { shape: turned ?? shape }),
    ...(alive && {
      shining: (place?: Vec3) => shiningAt(alive, place && laterThan(centre, place, frame).mul(uniforms.lightTravels)),
    }),
  };
}

interface Alive {
  readonly life: Vec3;
  readonly exists: Bool | undefined;
  /** When the light of its middle was sent out. */
  readonly middle: Float;
}

function shiningAt({ life, exists, middle }: Alive, later: Float | undefined): Float {
  const when = (later ? middle.add(later) : middle).toVar();
  const alive = when.greaterThanEqual(life.x).and(when.lessThanEqual(life.y));
  return select(exists ? alive.and(exists) : alive, 1, 0);
}

/** How much later [m of light, world] light left `place` than it left `centre`, to meet a surface at one event. */
function laterThan(centre: Vec3, place: Vec3, frame: Rest): Float {
  const sentOut = (x: Vec3): Float => frame.carriedOut(vec4(x, length(x).negate())).w;
  return sentOut(place).sub(sentOut(centre));
}
