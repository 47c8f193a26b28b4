import type { Dictionary, TimeSamples, Value } from '../../layer/layer.ts';
import { expandOrKeep } from '../layers/expressions.ts';
import type { StackLayer } from '../layers/layerStack.ts';
import { composeOffsets, isNoOffset, mapTime, type TimeOffset } from '../layers/timeOffset.ts';
import type { PrimIndexNode } from '../primIndex/primIndexNode.ts';

/** Source of an opinion: layer and node, which map its paths and times to the stage. */
export interface OpinionSource {
  readonly from: StackLayer;
  readonly node: PrimIndexNode;
}

/** From the layer's times to those of the stage. */
export const layerToStageTime = ({ from, node }: OpinionSource): TimeOffset =>
  composeOffsets(node.timeToRoot, from.time);

/** A value in stage times, with assets anchored at their layer. */
export function stageValue(value: Value, place: OpinionSource): Value {
  switch (value.type) {
    case 'asset':
      return {
        type: 'asset',
        data: expandOrKeep(value.data, place.from.variables),
        anchor: place.from.source.id,
      };
    case 'asset[]':
      return {
        type: 'asset[]',
        data: value.data.map((asset) => expandOrKeep(asset, place.from.variables)),
        anchor: place.from.source.id,
      };
    case 'timecode':
      return { ...value, data: mapTime(layerToStageTime(place), value.data) };
    case 'timecode[]':
      return { ...value, data: value.data.map((t) => mapTime(layerToStageTime(place), t)) };
    case 'dictionary':
      return { ...value, data: stageDictionary(value.data, place) };
    default:
      return value;
  }
}

const stageDictionary = (data: Dictionary, place: OpinionSource): Dictionary =>
  new Map([...data].map(([key, value]) => [key, stageValue(value, place)]));

export function stageSamples({ times, values }: TimeSamples, place: OpinionSource): TimeSamples {
  const time = layerToStageTime(place);
  const local = /^(asset|timecode)/.test(values[0].type) ? values.map((v) => stageValue(v, place)) : values;
  if (isNoOffset(time)) return { times, values: local };
  const mapped = new Float64Array(times.length);
  for (let i = 0; i < times.length; i++) mapped[i] = mapTime(time, times[i]);
  return time.scale > 0 ? { times: mapped, values: local } : { times: mapped.reverse(), values: [...local].reverse() };
}
