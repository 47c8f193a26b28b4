import { msg } from '../../messages/message.ts';
import { withObjects } from '../../scene/compose/assignMaterial.ts';
import { matchesPath } from '../../scene/compose/mergeScenes.ts';
import { toLoadedScene } from '../common/loadedScene.ts';
import { assertPathExists, nodeRefusal, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { countParam } from './primitives/definePrimitive.ts';

/** Subdivides triangles into four, optionally smoothing the surface. */
export const subdivideNode = defineNode({
  id: 'subdivide',
  title: msg`Subdivide`,
  help: msg`Splits triangles into four, or makes a smooth surface from them. Not needed for rendering, which tessellates edges for each picture.`,
  category: 'geometry',
  heavy: true,
  params: {
    which: whichParam,
    levels: countParam(msg`Levels`, 1, 0, 6),
    surface: {
      kind: 'choice',
      title: msg`Surface`,
      help: msg`The same shape with smaller triangles, or a smooth surface (Loop subdivision).`,
      default: 'same',
      options: [
        { value: 'same', title: msg`Same shape` },
        { value: 'smooth', title: msg`Smooth` },
      ],
    },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  async evaluate({ geometry: { scene } }, { which, levels, surface }, { node }) {
    // The page evaluates this in a worker, which loads the code on demand.
    const { canSubdivide, MAX_TRIANGLES, loopSubdivide, midpointSubdivide, trianglesAfter } = await import(
      '../../scene/compose/subdivideObject.ts'
    );
    assertPathExists(scene, which, node);
    const chosen = scene.objects.filter(({ path }) => matchesPath(path, which));
    const triangles = chosen.reduce((sum, { mesh }) => sum + trianglesAfter(mesh, levels), 0);
    if (triangles > MAX_TRIANGLES) {
      const message = msg`${levels} levels would make ${triangles.toExponential(1)} triangles, more than ${MAX_TRIANGLES}; take fewer levels, or fewer things`;
      throw nodeRefusal('subdivide.many', `${node}.levels`, message, { node, param: 'levels', value: levels - 1 });
    }
    const stored = chosen.find((object) => !canSubdivide(object));
    if (stored) {
      const message = msg`${stored.path} deforms and its samples are left in their file, so that they cannot be cut; choose other things`;
      throw nodeRefusal('subdivide.stored', stored.path, message);
    }
    const finer = surface === 'smooth' ? loopSubdivide : midpointSubdivide;
    const objects = withObjects(scene, which, (object) => (levels === 0 ? object : finer(object, levels)));
    return { geometry: toLoadedScene({ ...scene, objects }) };
  },
});
