import { rotate } from '../../math/quat.ts';
import { sub, type Vec3 } from '../../math/vec3.ts';
import { meshBoundingSphere } from '../../scene/bounds/bounds.ts';
import { isLayered, LAYERS } from '../../scene/materials/layered.ts';
import { isTransparent } from '../../scene/materials/transparency.ts';
import { objectNormal, objectPoint } from '../../scene/mesh/stretch.ts';
import { deforms } from '../../scene/motion/motion.ts';
import { motionKind } from '../../scene/motion/motions.ts';
import type { Material, Motion, NormalTexture, Scene, Texture, TextureChannel } from '../../scene/types.ts';
import { textureKey } from '../gpu/textures.ts';
import { type BatchSolid, batchSolidOf } from './batchSolids.ts';
import { type Body, isSolvedPerVertex, sharesMesh } from './bodies.ts';

/** Objects with more triangles than this get batches of their own, so that culling them saves their work. */
const MAX_MERGED_TRIANGLES = 20_000;

/** A mesh is drawn with instancing if at least this many objects share it, and it has at least this many triangles: GPUs are slow with instances of fewer. */
const MIN_INSTANCES = 8;
const MIN_INSTANCED_TRIANGLES = 100;

/** Bodies that share one mesh. */
export interface BatchInstancing {
  /** Index of the first of them in the instance table. */
  readonly first: number;
  /** The material of each body. */
  readonly materials: readonly number[];
}

/** What one draw call draws: parts of objects with the same kind of motion and the same textures. */
export interface Batch {
  readonly kind: Motion['kind'];
  readonly transparent: boolean;
  readonly doubleSided: boolean;
  readonly textures: BatchTextures;
  /** One of its materials, if they have layers: all have the same layers with the same textures. */
  readonly layered?: Material;
  readonly bodies: readonly Body[];
  /** Set if the arrays are one mesh in its own axes, shared by all bodies; otherwise they hold a copy for each. */
  readonly instancing?: BatchInstancing;
  /** By body id: the round solids that are drawn, in the coordinates of `arrays`. */
  readonly solids?: ReadonlyMap<number, BatchSolid>;
  readonly arrays: BatchArrays;
}

/** Whether it is a piece of something whose pieces take turns: it can be released when it is not in the picture. */
export const isPiece = ({ bodies }: Batch): boolean => bodies.every(({ object }) => object.pieceOf !== undefined);

const CHANNEL_SLOTS = ['roughnessTexture', 'metallicTexture', 'occlusionTexture', 'uvTexture', 'irTexture'] as const;
const TEXTURE_SLOTS = ['baseColorTexture', 'emissiveTexture', 'normalTexture', ...CHANNEL_SLOTS] as const;

/** The textures of a batch's materials. */
export type BatchTextures = Pick<Material, (typeof TEXTURE_SLOTS)[number]>;

const texturesOf = (m: Material): BatchTextures =>
  Object.fromEntries(TEXTURE_SLOTS.flatMap((name) => (m[name] ? [[name, m[name]]] : [])));

/** Equal for materials with the same layers of the same textures. */
export const layerKey = (m: Material): string =>
  (m.dispersion ? 'dispersion ' : '') +
  LAYERS.flatMap((name) => {
    const layer = m[name];
    return layer ? [name, ...Object.entries(layer).map(slotKey)] : [];
  }).join(' ');

function slotKey([slot, value]: readonly [string, unknown]): string {
  if (!slot.endsWith('Texture')) return '';
  const from = value as Texture | TextureChannel | NormalTexture;
  if (!('texture' in from)) return `${slot} ${textureKey(from)}`;
  return `${slot} ${textureKey(from.texture)} ${'channel' in from ? from.channel : ''}`;
}

export interface BatchArrays {
  /** Relative to the body's centre [m]; rotated to the world's axes if the motion has one orientation. With instancing as the mesh has them, relative to its centre. */
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** v downwards, as the rows of images. */
  readonly uvs: Float32Array;
  readonly colors?: Float32Array;
  /** Object id − 1 and material, per vertex; unused with instancing. */
  readonly ids: Float32Array;
  readonly indices: Uint32Array;
}

interface BatchPart {
  readonly body: Body;
  readonly material: number;
  readonly start: number;
  readonly count: number;
}

