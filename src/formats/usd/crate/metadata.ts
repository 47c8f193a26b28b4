import { msg } from '../../../messages/message.ts';
import {
  EMPTY_MAP,
  type ListOp,
  type MetadataValue,
  type ReferenceSpec,
  type Value,
  withEntry,
} from '../layer/layer.ts';
import { parseUnregistered, parseUnregisteredItems } from '../text/metadata.ts';
import type { SpecFields } from './specReader.ts';
import type { FieldValue } from './values/fieldValue.ts';

/** Names of fields that text calls otherwise. */
export const WRITTEN: ReadonlyMap<string, string> = new Map([
  ['inheritPaths', 'inherits'],
  ['layerRelocates', 'relocates'],
  ['variantSelection', 'variants'],
  ['variantSetNames', 'variantSets'],
]);

export const PERMISSIONS = ['public', 'private'];

/** The metadata among a spec's fields, as the text reader has it. */
export function metadataOf(fields: SpecFields): ReadonlyMap<string, MetadataValue> {
  let metadata: ReadonlyMap<string, MetadataValue> = EMPTY_MAP;
  const subLayers = subLayersOf(fields);
  if (subLayers) metadata = withEntry<MetadataValue>(metadata, 'subLayers', { type: 'subLayers', data: subLayers });
  fields.forEachRemaining((name, field) => {
    const key = WRITTEN.get(name) ?? name;
    metadata = withEntry(metadata, key, entryOf(fields, key, field));
  });
  return metadata;
}

/** Layers below this one, and where on its time line they begin. */
function subLayersOf(fields: SpecFields): ReferenceSpec[] | undefined {
  const assets = fields.names('subLayers');
  const offsets = fields.take('subLayerOffsets', 'offsets')?.data;
  return assets?.map((asset, i) => ({ asset, path: '', offset: 0, scale: 1, ...offsets?.[i] }));
}

function entryOf(fields: SpecFields, key: string, field: FieldValue): MetadataValue {
  switch (field.type) {
    case 'permission':
      return { type: 'token', data: PERMISSIONS[field.data] ?? fields.fail(msg`its permission is ${field.data}`) };
    case 'names':
      return { type: 'token[]', data: field.data };
    case 'times':
      return { type: 'double[]', data: field.data };
    case 'unregistered':
      return parseUnregistered(key, field.data);
    case 'unregistereds':
      return { type: 'unregistereds', op: splitItems(field.op) };
    case 'dictionary':
      return key.endsWith('Substitutions') ? { type: 'texts-by-name', data: textsOf(fields, key, field.data) } : field;
    case 'timeSamples':
    case 'spline':
    case 'offsets':
    case 'specifier':
    case 'variability':
      return fields.fail(msg`its metadata ${key} is of kind ${field.type}`);
    default:
      return field;
  }
}

function textsOf(fields: SpecFields, key: string, data: ReadonlyMap<string, Value>): Map<string, string> {
  const text = (value: Value): string =>
    value.type === 'string' ? value.data : fields.fail(msg`its ${key} hold a ${value.type}, not only strings`);
  return new Map([...data].map(([from, to]) => [from, text(to)]));
}

/** The text of a whole list is one item; each item is made one. */
function splitItems(op: ListOp<Value>): ListOp<Value> {
  const split = (items: readonly Value[]): Value[] =>
    items.flatMap((item) => (item.type === 'unregistered' ? parseUnregisteredItems(item.data) : [item]));
  return Object.fromEntries(Object.entries(op).map(([list, items]) => [list, split(items)]));
}
