import { ANY_FORMAT } from '../../formats/formatLists.ts';
import { parseVariantChoice } from '../../formats/variantChoice.ts';
import { msg } from '../../messages/message.ts';
import { InputError } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';

/** Reads a scene file of any supported format. */
export const readNode = defineNode({
  id: 'read',
  title: msg`Read`,
  help: msg`Reads a scene file: ${ANY_FORMAT}.`,
  category: 'geometry',
  params: {
    source: { kind: 'text', title: msg`File`, default: '', file: true },
    prim: {
      kind: 'text',
      title: msg`Prim path`,
      help: msg`Only this prim and what is below it, such as /World/Car, where it is in the stage and with the materials that it inherits; empty: everything.`,
      default: '',
    },
    /** `set=option`, as `Scene.variants` names them: `/World/Car{paint}=red`. */
    variants: { kind: 'list', title: msg`Variants`, default: [] },
    interpolation: {
      kind: 'choice',
      title: msg`Between samples`,
      help: msg`Interpolation between the time samples of a USD file: linear, as USD specifies, or cubic, so that velocities do not jump.`,
      default: 'linear',
      options: [
        { value: 'linear', title: msg`Linear` },
        { value: 'cubic', title: msg`Cubic` },
      ],
    },
  },
  inputs: {},
  outputs: { geometry: { type: 'geometry' } },
  async evaluate(_inputs, { source, prim, variants, interpolation }, { node, services, signal, progress }) {
    if (!source) throw nodeRefusal('read.none', node, msg`no file is chosen; open one, or take one of the examples`);
    try {
      return {
        geometry: await services.readScene(source, {
          variants: parseVariants(variants),
          interpolation,
          ...(prim && { prim }),
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
