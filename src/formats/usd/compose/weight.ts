import type { ListOp, MetadataValue, PrimSpec, PropertySpec } from '../layer.ts';
import { STEPS } from './work.ts';

/** Samples of which one step is to move them in time. */
const SAMPLES_PER_STEP = 2;

/** What it takes to count one opinion on a prim [steps]. */
export function weightOf({ properties, metadata }: PrimSpec): number {
  let steps = metadataWeight(metadata);
  for (const property of properties.values()) steps += propertyWeight(property);
  return steps;
}

function propertyWeight(property: PropertySpec): number {
  const list = property.kind === 'relationship' ? property.targets : property.connections;
  const samples = property.kind === 'attribute' ? (property.timeSamples?.times.length ?? 0) : 0;
  return STEPS.property + STEPS.item * itemsIn(list) + samples / SAMPLES_PER_STEP + metadataWeight(property.metadata);
}

function metadataWeight(metadata: ReadonlyMap<string, MetadataValue>): number {
  let steps = 0;
  for (const value of metadata.values()) {
    if (value.type === 'dictionary') steps += STEPS.item + metadataWeight(value.data);
    else if ('op' in value) steps += STEPS.item * itemsIn(value.op);
    else steps += STEPS.item;
  }
  return steps;
}

function itemsIn(op: ListOp<unknown> | undefined): number {
  if (!op) return 0;
  const { explicit, prepended, appended, deleted, added, ordered } = op;
  return [explicit, prepended, appended, deleted, added, ordered].reduce((sum, list) => sum + (list?.length ?? 0), 0);
}
