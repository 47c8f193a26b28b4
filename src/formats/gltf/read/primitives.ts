import type { Accessor, Material as GltfMaterial, Mesh as GltfMesh, Primitive } from '@gltf-transform/core';
import { cross, normalize, sub, type Vec3 } from '../../../math/vec3.ts';
import { type LocalizedText, msg } from '../../../messages/message.ts';
import { mergeMeshes } from '../../../scene/mesh/meshOps.ts';
import type { Mesh } from '../../../scene/types.ts';
import { type GltfContext, gltfError } from '../context.ts';
import { isStrand, type StrandFrame } from '../strands/strandPlan.ts';
import { type StrandSurface, strandSurface } from '../strands/strandSurface.ts';
import { floatsOf } from './accessors.ts';
import { type GltfMaterialLibrary, type GltfUvSource, uvSourceOf } from './materials.ts';
import { materialOf } from './variants.ts';

/** A mesh as triangles, with morph targets and skin. All in the mesh's own frame [m]. */
export interface Geometry {
  readonly mesh: Mesh;
  /** Displacements at weight 1, 3 per vertex; 0 where a primitive lacks the target. */
  readonly morphs: readonly MorphTarget[];
  readonly skin?: SkinWeights;
}
export interface MorphTarget {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
}
/** `perPoint` joints and their weights (sum 1) for each vertex. */
export interface SkinWeights {
  readonly perPoint: number;
  readonly joints: Uint16Array;
  readonly weights: Float32Array;
}

interface PrimitiveGeometry extends Geometry {
  readonly mesh: Mesh;
}

/** All primitives of a mesh as one; undefined where there is nothing to see. `strands`: how its points and lines are shown. */
export function readGeometry(
  context: GltfContext,
  mesh: GltfMesh,
  library: GltfMaterialLibrary,
  strands?: StrandFrame,
): Geometry | undefined {
  const place = context.document.getRoot().listMeshes().indexOf(mesh);
  const what = msg`mesh ${mesh.getName() || place}`;
  const parts = mesh.listPrimitives().flatMap((p) => readPrimitive(context, what, p, library, strands) ?? []);
  if (parts.length === 0) return undefined;
  if (parts.length === 1) return parts[0];
  if (new Set(parts.map((p) => p.mesh.doubleSided)).size > 1) {
    const message = msg`has single-sided and double-sided materials; all of it is shown double-sided`;
    context.notes.add('info', 'gltf.mixed-sides', what, message);
  }
  return joinParts(parts);
}

function joinParts(parts: readonly PrimitiveGeometry[]): Geometry {
  const targets = Math.max(...parts.map((p) => p.morphs.length));
  const morphs = Array.from({ length: targets }, (_, k) => ({
    positions: joined(parts.map((p) => p.morphs[k]?.positions ?? new Float32Array(p.mesh.positions.length))),
    normals: joined(parts.map((p) => p.morphs[k]?.normals ?? new Float32Array(p.mesh.positions.length))),
  }));
  const mesh = mergeMeshes(parts.map((p) => p.mesh));
  return parts.some((p) => p.skin) ? { mesh, morphs, skin: joinSkins(parts) } : { mesh, morphs };
}

function joinSkins(parts: readonly PrimitiveGeometry[]): SkinWeights {
  const perPoint = Math.max(...parts.map((p) => p.skin?.perPoint ?? 0));
  const vertices = parts.reduce((sum, p) => sum + p.mesh.positions.length / 3, 0);
  const joints = new Uint16Array(vertices * perPoint);
  const weights = new Float32Array(vertices * perPoint);
  let vertex = 0;
  for (const { mesh, skin } of parts) {
    const count = mesh.positions.length / 3;
    for (let v = 0; skin && v < count; v++) {
      const [from, to] = [v * skin.perPoint, (vertex + v) * perPoint];
      joints.set(skin.joints.subarray(from, from + skin.perPoint), to);
      weights.set(skin.weights.subarray(from, from + skin.perPoint), to);
    }
    vertex += count;
  }
  return { perPoint, joints, weights };
}

