import { length, lerp, type Vec3, ZERO } from '../math/vec3.ts';
import { msg } from '../messages/message.ts';
import { properVelocityAt, type WorldLine } from '../physics/worldLines/worldLine.ts';
import { boundingBox } from '../scene/bounds/bounds.ts';
import { isAlive } from '../scene/motion/lifetimes.ts';
import { deforms, isStatic, vertexWorldLine } from '../scene/motion/motion.ts';
import type { Lifetime } from '../scene/motion/motionTypes.ts';
import type { Scene, SceneObject } from '../scene/types.ts';
import type { ProbeObserver } from '../scene/views/viewRecord.ts';
import type { DiagramBody } from './energyDiagram.ts';

/** A world line of the scene that a diagram shows. */
export interface DiagramLine {
  /** For people. */
  readonly name: string;
  readonly line: WorldLine;
  readonly lifetime: Lifetime;
}

/** Whether an object is one of those that a path chooses: itself, a piece of it, or below it. */
const isChosen = ({ path, pieceOf }: SceneObject, chosen: string): boolean =>
  path === chosen || pieceOf === chosen || path.startsWith(chosen.endsWith('/') ? chosen : `${chosen}/`);

/** The objects at or below the paths, in the scene's order. */
export const chosenObjects = (scene: Scene, paths: readonly string[]): readonly SceneObject[] =>
  scene.objects.filter((object) => paths.some((path) => isChosen(object, path)));

/** Paths of things, pieces of one thing counted once. */
export const thingPaths = (objects: readonly SceneObject[]): readonly string[] => [
  ...new Set(objects.map(({ path, pieceOf }) => pieceOf ?? path)),
];

/**
 * Paths that a diagram shows unless others are chosen: what moves, else everything; at most `limit` things, pieces of one
 * thing counted once.
 */
export function suggestedPaths(scene: Scene, limit: number): readonly string[] {
  const moving = scene.objects.filter(({ motion }) => !isStatic(motion));
  return thingPaths(moving.length > 0 ? moving : scene.objects).slice(0, limit);
}

/**
 * The world line that stands for an object: of the middle of its bounding box, carried by its frame; of a deforming object of
 * the vertex nearest to that middle. c [m/s].
 */
export function diagramLine(object: SceneObject, c: number): DiagramLine {
  const { path, pieceOf, mesh, lifetime } = object;
  const middle = middleOf(mesh.positions);
  const line = deforms(object.motion)
    ? vertexWorldLine(object, nearestVertex(mesh.positions, middle), c)
    : vertexWorldLine({ ...object, mesh: { ...mesh, positions: Float32Array.from(middle) } }, 0, c);
  return { name: pieceOf ?? path, line, lifetime };
}

/** The observer, and those of the lines that move and exist at world time t [s], with their speeds. c [m/s]. */
export function diagramBodies(
  lines: readonly DiagramLine[],
  { t, u }: Pick<ProbeObserver, 't' | 'u'>,
  c: number,
): readonly DiagramBody[] {
  const moving = lines
    .filter(({ lifetime }) => isAlive(lifetime, t))
    .map(({ name, line }) => ({ name, properSpeed: length(properVelocityAt(line, t, c)) }))
    .filter(({ properSpeed }) => properSpeed > 0);
  return [{ name: msg`Observer`, properSpeed: length(u) }, ...moving];
}

function middleOf(positions: Float32Array): Vec3 {
  const box = boundingBox(positions);
  return box ? lerp(box.min, box.max, 0.5) : ZERO;
}

function nearestVertex(positions: Float32Array, [x, y, z]: Vec3): number {
  let [best, least] = [0, Number.POSITIVE_INFINITY];
  for (let i = 0; i < positions.length / 3; i++) {
    const d = Math.hypot(positions[3 * i]! - x, positions[3 * i + 1]! - y, positions[3 * i + 2]! - z);
    if (d < least) [best, least] = [i, d];
  }
  return best;
}
