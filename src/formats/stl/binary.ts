import type { Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { formatBytes, inputError } from '../diagnostics/inputError.ts';
import { type Facets, facetNormal, isTurned } from './facets.ts';

/** Where the facet count stands [byte], after text; where the facets begin. */
const COUNT = 80;
const HEADER = 84;
/** Facet size [bytes]: normal, three corners, two bytes of attributes. */
const FACET = 50;

/** Whether the bytes are a binary STL. Some begin with `solid` like text, but match the exact size. */
export function isBinaryStl(bytes: Uint8Array): boolean {
  const start = new TextDecoder().decode(bytes.subarray(0, 512));
  if (!/^\s*solid\b/i.test(start)) return true;
  return bytes.length >= HEADER && bytes.length === HEADER + FACET * countOf(bytes);
}

const viewOf = (bytes: Uint8Array): DataView => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
const countOf = (bytes: Uint8Array): number => viewOf(bytes).getUint32(COUNT, true);

export function readBinaryStl(bytes: Uint8Array, entry: string, notes: DiagnosticLog): Facets {
  if (bytes.length < HEADER) {
    const message = msg`of ${bytes.length} bytes is neither text (it does not begin with solid) nor long enough for a binary STL; copy it again`;
    throw inputError('stl.truncated', entry, message);
  }
  const count = countOf(bytes);
  const size = HEADER + FACET * count;
  if (bytes.length < size) {
    const message = msg`${count} facets take ${formatBytes(size)}, but the file has ${formatBytes(bytes.length)}: it is cut off, or no STL; copy it again`;
    throw inputError('stl.truncated', msg`${entry}: byte ${COUNT}`, message);
  }
  if (bytes.length > size) {
    notes.add(
      'warning',
      'stl.rest',
      msg`byte ${size}`,
      msg`${bytes.length - size} bytes follow the ${count} facets; they are left out`,
    );
  }
  if (new TextDecoder().decode(bytes.subarray(0, COUNT)).includes('COLOR=')) {
    notes.add('info', 'stl.colors', '', msg`its colours are left out`);
  }
  return readFacets(viewOf(bytes), count, entry);
}

function readFacets(view: DataView, count: number, entry: string): Facets {
  const points = new Float32Array(9 * count);
  let turned = 0;
  for (let f = 0; f < count; f++) {
    const at = HEADER + FACET * f;
    for (let k = 0; k < 9; k++) {
      const x = view.getFloat32(at + 12 + 4 * k, true);
      if (!Number.isFinite(x)) {
        const message = msg`facet ${f + 1} of ${count} has a corner at ${x}; the file is damaged, export it again`;
        throw inputError('stl.number', msg`${entry}: byte ${at + 12 + 4 * k}`, message);
      }
      points[9 * f + k] = x;
    }
    const written: Vec3 = [view.getFloat32(at, true), view.getFloat32(at + 4, true), view.getFloat32(at + 8, true)];
    if (isTurned(written, facetNormal(points, f))) turned++;
  }
  return { name: '', points, turned };
}
