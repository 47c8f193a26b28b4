import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { decodeAttributes } from './meshoptAttributes.ts';
import { FILTERS } from './meshoptFilters.ts';
import { decodeSequence, decodeTriangles } from './meshoptIndices.ts';

/** A compressed buffer view of EXT_meshopt_compression. */
export interface MeshoptLayout {
  readonly count: number;
  /** Bytes per element. */
  readonly byteStride: number;
  readonly mode: string;
  readonly filter?: string;
}

/** Maximum compression ratio: the attribute codec omits a block of 256 elements at a byte for each 4 of an element. */
const MAX_PACKING = 1024;
/** Maximum indices per byte. */
const MAX_INDICES_PER_BYTE = 3;

/** Throws an Error for a view that the extension forbids, or whose count the data cannot hold. */
export function checkMeshopt({ count, byteStride, mode, filter = 'NONE' }: MeshoptLayout, bytes: number): void {
  const isIndices = mode === 'TRIANGLES' || mode === 'INDICES';
  if (!isIndices && mode !== 'ATTRIBUTES') throw new MessageError(msg`has the unknown mode ${mode}`);
  if (!Number.isInteger(count) || count < 0) throw new MessageError(msg`has count ${count}`);
  if (mode === 'TRIANGLES' && count % 3 !== 0)
    throw new MessageError(msg`has ${count} corners of triangles, not a multiple of 3`);
  const fits = isIndices ? byteStride === 2 || byteStride === 4 : isAttributeStride(byteStride);
  if (!fits) throw new MessageError(msg`has elements of ${byteStride} bytes in mode ${mode}`);
  if (filter !== 'NONE') checkFilter(filter, byteStride, isIndices);
  const most = bytes * (isIndices ? MAX_INDICES_PER_BYTE : MAX_PACKING / byteStride);
  if (count > most) throw new MessageError(msg`claims ${count} elements in ${bytes} bytes`);
}

const isAttributeStride = (stride: number): boolean =>
  Number.isInteger(stride) && stride > 0 && stride <= 256 && stride % 4 === 0;

function checkFilter(name: string, stride: number, isIndices: boolean): void {
  const filter = FILTERS.get(name);
  if (!filter) throw new MessageError(msg`has the unknown filter ${name}`);
  if (isIndices || !filter.strides(stride))
    throw new MessageError(msg`has elements of ${stride} bytes with filter ${name}`);
}

/** Decodes a checked view to count × byteStride bytes. Throws an Error that names the byte where data are damaged. */
export function decodeMeshopt(
  data: Uint8Array,
  { count, byteStride, mode, filter }: MeshoptLayout,
): Uint8Array<ArrayBuffer> {
  if (mode !== 'ATTRIBUTES') {
    const indices = mode === 'TRIANGLES' ? decodeTriangles(data, count) : decodeSequence(data, count);
    return new Uint8Array(byteStride === 2 ? Uint16Array.from(indices).buffer : indices.slice().buffer);
  }
  const bytes = decodeAttributes(data, count, byteStride);
  FILTERS.get(filter ?? 'NONE')?.apply(bytes, byteStride);
  return bytes;
}
