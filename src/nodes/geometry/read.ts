import { parseVariantChoice } from '../../formats/variantChoice.ts';
import { InputError } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Reads a scene file of any supported format. */
export const readNode = defineNode({
  id: 'read',
  title: 'node.read',
  help: 'node.read.help',
  category: 'geometry',
  params: {
    source: { kind: 'text', title: 'node.read.source', default: '', file: true },
    /** `set=option`, as `Scene.variants` names them: `/World/Car{paint}=red`. */
    variants: { kind: 'list', title: 'node.read.variants', default: [] },
    interpolation: {
      kind: 'choice',
      title: 'node.read.interpolation',
      help: 'node.read.interpolation.help',
      default: 'linear',
      options: [
        { value: 'linear', title: 'interpolation.linear' },
        { value: 'cubic', title: 'interpolation.cubic' },
      ],
    },
  },
  inputs: {},
  outputs: { geometry: { type: 'geometry' } },
  async evaluate(_inputs, { source, variants, interpolation }, { node, services, signal, progress }) {
    if (!source) throw nodeRefusal('read.none', node, 'no file is chosen; open one, or take one of the examples');
    try {
      return {
        geometry: await services.readScene(source, {
          variants: parseVariants(variants),
          interpolation,
          signal,
          progress,
        }),
      };
    } catch (error) {
      if (!(error instanceof InputError)) throw error;
      const { code, place, message } = error.diagnostic;
      throw nodeRefusal(code, place, message);
    }
  },
});

/** Options by variant set; invalid entries are skipped. */
export const parseVariants = (variants: readonly string[]): ReadonlyMap<string, string> =>
  new Map(variants.flatMap((text) => [parseVariantChoice(text)].filter((choice) => choice !== undefined)));
