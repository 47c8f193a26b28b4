import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { approachesC, fastestVertex } from '../../scene/motion/motion.ts';
import { retime } from '../../scene/motion/retime.ts';
import { timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { LoadedScene } from '../services.ts';

/** Time offset and speed of a scene's animation. */
export const retimeNode = defineNode({
  id: 'retime',
  title: 'node.retime',
  help: 'node.retime.help',
  category: 'geometry',
  params: {
    speed: {
      kind: 'number',
      title: 'param.animationSpeed',
      help: 'param.animationSpeed.help',
      unit: '×',
      default: 1,
      min: 0.01,
      max: 100,
      step: 0.01,
      scale: 'log',
    },
    offset: { ...timeParam('param.animationOffset', 0), help: 'param.animationOffset.help' },
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
