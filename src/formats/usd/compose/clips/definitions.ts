import type { Dictionary, MetadataValue, Value } from '../../layer/layer.ts';
import type { LayerStack, StackLayer } from '../layers/layerStack.ts';
import { applyListOp } from '../layers/listOps.ts';
import { mapTime, type TimeOffset } from '../layers/timeOffset.ts';
import { layerToStageTime } from '../prim/stageValues.ts';
import { hasMetadata, type PrimIndexNode, strongestFirst } from '../primIndex/primIndexNode.ts';

/** A clip set composed from all layers, anchored at the strongest site that names its clips. */
export interface ClipSetDefinition {
  readonly name: string;
  readonly entries: ReadonlyMap<string, Value>;
  readonly stack: LayerStack;
  readonly path: string;
  readonly from: StackLayer;
  /** From the times of that layer to the stage's. */
  readonly time: TimeOffset;
}

/** One opinion on a clip set. */
interface ClipEntry {
  readonly value: Value;
  readonly node: PrimIndexNode;
  readonly from: StackLayer;
}

/** A clip set being composed: its anchor is not known at first. */
interface GatheredClipSet {
  readonly entries: Map<string, ClipEntry>;
  source?: { readonly node: PrimIndexNode; readonly from: StackLayer };
}

/** The clip sets of a prim, strongest first: by anchoring site, then by `clipSets`, else by name. */
export function clipSetDefinitions(index: PrimIndexNode): readonly ClipSetDefinition[] {
  if (!hasMetadata(index, 'clips')) return NO_DEFINITIONS;
  const found = new Map<string, GatheredClipSet>();
  const nodes = strongestFirst(index).filter((node) => node.contributes);
  for (const node of nodes)
    for (const { spec, from } of node.opinions) gather(spec.metadata.get('clips'), node, from, found);
  return nodes.flatMap((node) => orderedIn(node, found).map((name) => definitionOf(name, found.get(name)!)));
}

const NO_DEFINITIONS: readonly ClipSetDefinition[] = [];

function gather(
  clips: MetadataValue | undefined,
  node: PrimIndexNode,
  from: StackLayer,
  into: Map<string, GatheredClipSet>,
): void {
  for (const [name, written] of dictionaryOf(clips)) {
    const set: GatheredClipSet = into.get(name) ?? { entries: new Map() };
    into.set(name, set);
    const entries = dictionaryOf(written);
    if (entries.has('assetPaths') || entries.has('templateAssetPath')) set.source ??= { node, from };
    for (const [key, value] of entries) if (!set.entries.has(key)) set.entries.set(key, { value, node, from });
  }
}

/** The sets anchored here. */
function orderedIn(node: PrimIndexNode, found: ReadonlyMap<string, GatheredClipSet>): string[] {
  const names = [...found].flatMap(([name, { source }]) => (source?.node === node ? [name] : [])).sort();
  const ops = node.opinions.flatMap(({ spec }) => {
    const order = spec.metadata.get('clipSets');
    return order?.type === 'texts' ? [order.op] : [];
  });
  const ordered = ops.reduceRight((list, op) => applyListOp(list, op, (name) => name), names);
  return ordered.filter((name) => names.includes(name));
}

/**
 * `active` and `times` are in the times of the anchoring layer, whoever authors them; only stronger layers of the
 * same stack use their own (as OpenUSD 26.11 does).
 */
function definitionOf(name: string, { entries, source }: GatheredClipSet): ClipSetDefinition {
  const { node, from } = source!;
  const { layers } = node.stack;
  const onStage = new Map<string, Value>();
  for (const [key, entry] of entries) {
    const isStronger = entry.node === node && layers.indexOf(entry.from) < layers.indexOf(from);
    const place = { from: isStronger ? entry.from : from, node };
    onStage.set(key, inTime(key, entry.value, layerToStageTime(place)));
  }
  const time = layerToStageTime({ from, node });
  return { name, entries: onStage, stack: node.stack, path: node.path, from, time };
}

const NO_ENTRIES: Dictionary = new Map();

const dictionaryOf = (value: { readonly type: string } | undefined): Dictionary =>
  value?.type === 'dictionary' ? (value as Value & { type: 'dictionary' }).data : NO_ENTRIES;

/** Maps the stage times of `active` and `times`; other entries are unchanged. */
function inTime(key: string, value: Value, time: TimeOffset): Value {
  if ((key !== 'active' && key !== 'times') || value.type !== 'double2[]') return value;
  return { type: 'double2[]', data: Float64Array.from(value.data, (x, i) => (i % 2 === 0 ? mapTime(time, x) : x)) };
}
