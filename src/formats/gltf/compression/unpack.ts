import type { GLTF } from '@gltf-transform/core';
import { type LocalizedText, type Message, msg } from '../../../messages/message.ts';
import { MessageError, messageOf } from '../../../messages/messageError.ts';
import type { DiagnosticCode } from '../../diagnostics/diagnosticCodes.ts';
import { formatBytes } from '../../diagnostics/inputError.ts';
import { gltfError, type Resources } from '../context.ts';
import { checkRange, MAX_UNPACKED } from '../load/checkReferences.ts';
import type { DracoMesh } from './draco.ts';

/**
 * Decompresses geometry: afterwards the JSON is that of an uncompressed file, with the data in buffers of their own,
 * and all checks of plain files apply. Decoders are loaded lazily.
 */

const DRACO = 'KHR_draco_mesh_compression';
/** The second adds a version of one codec and a filter. */
const MESHOPT = ['EXT_meshopt_compression', 'KHR_meshopt_compression'] as const;
export const COMPRESSIONS: readonly string[] = [DRACO, ...MESHOPT];

type BufferView = GLTF.IBufferView;
type Primitive = GLTF.IMeshPrimitive;

export async function unpackGeometry(entry: string, json: GLTF.IGLTF, resources: Resources): Promise<void> {
  const unpacker = new GeometryUnpacker(entry, json, resources);
  const views = (json.bufferViews ?? []).filter((view) => meshoptOf(view));
  if (views.length > 0) await unpacker.unpackViews();
  const primitives = (json.meshes ?? []).flatMap((mesh) => mesh.primitives).filter((p) => dracoOf(p));
  if (primitives.length > 0) await unpacker.unpackPrimitives();
}

/** Whether a buffer is only a placeholder of compressed data, for readers without the extension. */
export const isFallback = (buffer: GLTF.IBuffer): boolean =>
  MESHOPT.some((name) => (buffer.extensions?.[name] as { fallback?: unknown } | undefined)?.fallback === true);

interface MeshoptView {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly byteStride: number;
  readonly count: number;
  readonly mode: string;
  readonly filter?: string;
}
const meshoptOf = (view: BufferView): MeshoptView | undefined =>
  MESHOPT.map((name) => view.extensions?.[name] as MeshoptView | undefined).find((found) => found !== undefined);

interface DracoPrimitive {
  readonly bufferView: number;
  readonly attributes: Readonly<Record<string, number>>;
}
const dracoOf = (p: Primitive): DracoPrimitive | undefined => p.extensions?.[DRACO] as DracoPrimitive | undefined;

interface FilledAccessors {
  /** Those that each primitive needs one of its own of. */
  readonly sharing: ReadonlySet<number>;
  /** What has been filled, by place and data. */
  readonly own: Map<string, number>;
}

const dataKey = ({ bufferView }: DracoPrimitive, part: string): string => `${bufferView} ${part}`;

class GeometryUnpacker {
  private readonly entry: string;
  private readonly json: GLTF.IGLTF;
  private readonly resources: Resources;
  private left = MAX_UNPACKED;
  constructor(entry: string, json: GLTF.IGLTF, resources: Resources) {
    this.entry = entry;
    this.json = json;
    this.resources = resources;
  }

  async unpackViews(): Promise<void> {
    const { decodeMeshopt, checkMeshopt } = await import('./meshopt.ts');
    for (const [i, view] of (this.json.bufferViews ?? []).entries()) {
      const packed = meshoptOf(view);
      if (!packed) continue;
      const what = msg`bufferView ${i}`;
      const data = this.bytes(what, packed);
      const bytes = this.attempt('gltf.meshopt', what, () => {
        checkMeshopt(packed, data.length);
        this.spend(what, packed.count * packed.byteStride);
        return decodeMeshopt(data, packed);
      });
      if (bytes.length < view.byteLength) {
        throw this.refusal('gltf.meshopt', what, msg`unpacks to ${bytes.length} bytes, not to ${view.byteLength}`);
      }
      const { extensions: _, ...plain } = view;
      this.json.bufferViews![i] = { ...plain, buffer: this.addBuffer(bytes), byteOffset: 0 };
    }
    this.emptyUnusedBuffers();
  }

  async unpackPrimitives(): Promise<void> {
    const { loadDraco } = await import('./draco.ts');
    const decode = await loadDraco();
    const meshes = new Map<number, DracoMesh>();
    const filled: FilledAccessors = { sharing: this.sharedAccessors(), own: new Map() };
    for (const [i, mesh] of (this.json.meshes ?? []).entries()) {
      for (const p of mesh.primitives) {
        const packed = dracoOf(p);
        if (!packed) continue;
        const what = msg`mesh ${mesh.name ?? i}`;
        this.attempt('gltf.draco', what, () => {
          const known = meshes.get(packed.bufferView);
          const unpacked = known ?? decode(this.viewBytes(what, packed.bufferView));
          meshes.set(packed.bufferView, unpacked);
          this.fillPrimitive(p, packed, unpacked, filled);
        });
      }
    }
  }

  /** Accessors that several compressed primitives name, each with data of its own, or that plain ones use too. */
  private sharedAccessors(): ReadonlySet<number> {
    const uses = new Map<number, Set<string>>();
    const use = (place: number | undefined, data: string): void => {
      if (place !== undefined) uses.set(place, (uses.get(place) ?? new Set()).add(data));
    };
    for (const p of (this.json.meshes ?? []).flatMap((mesh) => mesh.primitives)) {
      const packed = dracoOf(p);
      use(p.indices, packed ? dataKey(packed, 'indices') : 'plain');
      for (const [name, place] of Object.entries(p.attributes)) {
        const id = packed?.attributes[name];
        use(place, packed && id !== undefined ? dataKey(packed, `${id}`) : 'plain');
      }
    }
    return new Set([...uses].filter(([, data]) => data.size > 1).map(([place]) => place));
  }

