import { parseChoice } from '../formats/choices.ts';
import { NodeRefusal } from '../graph/nodeType.ts';
import { InputError } from '../scene/types.ts';
import { defineNode } from './define.ts';

/** Reads a scene file of any kind that `formats/` knows. */
export const read = defineNode({
  id: 'read',
  title: 'node.read',
  help: 'node.read.help',
  category: 'geometry',
  params: {
    source: { kind: 'text', title: 'node.read.source', default: '' },
    /** `set=option`, as `Scene.variants` names them: `/World/Car{paint}=red`. */
    variants: { kind: 'list', title: 'node.read.variants', default: [] },
  },
  inputs: {},
  outputs: { scene: { type: 'scene' } },
  async evaluate(_inputs, { source, variants }, { node, services, signal, progress }) {
    if (!source) throw refusal('read.none', node, 'no file is chosen; open one, or take one of the examples');
    try {
      const chosen = new Map(variants.flatMap((text) => [parseChoice(text)].filter((choice) => choice !== undefined)));
      return { scene: await services.readScene(source, { variants: chosen, signal, progress }) };
    } catch (error) {
      if (!(error instanceof InputError)) throw error;
      const { code, place, message } = error.diagnostic;
      throw refusal(code, place, message);
    }
  },
});

const refusal = (code: string, place: string, message: string) =>
  new NodeRefusal({ severity: 'error', code, place, message });
