import { add, length, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { apparentPosition } from '../../physics/optics/apparentPosition.ts';
import { dopplerFactor } from '../../physics/optics/doppler.ts';
import { emissionEvent, type ObserverEvent } from '../../physics/worldLines/lightCone.ts';
import { simultaneitySlice, simultaneousPosition } from '../../physics/worldLines/simultaneity.ts';
import { positionAt, velocityAt, type WorldLine } from '../../physics/worldLines/worldLine.ts';
import { vertexWorldLine } from '../motion/motion.ts';
import type { SceneObject } from '../types.ts';
import type { View } from './bufferSettings.ts';

export interface ProbeObserver extends ObserverEvent {
  /** γβ, world frame. */
  readonly u: Vec3;
}

/** One vertex as one observer has it. */
export interface VertexProbe {
  readonly vertex: number;
  /** World time of the event that is shown [s]: emission, or the event of the observer's (or the world's) now. */
  readonly time: number;
  /** Of that event, world frame [m]. */
  readonly position: Vec3;
  /** World frame, units of c. */
  readonly velocity: Vec3;
  /** From the observer, in his frame (world axes carried by the pure boost) [m]. */
  readonly apparent: Vec3;
  /** |apparent| [m]. */
  readonly distance: number;
  /** D = ν_observed/ν_emitted; 1 in the views that are not of light. */
  readonly doppler: number;
  /** The event lies within the object's lifetime. */
  readonly visible: boolean;
}

/**
 * What the observer has of each vertex, from the f64 library; undefined where no light ever comes (behind a horizon).
 * c [m/s].
 */
export function probeVertices(
  object: SceneObject,
  observer: ProbeObserver,
  c: number,
  view: View = 'light-cone',
): (VertexProbe | undefined)[] {
  return Array.from({ length: object.mesh.positions.length / 3 }, (_, i) => probeVertex(object, i, observer, c, view));
}

export function probeVertex(
  object: SceneObject,
  vertex: number,
  observer: ProbeObserver,
  c: number,
  view: View = 'light-cone',
): VertexProbe | undefined {
  const shown = VIEW_PROBES[view](vertexWorldLine(object, vertex, c), observer, c);
  if (!shown) return undefined;
  const { birth, death } = object.lifetime;
  const visible = shown.time >= birth && shown.time <= death;
  return { vertex, ...shown, distance: length(shown.apparent), visible };
}

type ProbedEvent = Omit<VertexProbe, 'vertex' | 'distance' | 'visible'>;
type VertexProbeFunction = (line: WorldLine, observer: ProbeObserver, c: number) => ProbedEvent | undefined;

const VIEW_PROBES: Record<View, VertexProbeFunction> = {
  'light-cone': (line, observer, c) => {
    const event = emissionEvent(line, observer, c);
    if (!event) return undefined;
    const velocity = scale(event.velocity, 1 / c);
    const doppler = dopplerFactor(event.offset, observer.u, properVelocity(velocity));
    const apparent = apparentPosition(event.offset, observer.u);
    return { time: event.t, position: event.position, velocity, apparent, doppler };
  },
  simultaneity: (line, observer, c) => {
    const { offset, ahead } = simultaneitySlice(line, observer, observer.u, c);
    const time = observer.t + ahead / c;
    const velocity = scale(velocityAt(line, time, c), 1 / c);
    const apparent = simultaneousPosition(offset, observer.u);
    return { time, position: add(observer.position, offset), velocity, apparent, doppler: 1 };
  },
  galilean: (line, observer, c) => {
    const position = positionAt(line, observer.t, c);
    const velocity = scale(velocityAt(line, observer.t, c), 1 / c);
    return { time: observer.t, position, velocity, apparent: sub(position, observer.position), doppler: 1 };
  },
};
