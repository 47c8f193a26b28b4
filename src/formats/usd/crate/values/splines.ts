import { msg } from '../../../../messages/message.ts';
import type { Dictionary, Extrapolation, Spline, SplineKnot, SplineLoop, Tangent } from '../../layer/layer.ts';
import { Cursor } from '../structure/crateSource.ts';
import { readNumber } from './arrays.ts';
import { ENTRY_BYTES, type ValueDecoder } from './fieldValue.ts';
import type { ValueRep } from './valueRep.ts';

const HELD: Extrapolation = { kind: 'held' };
export const EXTRAPOLATIONS = ['none', 'held', 'linear', 'sloped', 'repeat', 'reset', 'oscillate'] as const;
export const INTERPOLATIONS = ['none', 'held', 'linear', 'curve'] as const;
export const ALGORITHMS = ['none', 'custom', 'autoEase'] as const;
/** Of what type values are, by the number in the first byte; of none, where there is no knot. */
const SCALARS = ['double', 'double', 'float', 'half'] as const;

/** How values, times and flags of one spline are read. */
interface SplineFormat {
  readonly version: number;
  readonly isHermite: boolean;
  value(): number;
}

/** A spline (OpenUSD, ts/binary.cpp, versions 1 to 3): its bytes with their number, then custom data by time. */
export function readSpline(reader: ValueDecoder, rep: ValueRep, cursor: Cursor): Spline {
  const empty: Spline = { curve: 'bezier', before: HELD, after: HELD, knots: [] };
  if (rep.isInlined) return empty;
  const { source } = reader;
  const length = cursor.count(msg`bytes of a spline`, 1);
  const from = cursor.pass(length, msg`a spline`);
  const custom = readCustomData(reader, cursor);
  if (length === 0) return empty;
  const bytes = new Cursor(source, from);
  const spline = readBytes(bytes, custom);
  if (bytes.at !== from + length)
    source.fail(msg`a spline has ${length} bytes, and what it says takes ${bytes.at - from}`, from);
  return spline;
}

type CustomData = Map<number, Dictionary>;

function readCustomData(reader: ValueDecoder, cursor: Cursor): CustomData {
  const count = cursor.count(msg`knots with data`, 16);
  reader.source.spend(ENTRY_BYTES * count, msg`data of knots`, cursor.at);
  return new Map(
    Array.from({ length: count }, () => [cursor.f64(msg`the time of a knot`), reader.dictionary(cursor)] as const),
  );
}

function readBytes(cursor: Cursor, custom: CustomData): Spline {
  const { source, at } = cursor;
  const first = cursor.u8(msg`a spline`);
  const version = first & 15;
  if (version < 1 || version > 3)
    source.fail(msg`a spline is of version ${version}; 1 to 3 are read. Write the layer as text: usdcat`, at);
  const scalar = SCALARS[(first >> 4) & 3];
  const shape: SplineFormat = {
    version,
    isHermite: (first & 128) !== 0,
    value: () => readNumber(cursor, scalar),
  };
  const modes = cursor.u8(msg`a spline`);
  // Of what kind time codes are: plain ones, as far as is known.
  if (version === 3 && cursor.u8(msg`a spline`) !== 0) source.fail(msg`a spline has values of an unknown type`, at);
  const before = readExtrapolation(cursor, modes & 7);
  const after = readExtrapolation(cursor, (modes >> 3) & 7);
  const loop = modes & 64 ? readLoop(cursor) : undefined;
  return {
    curve: shape.isHermite ? 'hermite' : 'bezier',
    before,
    after,
    ...(loop ? { loop } : {}),
    knots: readKnots(cursor, shape, custom),
  };
}

function readExtrapolation(cursor: Cursor, mode: number): Extrapolation {
  const kind = EXTRAPOLATIONS[mode] ?? cursor.source.fail(msg`a spline extrapolates in way ${mode}`, cursor.at - 1);
  return kind === 'sloped' ? { kind, slope: cursor.f64(msg`a slope`) } : { kind };
}

function readLoop(cursor: Cursor): SplineLoop {
  const [start, end] = [cursor.f64(msg`the start of a loop`), cursor.f64(msg`the end of a loop`)];
  const [before, after] = [cursor.i32(msg`the loops before`), cursor.i32(msg`the loops after`)];
  return { start, end, before, after, offset: cursor.f64(msg`the offset of a loop`) };
}

function readKnots(cursor: Cursor, shape: SplineFormat, custom: CustomData): SplineKnot[] {
  const { source, at } = cursor;
  const count = cursor.u32(msg`the number of knots`);
  source.spend(2 * ENTRY_BYTES * Math.min(count, source.size), msg`${count} knots`, at);
  const knots: SplineKnot[] = [];
  for (let i = 0; i < count; i++) {
    const knot = readKnot(cursor, shape, custom);
    if (!(knot.time > (knots.at(-1)?.time ?? -Infinity)))
      source.fail(msg`knot ${i} of a spline is at the time ${knot.time}, not after those before it`, at);
    knots.push(knot);
  }
  return knots;
}

function readKnot(cursor: Cursor, { version, isHermite, value }: SplineFormat, custom: CustomData): SplineKnot {
  const { source, at } = cursor;
  const flags = cursor.u8(msg`a knot`);
  if (flags & 0x30)
    source.fail(msg`a knot has tangents in Maya's form, which is not read; write it as text: usdcat`, at);
  const time = cursor.f64(msg`the time of a knot`);
  const own = value();
  const preValue = flags & 1 ? value() : undefined;
  const widths = isHermite
    ? [0, 0]
    : [cursor.f64(msg`the width of a tangent`), cursor.f64(msg`the width of a tangent`)];
  const slopes = [value(), value()];
  const algorithms = version < 2 ? 0 : cursor.u8(msg`how tangents are made`);
  const tangent = (i: 0 | 1): Tangent => {
    const algorithm = (algorithms >> (4 * i)) & 15;
    return {
      width: widths[i],
      slope: slopes[i],
      algorithm: ALGORITHMS[algorithm] ?? source.fail(msg`tangents are made in way ${algorithm}`, cursor.at - 1),
    };
  };
  const customData = custom.get(time);
  return {
    time,
    value: own,
    ...(preValue === undefined ? {} : { preValue }),
    interpolation: INTERPOLATIONS[(flags >> 1) & 3],
    pre: tangent(0),
    post: tangent(1),
    ...(customData?.size ? { customData } : {}),
  };
}
