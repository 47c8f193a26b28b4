import { length, normalize, select, vec4 } from 'three/tsl';
import type { Bool, Float, Vec3 } from '../../shaders/types.ts';
import { rotateVector } from '../geometry/vertexSamples.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { lightEmissionEvent } from './lightMotions.ts';
import type { LightShape, LightTexels } from './lightTexels.ts';
import { type RestFrameNodes, restFrame, WORLD_FRAME } from './restFrame.ts';

/** A local light at the event where it emits what reaches a surface event. */
export interface LightAtEmission {
  /** Surface → light, unit, world. */
  readonly n: Vec3;
  /** Surface → emission event of its centre [m], world. */
  readonly offset: Vec3;
  /** Its rest frame at that event; the members below are given there. */
  readonly frame: RestFrameNodes;
  /** Surface → its centre [m]. */
  readonly center: Vec3;
  /** Absent of lights that shine equally in all directions. */
  readonly shape?: LightShape;
  /** 1 where the light existed when it emitted what reaches the surface from its centre, or from `place` [m from the surface], else 0; absent if always 1. */
  readonly aliveFactor?: (place?: Vec3) => Float;
}

/**
 * A light at the event where it emits what reaches the surface event at `dx` [m] from the observer and `time` [m of light] after the observer's: on the past
 * light cone of the surface event, or in the views of one moment at that moment. Its velocity and axes are taken as constant while light crosses it.
 */
export function lightAtEmission(light: LightTexels, dx: Vec3, time: Float, uniforms: FrameUniforms): LightAtEmission {
  const d = light.place.sub(dx).toVar();
  const lag =
    light.life && select(uniforms.lightTravels.greaterThan(0.5), light.life.z.sub(time).add(length(d)), 0).toVar();
  const { offset, elapsed, velocity, orientation, exists } = lightEmissionEvent(light.motion, d, lag);
  const n = normalize(offset).toVar();
  const frame = velocity ? restFrame(velocity, uniforms) : WORLD_FRAME;
  const distance = length(offset);
  const center = frame.doppler
    ? frame
        .into(n)
        .mul(distance.mul(frame.doppler(n)))
        .toVar()
    : offset;
  const { shape, life } = light;
  const turned = orientation &&
    shape && { ...shape, X: rotateVector(orientation, shape.X).toVar(), Y: rotateVector(orientation, shape.Y).toVar() };
  const alive = life && elapsed && { life, exists, time: life.z.add(elapsed).toVar() };
  return {
    n,
    offset,
    frame,
    center,
    ...(shape && { shape: turned ?? shape }),
    ...(alive && {
      aliveFactor: (place?: Vec3) =>
        aliveFactorAt(alive, place && emissionDelay(center, place, frame).mul(uniforms.lightTravels)),
    }),
  };
}

interface Alive {
  readonly life: Vec3;
  readonly exists: Bool | undefined;
  /** Emission time of its centre after the observer's time [m of light]. */
  readonly time: Float;
}

function aliveFactorAt({ life, exists, time }: Alive, delay: Float | undefined): Float {
  const emitted = (delay ? time.add(delay) : time).toVar();
  const alive = emitted.greaterThanEqual(life.x).and(emitted.lessThan(life.y));
  return select(exists ? alive.and(exists) : alive, 1, 0);
}

/** World time [m of light] by which light from `place` is emitted later than light from `center` that reaches the surface at the same event. */
function emissionDelay(center: Vec3, place: Vec3, frame: RestFrameNodes): Float {
  const emissionTime = (x: Vec3): Float => frame.boostOut(vec4(x, length(x).negate())).w;
  return emissionTime(place).sub(emissionTime(center));
}
