import { length, normalize, select } from 'three/tsl';
import type { Float, Vec3 } from '../shaders/types.ts';
import { lampEvent } from './lampEvent.ts';
import type { LampShape, LampTexels } from './lampTable.ts';
import { AT_REST, type Rest, restFrame } from './restFrame.ts';
import { turn } from './samples.ts';
import type { Uniforms } from './uniforms.ts';

/** A lamp as a surface sees it. */
export interface SeenLamp {
  /** Surface → lamp, unit, world. */
  readonly n: Vec3;
  /** Its rest frame at the event; its axes, and what follows, are given there. */
  readonly frame: Rest;
  /** Surface → its middle [m]. */
  readonly centre: Vec3;
  /** Absent of what shines alike to all sides. */
  readonly shape?: LampShape;
  /** Whether it shines then. */
  readonly shining?: Float;
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
  const when = life && elapsed && life.z.add(elapsed).toVar();
  const alive = life && when?.greaterThanEqual(life.x).and(when.lessThanEqual(life.y));
  const turned = orientation &&
    shape && { ...shape, X: turn(orientation, shape.X).toVar(), Y: turn(orientation, shape.Y).toVar() };
  return {
    n,
    frame,
    centre,
    ...(shape && { shape: turned ?? shape }),
    ...(alive && { shining: select(exists ? alive.and(exists) : alive, 1, 0) }),
  };
}
