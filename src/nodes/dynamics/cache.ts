import { InputError } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Reads a simulation's results from the file that they were written to, instead of computing them again. */
export const cacheNode = defineNode({
  id: 'cache',
  title: 'node.cache',
  help: 'node.cache.help',
  category: 'dynamics',
  params: { file: { kind: 'text', title: 'node.read.source', help: 'param.cached.help', default: '', file: true } },
  inputs: { geometry: { type: 'geometry', optional: true } },
  outputs: { geometry: { type: 'geometry' } },
  needs: ({ file }) => (file === '' ? ['geometry'] : []),
  async evaluate({ geometry }, { file }, { node, services, signal, progress }) {
    if (file === '') {
      if (geometry) return { geometry };
      throw nodeRefusal(
        'cache.none',
        node,
        'it passes on what comes in; connect something, or name a file to read instead',
      );
    }
    try {
      return { geometry: await services.readScene(file, { interpolation: 'cubic', signal, progress }) };
    } catch (error) {
      if (!(error instanceof InputError)) throw error;
      const { code, place, message } = error.diagnostic;
      throw nodeRefusal(code, place, message, { node, param: 'file', value: '' });
    }
  },
});
