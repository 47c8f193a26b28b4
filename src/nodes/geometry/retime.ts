import { msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { approachesC, fastestVertex } from '../../scene/motion/motion.ts';
import { retime } from '../../scene/motion/retime.ts';
import { timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { LoadedScene } from '../services.ts';

/** Time offset and speed of a scene's animation. */
export const retimeNode = defineNode({
  id: 'retime',
  title: msg`Animation`,
  help: msg`When the file’s animation begins, and how fast it runs. Motion faster than light is refused.`,
  category: 'geometry',
  params: {
    speed: {
      kind: 'number',
      title: msg`Animation speed`,
      help: msg`Multiplies all speeds in the file. A constant acceleration is multiplied by the square and still stays below c.`,
      unit: '×',
      default: 1,
      min: 0.01,
      max: 100,
      step: 0.01,
      scale: 'log',
    },
    offset: {
      ...timeParam(msg`Starts later by`, 0),
      help: msg`Delay of the animation relative to the file; negative values make it start earlier.`,
    },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry: loaded }, timing) {
    const scene = retime(loaded.scene, timing);
    return {
      geometry: scene === loaded.scene ? loaded : { ...loaded, scene, ...retimedFastest(scene, loaded, timing.speed) },
    };
  },
});

/**
 * The fastest point scales with the speed, at its new time; for what approaches c it is
 * recomputed.
 */
function retimedFastest(scene: LoadedScene['scene'], before: LoadedScene, speed: number): Pick<LoadedScene, 'fastest'> {
  const point = before.fastest;
  const object = point && scene.objects.find(({ path }) => path === point.path);
  if (!point || !object) return {};
  const { startTime, endTime, hints } = scene;
  if (approachesC(object.motion)) {
    const found = fastestVertex(object, hints.speedOfLight ?? SPEED_OF_LIGHT, [startTime, endTime]);
    return { fastest: { path: object.path, time: found.from, speed: found.speed } };
  }
  const time = startTime + (point.time - before.scene.startTime) / speed;
  return { fastest: { ...point, time, speed: point.speed * speed } };
}
