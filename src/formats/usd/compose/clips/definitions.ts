import type { Dictionary, MetadataValue, Value } from '../../layer/layer.ts';
import type { LayerStack, StackLayer } from '../layers/layerStack.ts';
import { applyListOp } from '../layers/listOps.ts';
import { mapTime, type TimeOffset } from '../layers/timeOffset.ts';
import { layerToStageTime } from '../prim/stageValues.ts';
import { hasMetadata, type PrimIndexNode, strongestFirst } from '../primIndex/primIndexNode.ts';

/** A clip set as all layers together define it, and the strongest of those that name its layers: there its values count. */
export interface ClipSetDefinition {
  readonly name: string;
  readonly entries: ReadonlyMap<string, Value>;
  readonly stack: LayerStack;
  readonly path: string;
  readonly from: StackLayer;
  /** From the times of that layer to the stage's. */
  readonly time: TimeOffset;
}

/** What a layer says of a clip set, and where. */
interface ClipEntry {
  readonly value: Value;
  readonly node: PrimIndexNode;
  readonly from: StackLayer;
}

/** A clip set while its layers are gone through: where it counts is not known at first. */
interface GatheredClipSet {
  readonly entries: Map<string, ClipEntry>;
  source?: { readonly node: PrimIndexNode; readonly from: StackLayer };
}

/**
 * The clip sets that a prim defines, the strongest first: by the sites that name their layers, and of one site as its
 * `clipSets` orders them, else by their names.
 */
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

/** The sets of which the layers are named here. */
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
 * `active` and `times` are in the times of the layer that names the clips' layers, whatever layer says them; only stronger
 * ones of the same stack have their own. (So it is in OpenUSD 26.11.)
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

/** `active` and `times` are pairs of which the first is a time of the stage; other entries are as they are. */
function inTime(key: string, value: Value, time: TimeOffset): Value {
  if ((key !== 'active' && key !== 'times') || value.type !== 'double2[]') return value;
  return { type: 'double2[]', data: Float64Array.from(value.data, (x, i) => (i % 2 === 0 ? mapTime(time, x) : x)) };
}
