import { msg } from '../../messages/message.ts';
import { nodeRefusal, readOrRefuse } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Reads a simulation's results from the file that they were written to, instead of computing them again. */
export const cacheNode = defineNode({
  id: 'cache',
  title: msg`Cache`,
  help: msg`Reads a simulation’s results from a file instead of running it again; without a file the input passes through. “slowlight simulate PROJECT -o FILE” or Write USD writes it.`,
  category: 'dynamics',
  params: {
    file: {
      kind: 'text',
      title: msg`File`,
      help: msg`The file is used as it is, even if the input has changed since.`,
      default: '',
      file: true,
    },
  },
  inputs: { geometry: { type: 'geometry', optional: true } },
  outputs: { geometry: { type: 'geometry' } },
  needs: ({ file }) => (file === '' ? ['geometry'] : []),
  async evaluate({ geometry }, { file }, { node, services, signal, progress }) {
    if (file === '') {
      if (geometry) return { geometry };
      throw nodeRefusal(
        'cache.none',
        node,
        msg`it passes on what comes in; connect something, or name a file to read instead`,
      );
    }
    const how = { interpolation: 'cubic', signal, progress } as const;
    return { geometry: await readOrRefuse(() => services.readScene(file, how), { node, param: 'file', value: '' }) };
  },
});
