import type { Material as GltfMaterial, Primitive } from '@gltf-transform/core';
import type { MappingList } from '@gltf-transform/extensions';
import { listed, msg } from '../../../messages/message.ts';
import type { VariantSet } from '../../../scene/types.ts';
import { type GltfContext, gltfError } from '../context.ts';

const EXTENSION = 'KHR_materials_variants';
/** Name of glTF's single, unnamed set of variants. */
const SET = 'material';

/** Material variants with the selected one; undefined if none. */
export function variantSet({
  entry,
  json,
  options,
}: Pick<GltfContext, 'entry' | 'json' | 'options'>): VariantSet | undefined {
  const listedVariants = json.extensions?.[EXTENSION] as { variants?: { name?: string }[] } | undefined;
  const names = (listedVariants?.variants ?? []).map(({ name }, i) => name || `variant ${i}`);
  const chosen = options.variants?.get(SET) ?? '';
  if (chosen !== '' && !names.includes(chosen)) {
    const known = names.length > 0 ? msg`there are ${listed(names)}` : msg`the file has none`;
    throw gltfError(entry, 'gltf.no-variant', '', msg`no variant ${chosen} of its materials; ${known}`);
  }
  return names.length > 0 ? { set: SET, options: [...new Set(names)], chosen } : undefined;
}

/** A primitive's material in the selected variant, or its default. */
export function materialOf({ variants }: GltfContext, primitive: Primitive): GltfMaterial | null {
  const place = variants ? variants.options.indexOf(variants.chosen) : -1;
  const mappings = primitive.getExtension<MappingList>(EXTENSION)?.listMappings() ?? [];
  const isChosen = (name: string): boolean => (name || `variant ${place}`) === variants?.chosen;
  const found = place < 0 ? undefined : mappings.find((m) => m.listVariants().some((v) => isChosen(v.getName())));
  return found ? found.getMaterial() : primitive.getMaterial();
}
