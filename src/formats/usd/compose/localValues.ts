import type { Dictionary, TimeSamples, Value } from '../layer.ts';
import { expandedOrWritten } from './expressions.ts';
import type { StackLayer } from './layerStack.ts';
import type { Node } from './node.ts';
import { composeOffsets, isNoOffset, mapTime, type TimeOffset } from './offsets.ts';

/** Where an opinion comes from: the layer, and the site, which knows how paths and times of its stack become the stage's. */
export interface Place {
  readonly from: StackLayer;
  readonly node: Node;
}

/** From the layer's times to those of the stage. */
export const timeOf = ({ from, node }: Place): TimeOffset => composeOffsets(node.timeToRoot, from.time);

/** A value as the stage has it: times are the stage's, and an asset knows the layer that its path is relative to. */
export function localValue(value: Value, place: Place): Value {
  switch (value.type) {
    case 'asset':
      return {
        type: 'asset',
        data: expandedOrWritten(value.data, place.from.variables),
        anchor: place.from.source.id,
      };
    case 'asset[]':
      return {
        type: 'asset[]',
        data: value.data.map((asset) => expandedOrWritten(asset, place.from.variables)),
        anchor: place.from.source.id,
      };
    case 'timecode':
      return { ...value, data: mapTime(timeOf(place), value.data) };
    case 'timecode[]':
      return { ...value, data: value.data.map((t) => mapTime(timeOf(place), t)) };
    case 'dictionary':
      return { ...value, data: localDictionary(value.data, place) };
    default:
      return value;
  }
}

const localDictionary = (data: Dictionary, place: Place): Dictionary =>
  new Map([...data].map(([key, value]) => [key, localValue(value, place)]));

export function localSamples({ times, values }: TimeSamples, place: Place): TimeSamples {
  const time = timeOf(place);
  const local = /^(asset|timecode)/.test(values[0].type) ? values.map((v) => localValue(v, place)) : values;
  if (isNoOffset(time)) return { times, values: local };
  const mapped = new Float64Array(times.length);
  for (let i = 0; i < times.length; i++) mapped[i] = mapTime(time, times[i]);
  return time.scale > 0 ? { times: mapped, values: local } : { times: mapped.reverse(), values: [...local].reverse() };
}
