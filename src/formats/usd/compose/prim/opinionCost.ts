import type { ListOp, MetadataValue, PrimSpec, PropertySpec } from '../../layer/layer.ts';
import { STEP_COSTS } from '../primIndex/compositionBudget.ts';

/** Samples of which one step is to move them in time. */
const SAMPLES_PER_STEP = 2;

/** What it takes to count one opinion on a prim [steps]. */
export function opinionCost({ properties, metadata }: PrimSpec): number {
  let steps = metadataCost(metadata);
  for (const property of properties.values()) steps += propertyCost(property);
  return steps;
}

function propertyCost(property: PropertySpec): number {
  const list = property.kind === 'relationship' ? property.targets : property.connections;
  const samples = property.kind === 'attribute' ? (property.timeSamples?.times.length ?? 0) : 0;
  return (
    STEP_COSTS.property + STEP_COSTS.item * itemsIn(list) + samples / SAMPLES_PER_STEP + metadataCost(property.metadata)
  );
}

function metadataCost(metadata: ReadonlyMap<string, MetadataValue>): number {
  let steps = 0;
  for (const value of metadata.values()) {
    if (value.type === 'dictionary') steps += STEP_COSTS.item + metadataCost(value.data);
    else if ('op' in value) steps += STEP_COSTS.item * itemsIn(value.op);
    else steps += STEP_COSTS.item;
  }
  return steps;
}

function itemsIn(op: ListOp<unknown> | undefined): number {
  if (!op) return 0;
  const { explicit, prepended, appended, deleted, added, ordered } = op;
  return [explicit, prepended, appended, deleted, added, ordered].reduce((sum, list) => sum + (list?.length ?? 0), 0);
}
