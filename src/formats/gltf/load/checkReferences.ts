import type { GLTF } from '@gltf-transform/core';
import { type LocalizedText, msg } from '../../../messages/message.ts';
import { formatBytes } from '../../diagnostics/inputError.ts';
import { gltfError } from '../context.ts';
import { textureSlots } from './textureSlots.ts';

const COMPONENT_BYTES: Readonly<Record<number, number>> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };
const ELEMENT_SIZE: Readonly<Record<string, number>> = {
  SCALAR: 1,
  VEC2: 2,
  VEC3: 3,
  VEC4: 4,
  MAT2: 4,
  MAT3: 9,
  MAT4: 16,
};
/** Maximum total unpacked size of a file's accessors [bytes]. */
export const MAX_UNPACKED = 2 ** 31;
/** Maximum depth of nodes. */
export const MAX_DEPTH = 1000;

/** Throws for out-of-range references and offsets, before anything is allocated: glTF-Transform does not check them. */
export function checkGltf(entry: string, json: GLTF.IGLTF, resources: Readonly<Record<string, Uint8Array>>): void {
  checkReferences(entry, json);
  checkExtensionIndices(entry, json);
  checkBuffers(entry, json, resources);
  checkAccessors(entry, json);
  checkNodeTree(entry, json);
}

function checkReferences(entry: string, json: GLTF.IGLTF): void {
  const check = (target: keyof GLTF.IGLTF, what: LocalizedText, ...indices: readonly (number | undefined)[]): void => {
    const list = json[target];
    const count = Array.isArray(list) ? list.length : 0;
    for (const i of indices) {
      if (i === undefined || (Number.isInteger(i) && i >= 0 && i < count)) continue;
      throw gltfError(
        entry,
        'gltf.bad-reference',
        what,
        msg`refers to ${target} ${i}, of which there are ${count}; export it again`,
      );
    }
  };
  json.bufferViews?.forEach((v, i) => {
    check('buffers', msg`bufferView ${i}`, v.buffer);
  });
  json.images?.forEach((v, i) => {
    check('bufferViews', msg`image ${i}`, v.bufferView);
  });
  json.textures?.forEach((t, i) => {
    check('images', msg`texture ${i}`, t.source);
    check('samplers', msg`texture ${i}`, t.sampler);
  });
  json.materials?.forEach((m, i) => {
    check('textures', msg`material ${i}`, ...textureSlots(m).map(({ info }) => info.index));
  });
  json.meshes?.forEach((mesh, i) => {
    for (const p of mesh.primitives) {
      check('materials', msg`mesh ${i}`, p.material);
      check(
        'accessors',
        msg`mesh ${i}`,
        p.indices,
        ...[p.attributes, ...(p.targets ?? [])].flatMap((a) => Object.values(a)),
      );
      check('materials', msg`mesh ${i}, a variant`, ...variantMappings(p).map((mapping) => mapping.material));
    }
  });
  json.nodes?.forEach((n, i) => {
    check('nodes', msg`node ${i}`, ...(n.children ?? []));
    check('meshes', msg`node ${i}`, n.mesh);
    check('skins', msg`node ${i}`, n.skin);
    check('cameras', msg`node ${i}`, n.camera);
    check(
      'accessors',
      msg`node ${i}, its instances`,
      ...Object.values(extensionOf<Instances>(n, 'EXT_mesh_gpu_instancing')?.attributes ?? {}),
    );
  });
  json.skins?.forEach((s, i) => {
    check('nodes', msg`skin ${i}`, s.skeleton, ...s.joints);
    check('accessors', msg`skin ${i}`, s.inverseBindMatrices);
  });
  json.animations?.forEach((a, i) => {
    for (const s of a.samplers) check('accessors', msg`animation ${i}`, s.input, s.output);
    for (const c of a.channels) check('nodes', msg`animation ${i}`, c.target.node);
  });
  json.scenes?.forEach((s, i) => {
    check('nodes', msg`scene ${i}`, ...(s.nodes ?? []));
  });
  check('scenes', msg`the default scene`, json.scene);
}

type Extended = { readonly extensions?: Record<string, unknown> };
const extensionOf = <T>(thing: Extended, name: string): T | undefined => thing.extensions?.[name] as T | undefined;

interface Instances {
  readonly attributes: Readonly<Record<string, number>>;
}
interface Mapping {
  readonly material: number;
  readonly variants: readonly number[];
}
const VARIANTS = 'KHR_materials_variants';
const LIGHTS = 'KHR_lights_punctual';
const variantMappings = (p: Extended): readonly Mapping[] =>
  extensionOf<{ mappings: readonly Mapping[] }>(p, VARIANTS)?.mappings ?? [];

function checkExtensionIndices(entry: string, json: GLTF.IGLTF): void {
  const check = (what: LocalizedText, kind: string, count: number, indices: readonly (number | undefined)[]): void => {
    const bad = indices.find((i) => i !== undefined && i >= count);
    if (bad === undefined) return;
    throw gltfError(
      entry,
      'gltf.bad-reference',
      what,
      msg`refers to ${kind} ${bad}, of which there are ${count}; export it again`,
    );
  };
  const variants = extensionOf<{ variants: readonly unknown[] }>(json, VARIANTS)?.variants.length ?? 0;
  const lights = extensionOf<{ lights: readonly unknown[] }>(json, LIGHTS)?.lights.length ?? 0;
  json.meshes?.forEach((mesh, i) => {
    const named = mesh.primitives.flatMap((p) => variantMappings(p)).flatMap((mapping) => mapping.variants);
    check(msg`mesh ${i}`, 'variants', variants, named);
  });
  json.nodes?.forEach((node, i) => {
    check(msg`node ${i}`, 'lights', lights, [extensionOf<{ light: number }>(node, LIGHTS)?.light]);
  });
}

