import type { Attribute, Decoder, DracoModule, Mesh, NumberArray } from 'draco3dgltf/draco_decoder_gltf_nodejs.js';
import { msg } from '../../../messages/message.ts';
import { MessageError } from '../../../messages/messageError.ts';
import { ByteReader } from './meshoptBytes.ts';

/** A decoded Draco mesh. */
export interface DracoMesh {
  /** 3 per triangle. */
  readonly indices: Uint32Array;
  readonly points: number;
  /** All values of an attribute, by its id in the data, converted to a glTF component type. */
  attribute(id: number, componentType: number): { readonly components: number; readonly values: DracoValues };
}

type DracoValues = (Float32Array | Int8Array | Uint8Array | Int16Array | Uint16Array | Uint32Array) &
  ArrayBufferView<ArrayBuffer>;

/** Maximum triangles per byte of data: the most regular mesh, a flat grid, has 4. */
const MAX_TRIANGLES_PER_BYTE = 64;

/** Decoder memory [bytes]: a fixed part, and a part per byte of data. A regular grid takes 700 bytes per byte. */
const MEMORY = 2 ** 27;
const MEMORY_PER_BYTE = 2 ** 10;

/**
 * The official Draco decoder compiled to plain JavaScript (version 1.3.4, the last without WebAssembly, which
 * `script-src 'self'` forbids, and without process hooks): reads bitstream 2.2, which glTF specifies. Loaded lazily;
 * each file has its own instance, so that a damaged file cannot corrupt another's memory.
 */
export async function loadDraco(): Promise<(data: Uint8Array) => DracoMesh> {
  const { default: createModule } = await import('draco3dgltf/draco_decoder_gltf_nodejs.js');
  const quiet = (): void => {};
  // 'SHELL' needs nothing of the environment. The module has a `then` but is not a promise: it must not be awaited.
  const draco = createModule({ ENVIRONMENT: 'SHELL', print: quiet, printErr: quiet });
  let allowed = MEMORY;
  const enlarge = draco.reallocBuffer;
  draco.reallocBuffer = (bytes) => bytes <= allowed && enlarge(bytes);
  return (data) => {
    allowed += MEMORY_PER_BYTE * data.length;
    return guarded(() => decode(draco, data));
  };
}

/** The decoder throws a string when out of memory. */
function guarded<T>(decode: () => T): T {
  try {
    return decode();
  } catch (thrown) {
    if (thrown instanceof Error) throw thrown;
    throw new MessageError(msg`wants more memory than its size accounts for`, { cause: thrown });
  }
}

function decode(draco: DracoModule, data: Uint8Array): DracoMesh {
  checkTriangleCount(data);
  const decoder = new draco.Decoder();
  const buffer = new draco.DecoderBuffer();
  const mesh = new draco.Mesh();
  buffer.Init(data, data.length);
  const status = decoder.DecodeBufferToMesh(buffer, mesh);
  if (!status.ok()) throw new MessageError(msg`cannot be decoded (${status.error_msg() || msg`no reason is given`})`);
  draco.destroy(buffer);
  return {
    indices: readIndices(draco, decoder, mesh),
    points: mesh.num_points(),
    attribute: (id, componentType) => guarded(() => readAttribute(draco, decoder, mesh, id, componentType)),
  };
}

const METADATA_FLAG = 0x8000;
const EDGEBREAKER = 1;

/** Throws for triangle counts that the data cannot hold, before allocation (Draco bitstream 2.2, §4 and §5). */
function checkTriangleCount(data: Uint8Array): void {
  const reader = new ByteReader(data, 0, data.length);
  if (String.fromCharCode(...reader.take(5)) !== 'DRACO') throw new MessageError(msg`does not begin with DRACO`);
  const [major, minor, kind, method] = reader.take(4);
  if (major !== 2 || minor !== 2) throw new MessageError(msg`has bitstream version ${major}.${minor}; glTF takes 2.2`);
  if (kind !== 1) throw new MessageError(msg`holds geometry of kind ${kind}, not a mesh (1)`);
  const [low, high] = reader.take(2);
  if ((low | (high << 8)) & METADATA_FLAG) throw new MessageError(msg`carries metadata of its own, which is not read`);
  if (method === EDGEBREAKER) {
    reader.byte();
    reader.varint();
  }
  const triangles = reader.varint();
  if (triangles > data.length * MAX_TRIANGLES_PER_BYTE) {
    throw new MessageError(msg`claims ${triangles} triangles in ${data.length} bytes`);
  }
}

function readIndices(draco: DracoModule, decoder: Decoder, mesh: Mesh): Uint32Array {
  const out = new Uint32Array(3 * mesh.num_faces());
  const face = new draco.DracoInt32Array();
  for (let i = 0; i < out.length; i += 3) {
    decoder.GetFaceFromMesh(mesh, i / 3, face);
    for (let k = 0; k < 3; k++) out[i + k] = face.GetValue(k);
  }
  draco.destroy(face);
  return out;
}

/** glTF component type → typed array, the decoder's array class, and its fill method. */
const KINDS = new Map([
  [5120, [Int8Array, 'DracoInt8Array', 'GetAttributeInt8ForAllPoints']],
  [5121, [Uint8Array, 'DracoUInt8Array', 'GetAttributeUInt8ForAllPoints']],
  [5122, [Int16Array, 'DracoInt16Array', 'GetAttributeInt16ForAllPoints']],
  [5123, [Uint16Array, 'DracoUInt16Array', 'GetAttributeUInt16ForAllPoints']],
  [5125, [Uint32Array, 'DracoUInt32Array', 'GetAttributeUInt32ForAllPoints']],
  [5126, [Float32Array, 'DracoFloat32Array', 'GetAttributeFloatForAllPoints']],
] as const);

function readAttribute(
  draco: DracoModule,
  decoder: Decoder,
  mesh: Mesh,
  id: number,
  componentType: number,
): { components: number; values: DracoValues } {
  const kind = KINDS.get(componentType as 5126);
  const attribute: Attribute = decoder.GetAttributeByUniqueId(mesh, id);
  if (!kind) throw new MessageError(msg`its accessor has component type ${componentType}`);
  if (attribute.ptr === 0) throw new MessageError(msg`has no attribute ${id}`);
  const [Values, holder, fill] = kind;
  const held: NumberArray = new draco[holder]();
  const components = attribute.num_components();
  if (!decoder[fill](mesh, attribute, held)) throw new MessageError(msg`attribute ${id} cannot be read`);
  const values: DracoValues = new Values(mesh.num_points() * components);
  for (let i = 0; i < values.length; i++) values[i] = held.GetValue(i);
  draco.destroy(held);
  return { components, values };
}
