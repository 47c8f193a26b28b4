import type { ListOp, ReferenceSpec as WrittenArc } from '../../layer/layer.ts';
import { isVariantName } from '../../layer/primPaths.ts';
import { expandOrKeep } from './expressions.ts';
import type { Opinion, StackLayer } from './layerStack.ts';
import { applyListOp } from './listOps.ts';

/** Composed arcs of one site. */

/** A reference or payload with its authoring layer. */
export interface SourcedReference extends WrittenArc {
  readonly from: StackLayer;
}

type ArcKey = 'references' | 'payload';
type ClassKey = 'inherits' | 'specializes';

export function referencesAt(opinions: readonly Opinion[], key: ArcKey): SourcedReference[] {
  return composedList<SourcedReference>(
    opinions,
    ({ spec, from }) => {
      const value = spec.metadata.get(key);
      return value?.type === 'arcs' ? mapOp(value.op, (arc) => withSource(arc, from)) : undefined;
    },
    // The same asset path is a different file relative to another layer.
    ({ asset, path, offset, scale, from }) => `${asset && from.source.id}\n${asset}\n${path}\n${offset} ${scale}`,
  );
}

const withSource = ({ asset, path, offset, scale }: WrittenArc, from: StackLayer): SourcedReference => {
  return { asset, path, offset, scale, from };
};

export const classesAt = (opinions: readonly Opinion[], key: ClassKey): string[] =>
  composedList(
    opinions,
    ({ spec }) => {
      const value = spec.metadata.get(key);
      return value?.type === 'paths' ? value.op : undefined;
    },
    (path) => path,
  );

export const variantSetsAt = (opinions: readonly Opinion[]): string[] =>
  composedList(
    opinions,
    ({ spec }) => {
      const value = spec.metadata.get('variantSets');
      return value?.type === 'texts' ? value.op : undefined;
    },
    (name) => name,
  ).filter(isVariantName);

/** Variant names of a set, sorted. */
export function variantsAt(opinions: readonly Opinion[], set: string): string[] {
  const names = opinions.flatMap(({ spec }) => [...(spec.variantSets.get(set)?.keys() ?? [])]);
  return [...new Set(names)].filter(isVariantName).sort();
}

/** The strongest selection of a set; '' for none. */
export function selectionAt(opinions: readonly Opinion[], set: string): string | undefined {
  for (const { spec, from } of opinions) {
    const written = spec.metadata.get('variants');
    const selection = written?.type === 'texts-by-name' ? written.data.get(set) : undefined;
    if (selection !== undefined) return expandOrKeep(selection, from.variables);
  }
  return undefined;
}

function composedList<T>(
  opinions: readonly Opinion[],
  opOf: (opinion: Opinion) => ListOp<T> | undefined,
  keyOf: (item: T) => string,
): T[] {
  return opinions.reduceRight<T[]>((list, opinion) => {
    const op = opOf(opinion);
    return op ? applyListOp(list, op, keyOf) : list;
  }, []);
}

export function mapOp<T, U>(op: ListOp<T>, map: (item: T) => U): ListOp<U> {
  const out: ListOp<U> = {};
  if (op.explicit) out.explicit = op.explicit.map(map);
  if (op.prepended) out.prepended = op.prepended.map(map);
  if (op.appended) out.appended = op.appended.map(map);
  if (op.deleted) out.deleted = op.deleted.map(map);
  if (op.added) out.added = op.added.map(map);
  if (op.ordered) out.ordered = op.ordered.map(map);
  return out;
}
