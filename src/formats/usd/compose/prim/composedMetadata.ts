import { type Dictionary, EMPTY_MAP, type ListOp, type MetadataValue, type Value } from '../../layer/layer.ts';
import { composeList } from '../layers/listOps.ts';
import { type OpinionSource, stageValue } from './stageValues.ts';

/** Metadata consumed by composition. */
const ARC_KEYS = new Set(['references', 'payload', 'inherits', 'specializes', 'variantSets', 'variants', 'relocates']);

interface SourcedMetadata {
  readonly metadata: ReadonlyMap<string, MetadataValue>;
  readonly place: OpinionSource;
}

/** The strongest value of each key; lists are composed, dictionaries merged entry by entry. */
export function composeMetadata(said: readonly SourcedMetadata[]): ReadonlyMap<string, MetadataValue> {
  const stacks = new Map<string, { value: MetadataValue; place: OpinionSource }[]>();
  for (const { metadata, place } of said) {
    for (const [key, value] of metadata) {
      if (ARC_KEYS.has(key)) continue;
      const stack = stacks.get(key);
      if (stack) stack.push({ value, place });
      else stacks.set(key, [{ value, place }]);
    }
  }
  if (stacks.size === 0) return EMPTY_MAP;
  return new Map([...stacks].map(([key, stack]) => [key, composeValues(stack)]));
}

function composeValues(stack: readonly { value: MetadataValue; place: OpinionSource }[]): MetadataValue {
  const [{ value, place }] = stack;
  switch (value.type) {
    case 'dictionary':
      return { type: 'dictionary', data: mergedDictionaries(stack.flatMap((s) => dictionaryOf(s.value, s.place))) };
    case 'texts':
      return {
        type: 'texts',
        op: composedListOp(
          stack,
          (v) => (v.type === 'texts' ? [v.op] : []),
          (text) => text,
        ),
      };
    case 'integers':
      return { type: 'integers', op: composedListOp(stack, (v) => (v.type === 'integers' ? [v.op] : []), String) };
    case 'unregistereds':
    case 'paths':
    case 'arcs':
    case 'subLayers':
    case 'relocates':
    case 'texts-by-name':
      return value;
    default:
      return stageValue(value, place);
  }
}

function composedListOp<T>(
  stack: readonly { value: MetadataValue }[],
  opOf: (value: MetadataValue) => ListOp<T>[],
  keyOf: (item: T) => string,
): ListOp<T> {
  return {
    explicit: composeList(
      stack.flatMap(({ value }) => opOf(value)),
      keyOf,
    ),
  };
}

function dictionaryOf(value: MetadataValue, place: OpinionSource): Dictionary[] {
  if (value.type !== 'dictionary') return [];
  const local = stageValue(value, place);
  return local.type === 'dictionary' ? [local.data] : [];
}

/** Strongest first. */
function mergedDictionaries(dictionaries: readonly Dictionary[]): Dictionary {
  const out = new Map<string, Value>();
  for (const dictionary of dictionaries) {
    for (const [key, value] of dictionary) {
      const stronger = out.get(key);
      if (!stronger) out.set(key, value);
      else if (stronger.type === 'dictionary' && value.type === 'dictionary')
        out.set(key, { type: 'dictionary', data: mergedDictionaries([stronger.data, value.data]) });
    }
  }
  return out;
}
