import { withObjects } from '../../scene/compose/dress.ts';
import { isChosen } from '../../scene/compose/merge.ts';
import { defineNode } from '../define.ts';
import { pieces } from './primitive.ts';
import { checkPath, refusal, whichParam } from './shared.ts';
import { surveyed } from './surveyed.ts';

/** Cuts triangles in four, or makes a smooth surface of them. */
export const subdivideNode = defineNode({
  id: 'subdivide',
  title: 'node.subdivide',
  help: 'node.subdivide.help',
  category: 'geometry',
  heavy: true,
  params: {
    which: whichParam,
    levels: pieces('param.levels', 1, 0, 6),
    surface: {
      kind: 'choice',
      title: 'param.surface',
      help: 'param.surface.help',
      default: 'same',
      options: [
        { value: 'same', title: 'surface.same' },
        { value: 'smooth', title: 'surface.smooth' },
      ],
    },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  async evaluate({ geometry: { scene } }, { which, levels, surface }, { node }) {
    // Pages evaluate it in a worker: what it needs is loaded there.
    const { canBeFiner, MOST_TRIANGLES, smooth, split, trianglesAfter } = await import('../../scene/compose/finer.ts');
    checkPath(scene, which, node);
    const chosen = scene.objects.filter(({ path }) => isChosen(path, which));
    const triangles = chosen.reduce((sum, { mesh }) => sum + trianglesAfter(mesh, levels), 0);
    if (triangles > MOST_TRIANGLES) {
      const message = `${levels} levels would make ${triangles.toExponential(1)} triangles, more than ${MOST_TRIANGLES}; take fewer levels, or fewer things`;
      throw refusal('subdivide.many', `${node}.levels`, message, { node, param: 'levels', value: levels - 1 });
    }
    const stored = chosen.find((object) => !canBeFiner(object));
    if (stored) {
      const message = `${stored.path} deforms and its samples are left in their file, so that they cannot be cut; choose other things`;
      throw refusal('subdivide.stored', stored.path, message);
    }
    const finer = surface === 'smooth' ? smooth : split;
    const objects = withObjects(scene, which, (object) => (levels === 0 ? object : finer(object, levels)));
    return { geometry: surveyed({ ...scene, objects }) };
  },
});
