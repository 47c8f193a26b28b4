import { msg } from '../../../../messages/message.ts';
import type { TimeSamples, Value } from '../../layer/layer.ts';
import type { Cursor } from '../structure/crateSource.ts';
import { ENTRY_BYTES, type FieldValue, type ValueDecoder } from './fieldValue.ts';
import type { ValueRep } from './valueRep.ts';

/** The times, which several attributes may share, behind an offset; then, behind another, the values. */
export function readTimeSamples(reader: ValueDecoder, rep: ValueRep, cursor: Cursor): TimeSamples {
  if (rep.isInlined) return { times: new Float64Array(0), values: [] };
  const { source } = reader;
  const { at } = cursor;
  const times = timesOf(reader, reader.readNested(cursor), at);
  const jump = cursor.at;
  cursor.at = jump + cursor.i64(msg`the place of samples`);
  const count = cursor.count(msg`values of samples`, 8);
  if (count !== times.length) source.fail(msg`there are ${count} samples at ${times.length} times`, at);
  source.spend(ENTRY_BYTES * count, msg`${count} samples`, at);
  const values = Array.from({ length: count }, (): Value => reader.plain(reader.readAt(cursor), cursor.at - 8));
  return { times, values };
}

function timesOf({ source }: ValueDecoder, value: FieldValue, at: number): Float64Array {
  if (value.type !== 'times' && value.type !== 'double[]')
    return source.fail(msg`the times of samples are of kind ${value.type}, not numbers`, at);
  const times = value.data as Float64Array;
  for (let i = 0; i < times.length; i++)
    if (!(Number.isFinite(times[i]) && (i === 0 || times[i] > times[i - 1])))
      source.fail(msg`sample ${i} is at the time ${times[i]}, not after ${i > 0 ? times[i - 1] : msg`all before`}`, at);
  return times;
}
