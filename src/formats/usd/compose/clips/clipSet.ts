import { type Message, msg } from '../../../../messages/message.ts';
import { valueAt } from '../../layer/attributes.ts';
import type { AttributeSpec, PrimSpec, Value } from '../../layer/layer.ts';
import { isPrimPath, specAt } from '../../layer/primPaths.ts';
import type { ReportPrimIssue } from '../layers/layerStack.ts';
import { isLayerError, type LayerStore, type LoadedLayer } from '../layers/layerStore.ts';
import { inverseOffset, isNoOffset } from '../layers/timeOffset.ts';
import type { ClipSetDefinition } from './definitions.ts';
import { type ClipTable, type TimeKnot, tableOfTemplate } from './template.ts';
import { clipTime, stageTimes, TimeMap } from './timeMap.ts';

/** A clip and the interval in which it is active. */
interface Clip {
  /** Undefined if missing: it has no values. */
  readonly layer: LoadedLayer | undefined;
  /** Stage times: authored start, effective start (−∞ for the first), and end. */
  readonly start: number;
  readonly from: number;
  readonly to: number;
}

/** A sequence of layers that provide a prim's time samples (OpenUSD value clips). */
export interface ClipSet {
  readonly definition: ClipSetDefinition;
  /** Prim path in the clips. */
  readonly primPath: string;
  readonly clips: readonly Clip[];
  readonly manifest: LoadedLayer | undefined;
  readonly times: TimeMap;
  readonly skipsMissing: boolean;
}

/** Builds a clip set of the prim `path`; undefined and reported if invalid. Layers not loaded yet are requested. */
export function clipSetOf(
  definition: ClipSetDefinition,
  store: LayerStore,
  path: string,
  note: ReportPrimIssue,
): ClipSet | undefined {
  const { entries, from, name, time } = definition;
  const anchor = from.source.id;
  const layerOf = (asset: string, isOptional: boolean): LoadedLayer | undefined => {
    const found = store.find(anchor, asset);
    if (!found || !isLayerError(found)) return found;
    if (!isOptional || found.code !== 'usd.missing-layer')
      note(found.code, path, msg`the clip ${found.message}`, found.missing);
    return undefined;
  };
  const refuse = (why: Message): undefined => {
    note('usd.clips', path, msg`its clip set '${name}' is left out: ${why}`);
    return undefined;
  };
  const table = entries.has('assetPaths')
    ? writtenTable(entries)
    : tableOfTemplate(entries, (asset) => layerOf(asset, true) !== undefined, time);
  if ('template' in table) return refuse(table);
  const fault = clipTableError(table);
  if (fault !== undefined) return refuse(fault);
  const primPath = textOf(entries.get('primPath'));
  if (!isPrimPath(primPath)) return refuse(msg`its primPath '${primPath}' is not the path of a prim`);
  const manifest = textOf(entries.get('manifestAssetPath'));
  const skips = entries.get('interpolateMissingClipValues');
  const hasTimes = table.times.length > 0 || isNoOffset(time);
  return {
    definition,
    primPath,
    clips: clipsOf(table, (asset) => layerOf(asset, false)),
    manifest: manifest === '' ? undefined : layerOf(manifest, false),
    times: new TimeMap(table.times, hasTimes ? undefined : inverseOffset(time)),
    skipsMissing: skips?.type === 'bool' && skips.data,
  };
}

const textOf = (value: Value | undefined): string =>
  value?.type === 'string' || value?.type === 'asset' || value?.type === 'token' ? value.data : '';

function writtenTable(entries: ReadonlyMap<string, Value>): ClipTable | Message {
  const assets = entries.get('assetPaths');
  if (assets?.type !== 'asset[]') return msg`its assetPaths are no list of assets`;
  return { assets: assets.data, active: knotsOf(entries.get('active')), times: knotsOf(entries.get('times')) };
}

function knotsOf(value: Value | undefined): TimeKnot[] {
  if (value?.type !== 'double2[]') return [];
  return Array.from({ length: value.data.length / 2 }, (_, i): TimeKnot => [value.data[2 * i], value.data[2 * i + 1]]);
}

function clipTableError({ assets, active, times }: ClipTable): Message | undefined {
  const starts = new Set<number>();
  for (const [time, clip] of active) {
    if (assets[clip] === undefined) return msg`its active names clip ${clip}, and there are ${assets.length}`;
    if (assets[clip] === '') return msg`its clip ${clip} has no path`;
    if (starts.has(time)) return msg`two clips are active from ${time} on`;
    starts.add(time);
  }
  const counts = new Map<number, number>();
  for (const [time] of times) {
    counts.set(time, (counts.get(time) ?? 0) + 1);
    if (counts.get(time)! > 2) return msg`its times have more than two entries for ${time}`;
  }
  if (![...active, ...times].every((knot) => knot.every(Number.isFinite))) return msg`its times are not all finite`;
  return active.length === 0 ? msg`none of its clips is active` : undefined;
}

function clipsOf({ assets, active }: ClipTable, layerOf: (asset: string) => LoadedLayer | undefined): Clip[] {
  const sorted = [...active].sort(([a], [b]) => a - b);
  return sorted.map(([start, clip], i) => ({
    layer: layerOf(assets[clip]),
    start,
    from: i === 0 ? -Infinity : start,
    to: sorted[i + 1]?.[0] ?? Infinity,
  }));
}

/** The prim at a path of a clip's layer. */
export const primIn = (layer: LoadedLayer | undefined, path: string): PrimSpec | undefined =>
  layer && specAt(layer.root, path);

/** An attribute's samples in one clip, if any. */
export function sampledIn(prim: PrimSpec | undefined, name: string): AttributeSpec | undefined {
  const found = prim?.properties.get(name);
  return found?.kind === 'attribute' && found.timeSamples && found.timeSamples.times.length > 0 ? found : undefined;
}

/** Stage times of a clip's samples: its own (to `most`), knots of the time map, and its start. */
export function timesOf(
  { start, from, to }: Clip,
  sampled: AttributeSpec | undefined,
  map: TimeMap,
  most: number,
): number[] {
  const own = sampled ? stageTimes(map, sampled.timeSamples!.times, [from, to], most) : [];
  return [...own, ...map.bends, start].filter((time) => time >= from && time < to);
}

/** An attribute's value in a clip at a time of the stage. */
export const clipValue = (sampled: AttributeSpec, map: TimeMap, time: number): Value | undefined =>
  valueAt(sampled, clipTime(map, time));
