import { length } from '../math/vec3.ts';
import { msg } from '../messages/message.ts';
import { properVelocityAt, type WorldLine } from '../physics/worldLines/worldLine.ts';
import { isAlive } from '../scene/motion/lifetimes.ts';
import { middleWorldLine } from '../scene/motion/middleWorldLine.ts';
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

/** The world line that stands for an object. c [m/s]. */
export const diagramLine = (object: SceneObject, c: number): DiagramLine => ({
  name: object.pieceOf ?? object.path,
  line: middleWorldLine(object, c),
  lifetime: object.lifetime,
});

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
