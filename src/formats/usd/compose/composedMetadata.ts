import { type Dictionary, type ListOp, type MetadataValue, NOTHING, type Value } from '../layer.ts';
import { composeList } from './listOps.ts';
import { localValue, type Place } from './localValues.ts';

/** What composition itself is told by, and what is left of it nowhere. */
const ARCS = new Set(['references', 'payload', 'inherits', 'specializes', 'variantSets', 'variants', 'relocates']);

interface SaidMetadata {
  readonly metadata: ReadonlyMap<string, MetadataValue>;
  readonly place: Place;
}

/** The strongest value of each key; lists are composed, dictionaries merged entry by entry. */
export function composeMetadata(said: readonly SaidMetadata[]): ReadonlyMap<string, MetadataValue> {
  const stacks = new Map<string, { value: MetadataValue; place: Place }[]>();
  for (const { metadata, place } of said) {
    for (const [key, value] of metadata) {
      if (ARCS.has(key)) continue;
      const stack = stacks.get(key);
      if (stack) stack.push({ value, place });
      else stacks.set(key, [{ value, place }]);
    }
  }
  if (stacks.size === 0) return NOTHING;
  return new Map([...stacks].map(([key, stack]) => [key, composeValues(stack)]));
}

function composeValues(stack: readonly { value: MetadataValue; place: Place }[]): MetadataValue {
  const [{ value, place }] = stack;
  switch (value.type) {
    case 'dictionary':
      return { type: 'dictionary', data: merged(stack.flatMap((s) => dictionaryOf(s.value, s.place))) };
    case 'texts':
      return {
        type: 'texts',
        op: folded(
          stack,
          (v) => (v.type === 'texts' ? [v.op] : []),
          (text) => text,
        ),
      };
    case 'integers':
      return { type: 'integers', op: folded(stack, (v) => (v.type === 'integers' ? [v.op] : []), String) };
    case 'unregistereds':
    case 'paths':
    case 'arcs':
    case 'subLayers':
    case 'relocates':
    case 'texts-by-name':
      return value;
    default:
      return localValue(value, place);
  }
}

function folded<T>(
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

function dictionaryOf(value: MetadataValue, place: Place): Dictionary[] {
  if (value.type !== 'dictionary') return [];
  const local = localValue(value, place);
  return local.type === 'dictionary' ? [local.data] : [];
}

/** The strongest first. */
function merged(dictionaries: readonly Dictionary[]): Dictionary {
  const out = new Map<string, Value>();
  for (const dictionary of dictionaries) {
    for (const [key, value] of dictionary) {
      const stronger = out.get(key);
      if (!stronger) out.set(key, value);
      else if (stronger.type === 'dictionary' && value.type === 'dictionary')
        out.set(key, { type: 'dictionary', data: merged([stronger.data, value.data]) });
    }
  }
  return out;
}
