import { unzlibSync } from 'fflate';
import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/** Tables for outlines; substitution and positioning (GSUB, GPOS) are not used. */
const TABLES = ['OS/2', 'cmap', 'glyf', 'head', 'hhea', 'hmtx', 'loca', 'maxp', 'name', 'post'];

interface Table {
  readonly tag: string;
  readonly checksum: number;
  readonly data: Uint8Array;
}

/**
 * The TrueType file of a WOFF (W3C, WOFF File Format 1.0, §4–5): its tables unpacked, those for outlines only. opentype.js has an
 * inflater of its own, which fails on some sound files (tiny-inflate, issue 4).
 */
export function unpackWoff(woff: Uint8Array): ArrayBuffer {
  const from = new DataView(woff.buffer, woff.byteOffset, woff.byteLength);
  if (from.getUint32(0) !== 0x774f4646) throw new MessageError(msg`the font is no WOFF file`);
  const tables = Array.from({ length: from.getUint16(12) }, (_, i) => tableAt(from, woff, 44 + 20 * i)).filter(
    ({ tag }) => TABLES.includes(tag),
  );
  const starts = [12 + 16 * tables.length];
  for (const { data } of tables) starts.push(starts[starts.length - 1] + 4 * Math.ceil(data.length / 4));
  const bytes = new Uint8Array(starts[tables.length]);
  const to = new DataView(bytes.buffer);
  to.setUint32(0, from.getUint32(4));
  to.setUint16(4, tables.length);
  tables.forEach(({ tag, checksum, data }, i) => {
    const entry = 12 + 16 * i;
    for (let k = 0; k < 4; k++) bytes[entry + k] = tag.charCodeAt(k);
    to.setUint32(entry + 4, checksum);
    to.setUint32(entry + 8, starts[i]);
    to.setUint32(entry + 12, data.length);
    bytes.set(data, starts[i]);
  });
  return bytes.buffer;
}

function tableAt(from: DataView, woff: Uint8Array, entry: number): Table {
  const [start, packed, length, checksum] = [4, 8, 12, 16].map((at) => from.getUint32(entry + at));
  const data = woff.subarray(start, start + packed);
  return {
    tag: String.fromCharCode(...woff.subarray(entry, entry + 4)),
    checksum,
    data: packed < length ? unzlibSync(data, { out: new Uint8Array(length) }) : data,
  };
}