export function makeBatches(scene: Scene, bodies: readonly Body[]): Batch[] {
  const transparent = scene.materials.map(isTransparent);
  const nameOf = (texture: Texture | undefined): string => (texture ? `(${textureKey(texture)})` : '');
  const channel = (from: TextureChannel | undefined): string => `${nameOf(from?.texture)}/${from?.channel}`;
  const textureKeys = scene.materials.map((m) =>
    [
      nameOf(m.baseColorTexture),
      nameOf(m.emissiveTexture),
      nameOf(m.normalTexture?.texture),
      ...CHANNEL_SLOTS.map((name) => channel(m[name])),
      layerKey(m),
    ].join(' '),
  );
  const partsByKey = new Map<string, BatchPart[]>();
  const sharedMeshes = new SharedMeshes(bodies);
  for (const body of bodies) {
    const { mesh, motion } = body.object;
    const deforming = deforms(motion);
    const alone = deforming || mesh.indices.length > 3 * MAX_MERGED_TRIANGLES || sharedMeshes.isOwnPiece(body);
    const sharedKey = sharedMeshes.sharedKey(body);
    for (const { material, start, count } of mesh.groups) {
      const shape = `${motion.kind} ${mesh.doubleSided} ${mesh.colors !== undefined} ${alone || transparent[material] ? body.id : 0}`;
      const materialKey = `${transparent[material]} ${textureKeys[material]} ${deforming ? material : 0}`;
      const isShared = sharedKey !== undefined && !transparent[material];
      const key = isShared
        ? `instanced ${sharedKey} ${start} ${count} ${motion.kind} ${materialKey}`
        : `${shape} ${materialKey}`;
      const parts = partsByKey.get(key) ?? [];
      partsByKey.set(key, parts);
      if (count > 0) parts.push({ body, material, start, count });
    }
  }
  let instances = 0;
  return [...partsByKey].flatMap(([key, parts]) => {
    if (parts.length === 0) return [];
    const batch = makeBatch(
      scene,
      parts,
      transparent[parts[0].material],
      key.startsWith('instanced') ? instances : undefined,
    );
    instances += batch.instancing?.materials.length ?? 0;
    return [batch];
  });
}

/** Finds meshes that many objects share. They are compared by their arrays, because materials may differ. */
class SharedMeshes {
  private readonly arrayIds = new Map<object, number>();
  private readonly users = new Map<string, number>();

  constructor(bodies: readonly Body[]) {
    for (const body of bodies) {
      const key = this.keyOf(body);
      this.users.set(key, (this.users.get(key) ?? 0) + 1);
    }
  }

  /** Whether it is one of several things that take turns with meshes of their own, of which only those in the picture are uploaded. */
  isOwnPiece(body: Body): boolean {
    return body.object.pieceOf !== undefined && this.users.get(this.keyOf(body)) === 1;
  }

  sharedKey(body: Body): string | undefined {
    const { mesh, motion, stretch } = body.object;
    if (!sharesMesh(motion) || (stretch && isSolvedPerVertex(motion))) return undefined;
    if (mesh.indices.length < 3 * MIN_INSTANCED_TRIANGLES) return undefined;
    const key = this.keyOf(body);
    return (this.users.get(key) ?? 0) >= MIN_INSTANCES ? key : undefined;
  }

  private keyOf({ object: { mesh, motion } }: Body): string {
    const { positions, normals, uvs, indices, colors, quadric } = mesh;
    const arrays = [positions, normals, uvs, indices, colors ?? positions, quadric ?? positions];
    return `${motion.kind} ${mesh.doubleSided} ${arrays.map((array) => this.number(array)).join(' ')}`;
  }

  private number(array: object): number {
    const id = this.arrayIds.get(array) ?? this.arrayIds.size;
    this.arrayIds.set(array, id);
    return id;
  }
}

/** `firstInstance`: set if all parts share one mesh with instancing. */
function makeBatch(scene: Scene, parts: readonly BatchPart[], transparent: boolean, firstInstance?: number): Batch {
  const { object } = parts[0].body;
  const material = scene.materials[parts[0].material];
  const solids = solidsOf(parts, firstInstance === undefined);
  return {
    kind: object.motion.kind,
    transparent,
    doubleSided: object.mesh.doubleSided,
    textures: texturesOf(material),
    ...(isLayered(material) && { layered: material }),
    bodies: [...new Set(parts.map((p) => p.body))],
    ...(firstInstance !== undefined && {
      instancing: { first: firstInstance, materials: parts.map((p) => p.material) },
    }),
    ...(solids.size > 0 && { solids }),
    arrays: deforms(object.motion)
      ? wholeMesh(parts)
      : mergeParts(firstInstance === undefined ? parts : parts.slice(0, 1), firstInstance === undefined),
  };
}

