import { toHalf } from '../../../../math/half.ts';
import { msg } from '../../../../messages/message.ts';
import type { Extrapolation, Spline, SplineKnot } from '../../layer/layer.ts';
import { NON_ARRAY_TYPES } from '../values/crateTypes.ts';
import { ALGORITHMS, EXTRAPOLATIONS, INTERPOLATIONS } from '../values/splines.ts';
import { ByteSink } from './byteSink.ts';
import { stored } from './rep.ts';
import type { ValuePacker } from './valuePacker.ts';

/** How values of a type are written: the bits that say so in the first byte, and the number itself. */
const VALUE_TYPES: ReadonlyMap<string, readonly [bits: number, write: (sink: ByteSink, value: number) => void]> =
  new Map([
    ['timecode', [0x40, (sink: ByteSink, value: number) => sink.f64(value)]],
    ['double', [0x10, (sink: ByteSink, value: number) => sink.f64(value)]],
    ['float', [0x20, (sink: ByteSink, value: number) => sink.f32(value)]],
    ['half', [0x30, (sink: ByteSink, value: number) => sink.u16(toHalf(value))]],
  ]);

/** Versions of splines, and the versions of crates that they need: tangents with algorithms, and time codes, came later. */
const CRATE_VERSIONS = { 1: 12, 2: 13, 3: 15 } as const;

/** A spline of an attribute (OpenUSD, ts/binary.cpp): its bytes with their number, then custom data by time. */
export function packSpline(packer: ValuePacker, spline: Spline, typeName: string): bigint {
  const [bits, write] =
    VALUE_TYPES.get(typeName) ??
    packer.fail(msg`a spline of type ${typeName} is not one of double, float, half or timecode`);
  const hasAlgorithms = spline.knots.some(({ pre, post }) => pre.algorithm !== 'none' || post.algorithm !== 'none');
  const version = typeName === 'timecode' ? 3 : hasAlgorithms ? 2 : 1;
  packer.need(CRATE_VERSIONS[version]);
  const bytes = new ByteSink();
  bytes.u8(version | bits | (spline.curve === 'hermite' ? 0x80 : 0));
  writeHead(bytes, spline, version);
  bytes.u32(spline.knots.length);
  for (const knot of spline.knots) writeKnot(bytes, knot, { spline, version, write });
  const sink = new ByteSink();
  sink.u64(bytes.length);
  sink.append(bytes.bytes);
  writeCustomData(packer, sink, spline.knots);
  return stored(NON_ARRAY_TYPES.spline, packer.place(sink.bytes));
}

function writeHead(sink: ByteSink, { before, after, loop }: Spline, version: number): void {
  const mode = ({ kind }: Extrapolation): number => EXTRAPOLATIONS.indexOf(kind);
  sink.u8(mode(before) | (mode(after) << 3) | (loop ? 0x40 : 0));
  if (version === 3) sink.u8(0);
  for (const side of [before, after]) if (side.kind === 'sloped') sink.f64(side.slope);
  if (!loop) return;
  sink.f64(loop.start);
  sink.f64(loop.end);
  sink.u32(loop.before);
  sink.u32(loop.after);
  sink.f64(loop.offset);
}

interface KnotFormat {
  readonly spline: Spline;
  readonly version: number;
  readonly write: (sink: ByteSink, value: number) => void;
}

function writeKnot(sink: ByteSink, knot: SplineKnot, { spline, version, write }: KnotFormat): void {
  const { time, value, preValue, pre, post } = knot;
  sink.u8((preValue === undefined ? 0 : 1) | (INTERPOLATIONS.indexOf(knot.interpolation) << 1));
  sink.f64(time);
  write(sink, value);
  if (preValue !== undefined) write(sink, preValue);
  if (spline.curve !== 'hermite') for (const { width } of [pre, post]) sink.f64(width);
  for (const { slope } of [pre, post]) write(sink, slope);
  if (version > 1) sink.u8(ALGORITHMS.indexOf(pre.algorithm) | (ALGORITHMS.indexOf(post.algorithm) << 4));
}

function writeCustomData(packer: ValuePacker, sink: ByteSink, knots: readonly SplineKnot[]): void {
  const withData = knots.filter(({ customData }) => customData);
  sink.u64(withData.length);
  for (const { time, customData } of withData) {
    sink.f64(time);
    packer.writeDictionary(sink, customData!);
  }
}
