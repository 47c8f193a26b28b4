import { length } from '../../math/vec3.ts';
import { isAlive } from '../motion/lifetimes.ts';
import { vertexWorldLine } from '../motion/motion.ts';
import type { SceneObject } from '../types.ts';
import type { ProbedEvent, ProbeObserver, ProbeOptions } from '../views/viewRecord.ts';
import { VIEWS, type View } from '../views/views.ts';

/** A vertex as seen by an observer. */
export interface VertexProbe extends ProbedEvent {
  /** Its index in the mesh. */
  readonly vertex: number;
  /** |apparent| [m]. */
  readonly distance: number;
  /** Whether the event lies within the object's lifetime. */
  readonly visible: boolean;
}

/**
 * What an observer sees of each vertex, computed in f64; undefined if its light never arrives (beyond a horizon).
 * c [m/s].
 * @example
 * const object = makeObject({ path: '/Cube', mesh: box([1, 1, 1]) });
 * probeVertices(object, { t: 0, position: [0, 0, 5], u: [0, 0, 0] }, 10).length; // 24
 */
export function probeVertices(
  object: SceneObject,
  observer: ProbeObserver,
  c: number,
  view: View = 'light-cone',
  options: ProbeOptions = {},
): (VertexProbe | undefined)[] {
  return Array.from({ length: object.mesh.positions.length / 3 }, (_, i) =>
    probeVertex(object, i, observer, c, view, options),
  );
}

/**
 * What an observer sees of one vertex; undefined if its light never arrives. c [m/s].
 * @example
 * // At 0.6 c, a vertex 4 m ahead appears D = 2 times as far, and its light is twice as blue.
 * const point = makeObject({ path: '/Point', mesh: plane(0, 0), motion: restingAt([0, 0, -4]) });
 * const probe = probeVertex(point, 0, { t: 0, position: [0, 0, 0], u: [0, 0, -0.75] }, 10)!;
 * probe.doppler; // 2
 * probe.distance; // 8 m
 * probe.time; // -0.4 s
 */
export function probeVertex(
  object: SceneObject,
  vertex: number,
  observer: ProbeObserver,
  c: number,
  view: View = 'light-cone',
  options: ProbeOptions = {},
): VertexProbe | undefined {
  const shown = VIEWS[view].probe(vertexWorldLine(object, vertex, c), observer, c, options);
  if (!shown) return undefined;
  const visible = isAlive(object.lifetime, shown.time);
  return { vertex, ...shown, distance: length(shown.apparent), visible };
}