function solidsOf(parts: readonly BatchPart[], rotated: boolean): ReadonlyMap<number, BatchSolid> {
  const bodies = new Set(parts.map(({ body }) => body));
  return new Map(
    [...bodies].flatMap(({ id, object, center }) => {
      const orientation = rotated ? motionKind(object.motion).fixedOrientation(object.motion) : undefined;
      const solid = batchSolidOf(object, center, orientation);
      return solid ? [[id, solid]] : [];
    }),
  );
}

/** A deforming mesh keeps its vertices in their order, because samples are found by it; it has a batch per material. */
function wholeMesh(parts: readonly BatchPart[]): BatchArrays {
  const { body } = parts[0];
  const { mesh } = body.object;
  const vertices = mesh.positions.length / 3;
  const ids = new Float32Array(2 * vertices);
  for (let v = 0; v < vertices; v++) ids.set([body.id - 1, parts[0].material], 2 * v);
  const indices = new Uint32Array(parts.reduce((n, p) => n + p.count, 0));
  let at = 0;
  for (const { start, count } of parts) {
    indices.set(mesh.indices.subarray(start, start + count), at);
    at += count;
  }
  const uvs = flipV(mesh.uvs);
  return {
    positions: mesh.positions,
    normals: mesh.normals,
    uvs,
    ids,
    indices,
    ...(mesh.colors && { colors: mesh.colors }),
  };
}

/** `rotated`: stretched, and rotated to the world's axes, if a part has one orientation; otherwise in the mesh's axes. */
function mergeParts(parts: readonly BatchPart[], rotated: boolean): BatchArrays {
  const used = parts.map(usedVertices);
  const vertices = used.reduce((n, u) => n + u.vertices.length, 0);
  const colored = parts[0].body.object.mesh.colors !== undefined;
  const out = {
    positions: new Float32Array(3 * vertices),
    normals: new Float32Array(3 * vertices),
    uvs: new Float32Array(2 * vertices),
    ...(colored && { colors: new Float32Array(3 * vertices) }),
    ids: new Float32Array(2 * vertices),
    indices: new Uint32Array(parts.reduce((n, p) => n + p.count, 0)),
  };
  let vertex = 0;
  let index = 0;
  parts.forEach((part, k) => {
    copyVertices(part, used[k].vertices, out, vertex, rotated);
    for (const i of used[k].indices) out.indices[index++] = vertex + i;
    vertex += used[k].vertices.length;
  });
  return out;
}

function usedVertices({ body, start, count }: BatchPart): { vertices: Uint32Array; indices: Uint32Array } {
  const { mesh } = body.object;
  const newIndex = new Int32Array(mesh.positions.length / 3).fill(-1);
  const vertices = new Uint32Array(newIndex.length);
  const indices = new Uint32Array(count);
  let n = 0;
  for (let i = 0; i < count; i++) {
    const v = mesh.indices[start + i];
    if (newIndex[v] < 0) {
      vertices[n] = v;
      newIndex[v] = n++;
    }
    indices[i] = newIndex[v];
  }
  return { vertices: vertices.subarray(0, n), indices };
}

function copyVertices(
  { body, material }: BatchPart,
  from: Uint32Array,
  out: BatchArrays,
  first: number,
  rotated: boolean,
): void {
  const { mesh, motion } = body.object;
  const own = rotated ? body.object : { mesh };
  const center = rotated ? body.center : meshBoundingSphere(mesh).center;
  const orientation = rotated ? motionKind(motion).fixedOrientation(motion) : undefined;
  const rotateToWorld = (v: Vec3): Vec3 => (orientation ? rotate(orientation, v) : v);
  const read = (a: Float32Array, v: number): Vec3 => [a[3 * v], a[3 * v + 1], a[3 * v + 2]];
  from.forEach((v, k) => {
    const to = first + k;
    out.positions.set(rotateToWorld(sub(objectPoint(own, v), center)), 3 * to);
    out.normals.set(rotateToWorld(objectNormal(own, v)), 3 * to);
    out.uvs[2 * to] = mesh.uvs[2 * v];
    out.uvs[2 * to + 1] = 1 - mesh.uvs[2 * v + 1];
    if (mesh.colors) out.colors?.set(read(mesh.colors, v), 3 * to);
    out.ids[2 * to] = body.id - 1;
    out.ids[2 * to + 1] = material;
  });
}

function flipV(uvs: Float32Array): Float32Array {
  const out = Float32Array.from(uvs);
  for (let i = 1; i < out.length; i += 2) out[i] = 1 - out[i];
  return out;
}