function checkBuffers(entry: string, json: GLTF.IGLTF, resources: Readonly<Record<string, Uint8Array>>): void {
  json.buffers?.forEach((buffer, i) => {
    const held = resources[buffer.uri ?? '@glb.bin']?.length ?? 0;
    if (held >= buffer.byteLength) return;
    const message = msg`holds ${formatBytes(held)} of ${formatBytes(buffer.byteLength)}: the file is cut off; copy or export it again`;
    throw gltfError(entry, 'gltf.truncated', msg`buffer ${i}`, message);
  });
  json.bufferViews?.forEach((view, i) => {
    const size = json.buffers![view.buffer].byteLength;
    checkRange(entry, msg`bufferView ${i}`, view.byteOffset ?? 0, view.byteLength, size);
  });
}

/** Throws where a byte range is outside the data. */
export function checkRange(
  entry: string,
  what: LocalizedText,
  offset: number,
  length: number,
  available: number,
): void {
  const whole = Number.isInteger(offset) && Number.isInteger(length) && offset >= 0 && length >= 0;
  if (whole && offset + length <= available) return;
  const message = msg`wants bytes ${offset} to ${offset + length} of ${available}; the file is damaged, export it again`;
  throw gltfError(entry, 'gltf.out-of-range', what, message);
}

function checkAccessors(entry: string, json: GLTF.IGLTF): void {
  let total = 0;
  const views = json.bufferViews ?? [];
  json.accessors?.forEach((a, i) => {
    const what = msg`accessor ${i}`;
    const bytes = (COMPONENT_BYTES[a.componentType] ?? Number.NaN) * (ELEMENT_SIZE[a.type] ?? Number.NaN);
    const valid = Number.isInteger(a.count) && a.count >= 0 && bytes > 0;
    if (!valid)
      throw gltfError(
        entry,
        'gltf.bad-accessor',
        what,
        msg`${a.count} of ${a.type}, component type ${a.componentType}`,
      );
    total += bytes * a.count;
    if (a.bufferView !== undefined) {
      const view = views[a.bufferView];
      if (!view) throw gltfError(entry, 'gltf.bad-reference', what, msg`refers to bufferView ${a.bufferView}`);
      const length = a.count === 0 ? 0 : (view.byteStride ?? bytes) * (a.count - 1) + bytes;
      checkRange(entry, what, a.byteOffset ?? 0, length, view.byteLength);
    }
    if (a.sparse) checkSparse(entry, what, a, bytes, views);
  });
  if (total > MAX_UNPACKED) {
    throw gltfError(
      entry,
      'gltf.too-large',
      'accessors',
      msg`unpack to ${formatBytes(total)}, more than ${formatBytes(MAX_UNPACKED)}`,
    );
  }
}

function checkSparse(
  entry: string,
  what: LocalizedText,
  accessor: GLTF.IAccessor,
  bytes: number,
  views: readonly GLTF.IBufferView[],
): void {
  const { count, indices, values } = accessor.sparse!;
  const place = msg`${what}, sparse`;
  if (!(Number.isInteger(count) && count >= 0 && count <= accessor.count)) {
    throw gltfError(entry, 'gltf.bad-accessor', place, msg`${count} changed values of ${accessor.count}`);
  }
  const parts = [
    [indices, COMPONENT_BYTES[indices.componentType] ?? Number.NaN],
    [values, bytes],
  ] as const;
  for (const [part, size] of parts) {
    const view = views[part.bufferView];
    if (!view) throw gltfError(entry, 'gltf.bad-reference', place, msg`refers to bufferView ${part.bufferView}`);
    checkRange(entry, place, part.byteOffset ?? 0, count * size, view.byteLength);
  }
}

/** Checks that the nodes are a forest of limited depth. */
function checkNodeTree(entry: string, json: GLTF.IGLTF): void {
  const nodes = json.nodes ?? [];
  const parent = new Int32Array(nodes.length).fill(-1);
  nodes.forEach((node, i) => {
    for (const child of node.children ?? []) {
      if (parent[child] >= 0) {
        throw gltfError(
          entry,
          'gltf.bad-tree',
          msg`node ${child}`,
          msg`has two parents, nodes ${parent[child]} and ${i}; export it again`,
        );
      }
      parent[child] = i;
    }
  });
  for (let i = 0; i < nodes.length; i++) {
    let depth = 0;
    for (let up = parent[i]; up >= 0; up = parent[up]) {
      if (++depth <= MAX_DEPTH) continue;
      const message = msg`is nested more than ${MAX_DEPTH} deep, or in itself; flatten the hierarchy`;
      throw gltfError(entry, 'gltf.bad-tree', msg`node ${i}`, message);
    }
  }
}
