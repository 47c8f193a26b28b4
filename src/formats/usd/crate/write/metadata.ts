import { msg } from '../../../../messages/message.ts';
import type { MetadataValue, ReferenceSpec } from '../../layer/layer.ts';
import { isFormerKey, isRegistered } from '../../text/metadata.ts';
import { PERMISSIONS, WRITTEN } from '../metadata.ts';
import { NON_ARRAY_TYPES } from '../values/crateTypes.ts';
import {
  packAssets,
  packIntegers,
  packOffsets,
  packPaths,
  packPayloads,
  packReferences,
  packRelocates,
  packSelections,
  packStrings,
  packTokens,
  packUnregistereds,
} from './listOps.ts';
import { inlined } from './rep.ts';
import type { ValuePacker } from './valuePacker.ts';

/** A field of a spec: its name and the representation of its value. */
export type PackedField = readonly [name: string, rep: bigint];

const FIELD_NAMES: ReadonlyMap<string, string> = new Map([...WRITTEN].map(([field, written]) => [written, field]));

/** Keys whose lists are of strings, not of tokens. */
const STRING_LISTS: ReadonlySet<string> = new Set(['variantSets', 'clipSets']);

export function* packMetadata(
  packer: ValuePacker,
  metadata: ReadonlyMap<string, MetadataValue>,
): Generator<PackedField> {
  for (const [key, value] of metadata) {
    if (value.type === 'subLayers') yield* packSubLayers(packer, value.data);
    else yield [FIELD_NAMES.get(key) ?? key, packEntry(packer, key, value)];
  }
}

function packEntry(
  packer: ValuePacker,
  key: string,
  value: Exclude<MetadataValue, { readonly type: 'subLayers' }>,
): bigint {
  switch (value.type) {
    case 'texts':
      return STRING_LISTS.has(key) ? packStrings(packer, value.op) : packTokens(packer, value.op);
    case 'integers':
      return packIntegers(packer, value.op);
    case 'paths':
      return packPaths(packer, value.op);
    case 'arcs':
      return key === 'payload' ? packPayloads(packer, value.op) : packReferences(packer, value.op);
    case 'relocates':
      return packRelocates(packer, value.data);
    case 'unregistereds':
      return packUnregistereds(packer, value.op);
    case 'texts-by-name':
      return key === 'variants' ? packSelections(packer, value.data) : packer.dictionary(strings(value.data));
    case 'bool':
      if (isFormerKey(key)) return packer.pack({ type: 'unregistered', data: String(value.data) });
      break;
    case 'token':
      if (isFormerKey(key)) return packer.pack({ type: 'unregistered', data: JSON.stringify(value.data) });
      if (key === 'permission') return inlined(NON_ARRAY_TYPES.permission, PERMISSIONS.indexOf(value.data));
      break;
    case 'dictionary':
      if (!isRegistered(key)) return packer.unregistered(packer.pack(value));
  }
  return packer.pack(value);
}

const strings = (texts: ReadonlyMap<string, string>) =>
  new Map([...texts].map(([key, data]) => [key, { type: 'string', data } as const]));

function* packSubLayers(packer: ValuePacker, layers: readonly ReferenceSpec[]): Generator<PackedField> {
  const odd = layers.find(({ path, customData }) => path !== '' || customData);
  if (odd) packer.fail(msg`the sublayer @${odd.asset}@ has a path or customData, which only references have`);
  yield [
    'subLayers',
    packAssets(
      packer,
      layers.map(({ asset }) => asset),
    ),
  ];
  yield ['subLayerOffsets', packOffsets(packer, layers)];
}
