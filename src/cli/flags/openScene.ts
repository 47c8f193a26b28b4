import type { ReadOptions } from '../../formats/readOptions.ts';
import { listed, msg } from '../../messages/message.ts';
import { isAtOrBelow, tooLargeToFly } from '../../scene/motion/fly.ts';
import { changeMotion, type MotionChange } from '../../scene/motion/motionChange.ts';
import type { Scene } from '../../scene/types.ts';
import { renderableScene } from '../../scene/validation/renderableScene.ts';
import { openSceneFile } from '../files/sceneFiles.ts';
import { inputProblem, usageError } from '../terminal/exitCodes.ts';
import type { SceneFlags } from './sceneFlags.ts';
import { speedOfLight } from './viewFlags.ts';

const readOptions = ({ variant, animation, interpolation, subdivision }: SceneFlags): ReadOptions => ({
  interpolation,
  ...(variant && { variants: variant }),
  ...(subdivision !== undefined && { subdivision }),
  ...(animation !== undefined && { animation: /^\d+$/.test(animation) ? Number(animation) : animation }),
});

const motionChange = ({ speedFactor = 1, startOffset = 0, fly = [], flyShape = 'rest' }: SceneFlags): MotionChange => ({
  timing: { speed: speedFactor, offset: startOffset },
  flights: fly.map((flight) => ({ ...flight, authoredIn: flyShape })),
});

/** Opens a scene file with the flags' motions, without objects that cannot be drawn. */
export async function openSceneWithFlags(path: string, flags: SceneFlags): Promise<Scene> {
  const { scene } = renderableScene(await openSceneFile(path, readOptions(flags)));
  for (const flight of flags.fly ?? []) checkFlyFlag(scene, flight.path);
  return changeMotion(scene, motionChange(flags), speedOfLight(scene, flags.c));
}

function checkFlyFlag(scene: Scene, path: string): void {
  const near = scene.objects.map((object) => object.path).slice(0, 8);
  if (!scene.objects.some((object) => isAtOrBelow(object.path, path)))
    throw usageError(msg`--fly ${path}: the scene has no such thing; it has ${listed(near) || msg`none`}`);
  const [large] = tooLargeToFly(scene, path);
  if (large !== undefined) throw inputProblem(msg`${large}: it deforms, and has too many samples to be carried along`);
}
