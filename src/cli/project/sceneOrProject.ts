import { chosenObjects } from '../../diagrams/diagramLines.ts';
import { suggestedPaths } from '../../diagrams/suggestedPaths.ts';
import { listed, msg } from '../../messages/message.ts';
import { initialBeta } from '../../nodes/pictures/renderSettings.ts';
import type { Scene, SceneObject } from '../../scene/types.ts';
import { openSceneWithFlags } from '../flags/openScene.ts';
import type { SceneOrProjectFlags } from '../flags/sceneOrProjectFlags.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { Progress } from '../terminal/progress.ts';
import { isProject, openProjectPicture, refuseSets } from './project.ts';

/** A scene file, or a project's scene with its picture's observer and speed of light where the flags do not say them. */
export async function openSceneOrProject<Flags extends SceneOrProjectFlags>(
  path: string,
  flags: Flags,
  given: ReadonlySet<string>,
): Promise<{ readonly scene: Scene; readonly flags: Flags }> {
  if (!(await isProject(path))) {
    refuseSets(flags.set);
    return { scene: await openSceneWithFlags(path, flags), flags };
  }
  const progress = new Progress();
  const picture = await openProjectPicture(path, flags.set ?? [], given, progress.node);
  progress.clear();
  const { scene, speedOfLight: c, camera, smooth } = picture;
  const beta = flags.position ? undefined : initialBeta(picture, false);
  const cameraPath = given.has('cameraPath') || smooth ? flags.cameraPath : 'straight';
  return { scene, flags: { c, ...(camera && { camera }), ...(beta && { beta }), ...flags, cameraPath } };
}

/** Things that are looked at unless they are chosen. */
const SUGGESTED = 12;

/** The objects of `--prim`, or what moves. Throws if the scene has nothing at or below a path. c [m/s]. */
export function thingsOf(scene: Scene, paths: readonly string[] | undefined, c: number): readonly SceneObject[] {
  const unknown = paths?.find((path) => chosenObjects(scene, [path]).length === 0);
  if (unknown === undefined) return chosenObjects(scene, paths ?? suggestedPaths(scene, SUGGESTED, c));
  const near = scene.objects.map((object) => object.path).slice(0, 8);
  throw usageError(msg`--prim ${unknown}: the scene has no such thing; it has ${listed(near) || msg`none`}`);
}
