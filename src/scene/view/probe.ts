import { length } from '../../math/vec3.ts';
import { vertexWorldLine } from '../motion/motion.ts';
import type { SceneObject } from '../types.ts';
import type { ProbedEvent, ProbeObserver } from '../views/viewRecord.ts';
import { VIEWS, type View } from '../views/views.ts';

/** A vertex as seen by an observer. */
export interface VertexProbe extends ProbedEvent {
  readonly vertex: number;
  /** |apparent| [m]. */
  readonly distance: number;
  /** Whether the event lies within the object's lifetime. */
  readonly visible: boolean;
}

/**
 * What an observer sees of each vertex, computed in f64; undefined if its light never arrives (beyond a horizon).
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
  const shown = VIEWS[view].probe(vertexWorldLine(object, vertex, c), observer, c);
  if (!shown) return undefined;
  const { birth, death } = object.lifetime;
  const visible = shown.time >= birth && shown.time <= death;
  return { vertex, ...shown, distance: length(shown.apparent), visible };
}
