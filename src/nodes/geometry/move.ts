import { msg } from '../../messages/message.ts';
import { applyRigidMotion, movingPaths, reachFromOrigin } from '../../scene/compose/applyRigidMotion.ts';
import { motionFromPath } from '../../scene/compose/motionPaths.ts';
import { sampleTimes } from '../../scene/motion/motion.ts';
import type { Diagnostic, RigidMotion, SceneObject } from '../../scene/types.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { assertPathExists, authoredInParam, nodeRefusal, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Moves objects, lights and cameras at rest, all as one body. */
export const moveNode = defineNode({
  id: 'move',
  title: msg`Motion`,
  help: msg`Moves objects, lights and cameras that are at rest, all as one body. Ride a camera to see what it sees.`,
  category: 'geometry',
  params: {
    which: whichParam,
    authoredIn: authoredInParam('world'),
  },
  inputs: { geometry: { type: 'geometry' }, motion: { type: 'motion' } },
  outputs: { geometry: { type: 'geometry' } },
  evaluate({ geometry: { scene }, motion: course }, { which, authoredIn }, { node }) {
    assertPathExists(scene, which, node, scene.cameras);
    const named = scene.cameras.filter(({ path }) => path === which);
    const [moving] = movingPaths([...scene.objects, ...named], which);
    if (moving !== undefined) {
      const message = msg`${moving} moves already; put this before what moves it, or choose things at rest`;
      throw nodeRefusal('move.moving', moving, message);
    }
    const kept = movingPaths(scene.cameras, which).map((path): Diagnostic => {
      const message = msg`it moves already and keeps its own motion; only cameras at rest are moved`;
      return { severity: 'warning', code: 'move.camera', place: msg`${node}: ${path}`, message };
    });
    const motion = motionFromPath(course, reachFromOrigin(scene, which));
    const moved = applyRigidMotion(scene, which, motion, authoredIn as SceneObject['authoredIn']);
    const diagnostics = [...scene.diagnostics, ...kept];
    return { geometry: toLoadedScene({ ...moved, ...timeRangeIncluding(scene, motion), diagnostics }) };
  },
});

/** Extends the time range to include a sampled motion. */
function timeRangeIncluding({ startTime, endTime }: { startTime: number; endTime: number }, motion: RigidMotion) {
  const times = sampleTimes(motion);
  if (!times) return { startTime, endTime };
  const [first, last] = [times[0]!, times[times.length - 1]!];
  const still = endTime <= startTime;
  return { startTime: still ? first : Math.min(startTime, first), endTime: still ? last : Math.max(endTime, last) };
}