function joined(parts: readonly Float32Array[]): Float32Array {
  const out = new Float32Array(parts.reduce((sum, p) => sum + p.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

function readPrimitive(
  context: GltfContext,
  what: LocalizedText,
  p: Primitive,
  library: GltfMaterialLibrary,
  strands: StrandFrame | undefined,
): PrimitiveGeometry | undefined {
  const position = p.getAttribute('POSITION');
  const corners = position && cornersOf(p, position.getCount());
  if (!position || !corners) {
    const message = position ? msg`mode ${p.getMode()} does not exist` : msg`has no positions`;
    context.notes.add('warning', 'gltf.primitive', what, msg`${message}; that part is left out`);
    return undefined;
  }
  const bad = corners.find((corner) => corner >= position.getCount());
  if (bad !== undefined) {
    const shape = isStrand(p) ? msg`a point or line` : msg`a triangle`;
    const message = msg`${shape} wants vertex ${bad} of ${position.getCount()}; the file is damaged, export it again`;
    throw gltfError(context.entry, 'gltf.bad-index', what, message);
  }
  const surface = strands && isStrand(p) ? strandSurface(p.getMode(), corners, floatsOf(position), strands) : undefined;
  if (surface?.indices.length === 0) return undefined;
  // Flat normals are per triangle, so vertices are not shared.
  const isFlat = !surface && !p.getAttribute('NORMAL');
  const take: Take = (name, width, of = p) => {
    const accessor = of.getAttribute(name);
    if (!accessor) return undefined;
    if (accessor.getCount() !== position.getCount()) {
      const message = msg`${name} has ${accessor.getCount()} values for ${position.getCount()} vertices; export it again`;
      throw gltfError(context.entry, 'gltf.bad-attribute', what, message);
    }
    return pick(accessor, width, surface?.source ?? (isFlat ? corners : undefined));
  };
  const material = materialOf(context, p);
  noteVertexAlpha(context, what, p, material);
  const indices = surface?.indices ?? (isFlat ? Uint32Array.from(corners.keys()) : corners);
  const isUnlit = surface !== undefined && !p.getAttribute('NORMAL');
  const made = { material, place: library.placeOf(material, isUnlit), uvs: uvSourceOf(context, material) };
  return buildPart(p, take, indices, made, surface);
}

/** Vertex alpha is not supported. */
function noteVertexAlpha(
  { notes }: GltfContext,
  what: LocalizedText,
  p: Primitive,
  material: GltfMaterial | null,
): void {
  const colors = p.getAttribute('COLOR_0');
  if (colors?.getElementSize() !== 4 || (material?.getAlphaMode() ?? 'OPAQUE') === 'OPAQUE') return;
  if (floatsOf(colors).every((value, i) => i % 4 !== 3 || value >= 1)) return;
  notes.add('warning', 'gltf.vertex-alpha', what, msg`the opacity of its vertex colours is left out`);
}

/** Reads an attribute, `width` values per vertex of the merged mesh. */
type Take = (
  name: string,
  width: number,
  of?: { getAttribute(name: string): Accessor | null },
) => Float32Array | undefined;

/** Material of a primitive. */
interface PrimitiveMaterial {
  readonly material: GltfMaterial | null;
  /** Index among the scene's materials. */
  readonly place: number;
  readonly uvs: GltfUvSource;
}

function buildPart(
  p: Primitive,
  take: Take,
  indices: Uint32Array,
  { material, place, uvs }: PrimitiveMaterial,
  surface: StrandSurface | undefined,
): PrimitiveGeometry {
  const positions = surface?.positions ?? take('POSITION', 3)!;
  const colors = take('COLOR_0', 3);
  const mesh: Mesh = {
    positions,
    normals: surface?.normals ?? unitNormals(take('NORMAL', 3)) ?? flatNormals(positions),
    uvs: toUvs(take(`TEXCOORD_${uvs.set}`, 2), uvs, positions.length / 3),
    ...(colors && { colors }),
    indices,
    groups: [{ start: 0, count: indices.length, material: place }],
    doubleSided: !surface && (material?.getDoubleSided() ?? false),
  };
  const morphs = p.listTargets().map((target) => ({
    positions: take('POSITION', 3, target) ?? new Float32Array(positions.length),
    normals: (!surface && take('NORMAL', 3, target)) || new Float32Array(positions.length),
  }));
  const skin = takeSkin(take, positions.length / 3);
  return skin ? { mesh, morphs, skin } : { mesh, morphs };
}

/** Vertices of triangles, three by three, or of points and lines in order; undefined of an unknown mode. */
function cornersOf(p: Primitive, vertices: number): Uint32Array | undefined {
  const given = p.getIndices()?.getArray();
  const run = given ? Uint32Array.from(given) : Uint32Array.from({ length: vertices }, (_, i) => i);
  const mode = p.getMode();
  if (isStrand(p)) return run;
  if (mode === 4) return run.subarray(0, run.length - (run.length % 3));
  if (mode !== 5 && mode !== 6) return undefined;
  const out = new Uint32Array(Math.max(0, run.length - 2) * 3);
  for (let i = 0; i + 2 < run.length; i++) {
    // Strips alternate winding; fans share their first vertex.
    const odd = i & 1;
    out.set(mode === 5 ? [run[i], run[i + 1 + odd], run[i + 2 - odd]] : [run[i + 1], run[i + 2], run[0]], i * 3);
  }
  return out;
}

/** The first `width` numbers of each element, in the order of `corners` where these are given. */
function pick(accessor: Accessor, width: number, corners?: Uint32Array): Float32Array {
  const values = floatsOf(accessor);
  const stride = accessor.getElementSize();
  if (!corners && stride === width) return values;
  const count = corners?.length ?? accessor.getCount();
  const out = new Float32Array(count * width);
  for (let i = 0; i < count; i++) {
    const from = (corners ? corners[i] : i) * stride;
    for (let k = 0; k < width && k < stride; k++) out[i * width + k] = values[from + k];
  }
  return out;
}

function flatNormals(positions: Float32Array): Float32Array {
  const normals = new Float32Array(positions.length);
  const at = (i: number): Vec3 => [positions[i], positions[i + 1], positions[i + 2]];
  for (let i = 0; i < positions.length; i += 9) {
    const n = normalize(cross(sub(at(i + 3), at(i)), sub(at(i + 6), at(i))), [0, 0, 1]);
    for (let k = 0; k < 9; k += 3) normals.set(n, i + k);
  }
  return normals;
}

/** Quantised normals are not exactly unit. */
function unitNormals(normals: Float32Array | undefined): Float32Array | undefined {
  const out = normals?.slice();
  for (let i = 0; out && i < out.length; i += 3) out.set(normalize([out[i], out[i + 1], out[i + 2]], [0, 0, 1]), i);
  return out;
}

/**
 * KHR_texture_transform: translation · rotation · scale, with the rotation direction of Khronos' sample viewer and
 * three.js (the matrix printed in the extension is the inverse rotation); then v is flipped.
 */
function toUvs(
  given: Float32Array | undefined,
  { offset, rotation, scale }: GltfUvSource,
  vertices: number,
): Float32Array {
  const out = new Float32Array(vertices * 2);
  const [c, s] = [Math.cos(rotation), Math.sin(rotation)];
  for (let i = 0; given && i < out.length; i += 2) {
    const [u, v] = [given[i] * scale[0], given[i + 1] * scale[1]];
    out[i] = offset[0] + c * u + s * v;
    out[i + 1] = 1 - (offset[1] - s * u + c * v);
  }
  return out;
}

function takeSkin(take: Take, vertices: number): SkinWeights | undefined {
  const sets: [Float32Array, Float32Array][] = [];
  for (;;) {
    const [joints, weights] = [take(`JOINTS_${sets.length}`, 4), take(`WEIGHTS_${sets.length}`, 4)];
    if (!joints || !weights) break;
    sets.push([joints, weights]);
  }
  if (sets.length === 0) return undefined;
  const perPoint = sets.length * 4;
  const out = {
    perPoint,
    joints: new Uint16Array(vertices * perPoint),
    weights: new Float32Array(vertices * perPoint),
  };
  for (let v = 0; v < vertices; v++) {
    const all = sets.flatMap(([, weights]) => [...weights.subarray(v * 4, v * 4 + 4)]);
    const sum = all.reduce((a, b) => a + b, 0);
    out.weights.set(sum > 0 ? all.map((w) => w / sum) : all, v * perPoint);
    for (const [i, [joints, weights]] of sets.entries()) {
      // Joints of weight 0 may be invalid; 0 always exists.
      const followed = joints.subarray(v * 4, v * 4 + 4).map((joint, k) => (weights[v * 4 + k] === 0 ? 0 : joint));
      out.joints.set(followed, v * perPoint + i * 4);
    }
  }
  return out;
}