  /** Points a primitive's accessors to the decoded values. Where an accessor is shared, each primitive gets one of its own, as long as its data: primitives need not have the same vertices. */
  private fillPrimitive(
    p: Primitive,
    packed: DracoPrimitive,
    mesh: DracoMesh,
    { sharing, own }: FilledAccessors,
  ): void {
    if (p.mode !== undefined && p.mode !== 4)
      throw new MessageError(msg`is compressed as triangles, but drawn in mode ${p.mode}`);
    p.indices ??= this.json.accessors!.push({ type: 'SCALAR', componentType: 5125, count: mesh.indices.length }) - 1;
    const fill = (
      place: number,
      key: string,
      count: number,
      values: (place: number) => ArrayBufferView<ArrayBuffer>,
    ): number => {
      const accessor = this.json.accessors?.[place];
      if (!accessor) throw new MessageError(msg`refers to accessor ${place}`);
      const data = `${place} ${dataKey(packed, key)}`;
      const known = own.get(data);
      if (known !== undefined) return known;
      const isShared = sharing.has(place);
      if (accessor.count !== count && !isShared)
        throw new MessageError(msg`holds ${count} values for accessor ${place}, which has ${accessor.count}`);
      const target = isShared ? this.json.accessors!.push({ ...accessor, count }) - 1 : place;
      own.set(data, target);
      this.replaceValues(target, values(target));
      return target;
    };
    p.indices = fill(p.indices, 'indices', mesh.indices.length, (place) => this.asIndices(place, mesh.indices));
    for (const [name, id] of Object.entries(packed.attributes)) {
      p.attributes[name] = fill(p.attributes[name], `${id}`, mesh.points, (place) => {
        const { type, componentType } = this.json.accessors![place];
        const { components, values } = mesh.attribute(id, componentType);
        if (COMPONENTS.get(type) !== components)
          throw new MessageError(msg`has ${components} numbers in each ${name}, not ${type}`);
        return values;
      });
    }
    delete p.extensions![DRACO];
  }

  private asIndices(place: number, indices: Uint32Array): ArrayBufferView<ArrayBuffer> {
    const accessor = this.json.accessors![place];
    accessor.componentType = 5125;
    return Uint32Array.from(indices);
  }

  private replaceValues(place: number, values: ArrayBufferView<ArrayBuffer>): void {
    const bytes = new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
    this.spend(msg`accessor ${place}`, bytes.length);
    const buffer = this.addBuffer(bytes);
    const view = this.json.bufferViews!.push({ buffer, byteLength: bytes.length }) - 1;
    const { byteOffset: _, sparse: __, ...accessor } = this.json.accessors![place];
    this.json.accessors![place] = { ...accessor, bufferView: view };
  }

  private viewBytes(what: LocalizedText, place: number): Uint8Array {
    const view = this.json.bufferViews?.[place];
    if (!view) throw new MessageError(msg`refers to bufferView ${place}`);
    return this.bytes(what, view);
  }

  private bytes(what: LocalizedText, part: { buffer: number; byteOffset?: number; byteLength: number }): Uint8Array {
    const buffer = this.json.buffers?.[part.buffer];
    if (!buffer) throw this.refusal('gltf.bad-reference', what, msg`refers to buffer ${part.buffer}`);
    const held = this.resources[buffer.uri ?? '@glb.bin'] ?? new Uint8Array(0);
    const from = part.byteOffset ?? 0;
    checkRange(this.entry, what, from, part.byteLength, held.length);
    return held.subarray(from, from + part.byteLength);
  }

  private addBuffer(bytes: Uint8Array<ArrayBuffer>): number {
    const uri = `unpacked:${this.json.buffers!.length}`;
    this.resources[uri] = bytes;
    return this.json.buffers!.push({ uri, byteLength: bytes.length }) - 1;
  }

  /** Placeholder buffers without data are emptied: nothing refers to them any more. */
  private emptyUnusedBuffers(): void {
    const used = new Set(this.json.bufferViews?.map((view) => view.buffer));
    this.json.buffers?.forEach((buffer, i) => {
      if (used.has(i)) return;
      buffer.uri = `unpacked:${i}`;
      buffer.byteLength = 0;
      this.resources[buffer.uri] = new Uint8Array(0);
    });
  }

  private spend(what: LocalizedText, bytes: number): void {
    this.left -= bytes;
    if (this.left >= 0) return;
    const message = msg`with it the file unpacks to more than ${formatBytes(MAX_UNPACKED)}; export it in parts`;
    throw gltfError(this.entry, 'gltf.too-large', what, message);
  }

  /** Runs a decoder; its exceptions become InputErrors. */
  private attempt<T>(code: DiagnosticCode, what: LocalizedText, decode: () => T): T {
    try {
      return decode();
    } catch (thrown) {
      if (thrown instanceof Error && thrown.name === 'InputError') throw thrown;
      throw this.refusal(code, what, messageOf(thrown), thrown);
    }
  }

  private refusal(code: DiagnosticCode, what: LocalizedText, reason: Message, cause?: unknown): Error {
    const message = msg`its compressed data ${reason}; export it again, or without compression`;
    return gltfError(this.entry, code, what, message, cause);
  }
}

const COMPONENTS: ReadonlyMap<string, number> = new Map([
  ['SCALAR', 1],
  ['VEC2', 2],
  ['VEC3', 3],
  ['VEC4', 4],
]);
