import { length, normalize, select, vec4 } from 'three/tsl';
import type { Bool, Float, Vec3 } from '../../shaders/types.ts';
import { rotateVector } from '../geometry/vertexSamples.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { lightEmissionEvent } from './lightEvent.ts';
import type { LightShape, LightTexels } from './lightTexels.ts';
import { type RestFrameNodes, restFrame, WORLD_FRAME } from './restFrame.ts';

/** A light as a surface sees it. */
export interface LightAtEmission {
  /** Surface → light, unit, world. */
  readonly n: Vec3;
  /** The same, to where it was when it sent out what meets the surface [m]. */
  readonly offset: Vec3;
  /** Its rest frame at the event; its axes, and what follows, are given there. */
  readonly frame: RestFrameNodes;
  /** Surface → its middle [m]. */
  readonly center: Vec3;
  /** Absent of what shines alike to all sides. */
  readonly shape?: LightShape;
  /** 1 where it shone when what meets the surface left it: its middle, or a place of it [m from the surface, its frame]. */
  readonly aliveFactor?: (place?: Vec3) => Float;
}

/**
 * A light where and when it sent out what meets a surface event at `dx` [m] from the observer and `time` [m of light] after his: on the event's own past light
 * cone; in the views of one moment, at that moment. Its velocity and axes are taken as constant while its light crosses it.
 */
export function lightAtEmission(light: LightTexels, dx: Vec3, time: Float, uniforms: FrameUniforms): LightAtEmission {
  const d = light.place.sub(dx).toVar();
  const late =
    light.life && select(uniforms.lightTravels.greaterThan(0.5), light.life.z.sub(time).add(length(d)), 0).toVar();
  const { offset, elapsed, velocity, orientation, exists } = lightEmissionEvent(light.motion, d, late);
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
  const alive = life && elapsed && { life, exists, middle: life.z.add(elapsed).toVar() };
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
  /** When the light of its middle was sent out. */
  readonly middle: Float;
}

function aliveFactorAt({ life, exists, middle }: Alive, later: Float | undefined): Float {
  const when = (later ? middle.add(later) : middle).toVar();
  const alive = when.greaterThanEqual(life.x).and(when.lessThanEqual(life.y));
  return select(exists ? alive.and(exists) : alive, 1, 0);
}

/** How much later [m of light, world] light left `place` than it left `centre`, to meet a surface at one event. */
function emissionDelay(center: Vec3, place: Vec3, frame: RestFrameNodes): Float {
  const sentOut = (x: Vec3): Float => frame.boostOut(vec4(x, length(x).negate())).w;
  return sentOut(place).sub(sentOut(center));
}
