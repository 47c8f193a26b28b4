import { moved, movedReach, movingAt } from '../../scene/compose/moved.ts';
import { motionOf } from '../../scene/compose/paths.ts';
import type { FrameMotion, SceneObject } from '../../scene/types.ts';
import { defineNode } from '../define.ts';
import { checkPath, refusal, whichParam } from './shared.ts';
import { surveyed } from './surveyed.ts';

/** Things at rest moved, all as one body. */
export const moveNode = defineNode({
  id: 'move',
  title: 'node.move',
  help: 'node.move.help',
  category: 'geometry',
  params: {
    which: whichParam,
    authoredIn: {
      kind: 'choice',
      title: 'param.flyShape',
      help: 'param.flyShape.help',
      default: 'world',
      options: [
        { value: 'rest', title: 'fly.rest' },
        { value: 'world', title: 'fly.world' },
      ],
    },
  },
  inputs: { geometry: { type: 'geometry' }, motion: { type: 'motion' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry: { scene }, motion: course }, { which, authoredIn }, { node }) {
    checkPath(scene, which, node);
    const [moving] = movingAt(scene, which);
    if (moving !== undefined) {
      const message = `${moving} moves already; put this before what moves it, or choose things at rest`;
      throw refusal('move.moving', moving, message);
    }
    const motion = motionOf(course, movedReach(scene, which));
    const carried = moved(scene, which, motion, authoredIn as SceneObject['authoredIn']);
    return { geometry: surveyed({ ...carried, ...rangeWith(scene, motion) }) };
  },
});

/** The range of time holds what is sampled. */
function rangeWith({ startTime, endTime }: { startTime: number; endTime: number }, motion: FrameMotion) {
  if (motion.kind !== 'sampled') return { startTime, endTime };
  const [first, last] = [motion.times[0]!, motion.times[motion.times.length - 1]!];
  const still = endTime <= startTime;
  return { startTime: still ? first : Math.min(startTime, first), endTime: still ? last : Math.max(endTime, last) };
}
