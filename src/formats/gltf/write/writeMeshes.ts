import type { Accessor, Buffer, Document, Mesh as GltfMesh, Node as GltfNode, Primitive } from '@gltf-transform/core';
import type { Mat3 } from '../../../math/mat3.ts';
import { msg } from '../../../messages/message.ts';
import { bakedMesh, type StretchedMesh } from '../../../scene/mesh/stretch.ts';
import { pointSamples } from '../../../scene/motion/motion.ts';
import type { RestShape } from '../../../scene/streaming/blendedPoints.ts';
import { normalsAt, pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { Mesh, MeshGroup, SampledPointsMotion, Scene, SceneObject } from '../../../scene/types.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import type { ExportMotion } from '../../write/exportMotion.ts';
import type { VertexInfluences } from '../../write/skeletons.ts';
import { GltfMaterialWriter } from './writeMaterials.ts';

/** Most samples of a deforming mesh: each is a morph target, and each has a weight at the time of every other. */
export const MAX_MORPH_TARGETS = 128;

type ExportObject = SceneObject & { readonly motion: ExportMotion };

/** What the vertices of a mesh are, in the axes of its node, and how they bend. */
export interface WrittenShape {
  readonly rest: RestShape;
  /** Displacements at weight 1. */
  readonly targets: readonly RestShape[];
  /** Multiples of 4 for each vertex, the heaviest first: attributes hold four each. */
  readonly influences?: VertexInfluences;
}

/** Writes the meshes of a scene: a primitive for each run of a material, with the vertices that it uses. */
export class MeshWriter {
  private readonly document: Document;
  private readonly buffer: Buffer;
  private readonly losses: DiagnosticLog;
  private readonly materials: GltfMaterialWriter;
  private readonly shared = new Map<Mesh, GltfMesh>();

  constructor(document: Document, buffer: Buffer, scene: Scene, losses: DiagnosticLog) {
    this.document = document;
    this.buffer = buffer;
    this.losses = losses;
    this.materials = new GltfMaterialWriter(document, scene, losses);
  }

  /** Gives back the motion that needs weights of morph targets. */
  addTo(node: GltfNode, object: ExportObject): SampledPointsMotion | undefined {
    const { path, motion } = object;
    const deforming = pointSamples(motion);
    if (!deforming) {
      node.setMesh(this.sharedMesh(node, object));
      return undefined;
    }
    const { mesh } = object;
    const isWritten = deforming.times.length <= MAX_MORPH_TARGETS;
    if (!isWritten) {
      const message = msg`its ${mesh.positions.length / 3} points are sampled at ${deforming.times.length} times, more than the ${MAX_MORPH_TARGETS} that become morph targets; it is written at rest, as it is at its first`;
      this.losses.add('warning', 'convert.points', path, message);
    }
    if (isWritten && deforming.velocities)
      this.losses.add(
        'warning',
        'convert.interpolation',
        path,
        msg`its points go along cubics; there they go straight`,
      );
    const rest = sampleOf(mesh, deforming, 0);
    const later = isWritten ? [...deforming.times.keys()].slice(1) : [];
    const targets = later.map((k) => difference(sampleOf(mesh, deforming, k), rest));
    this.addShape(node, mesh, { rest, targets });
    return isWritten ? deforming : undefined;
  }

  addShape(node: GltfNode, mesh: Mesh, shape: WrittenShape): void {
    node.setMesh(this.mesh(node.getName(), mesh, shape));
  }

  /** Objects with one mesh share it. A node has a scale; other stretches, which glTF has no place for, are baked. */
  private sharedMesh(node: GltfNode, object: StretchedMesh): GltfMesh {
    const { mesh, stretch } = object;
    const scale = stretch && scaleOf(stretch);
    if (scale) node.setScale(scale);
    if (stretch && !scale) return this.mesh(node.getName(), ...rested(bakedMesh(object)));
    const made = this.shared.get(mesh) ?? this.mesh(node.getName(), ...rested(mesh));
    this.shared.set(mesh, made);
    return made;
  }

  private mesh(name: string, mesh: Mesh, shape: WrittenShape): GltfMesh {
    const made = this.document.createMesh(name);
    for (const group of mesh.groups) made.addPrimitive(this.primitive(mesh, group, shape));
    return made;
  }

  private primitive(mesh: Mesh, group: MeshGroup, { rest, targets, influences }: WrittenShape): Primitive {
    const { indices, vertices } = compact(mesh.indices.subarray(group.start, group.start + group.count));
    const vectors = (values: Float32Array): Accessor => this.values('VEC3', taken(values, vertices, 3));
    const primitive = this.document
      .createPrimitive()
      .setAttribute('POSITION', vectors(rest.positions))
      .setAttribute('NORMAL', vectors(rest.normals))
      // v counts down from the top.
      .setAttribute(
        'TEXCOORD_0',
        this.values(
          'VEC2',
          taken(mesh.uvs, vertices, 2).map((x, i) => (i % 2 ? 1 - x : x)),
        ),
      )
      .setIndices(this.values('SCALAR', indices))
      .setMaterial(this.materials.of(group.material, mesh.doubleSided));
    if (mesh.colors) primitive.setAttribute('COLOR_0', vectors(mesh.colors));
    if (influences) this.addInfluences(primitive, influences, vertices);
    for (const { positions, normals } of targets)
      primitive.addTarget(
        this.document
          .createPrimitiveTarget()
          .setAttribute('POSITION', vectors(positions))
          .setAttribute('NORMAL', vectors(normals)),
      );
    return primitive;
  }

  private addInfluences(
    primitive: Primitive,
    { perVertex, joints, weights }: VertexInfluences,
    vertices: Uint32Array,
  ): void {
    const fours = perVertex / 4;
    for (let set = 0; set < fours; set++) {
      const own = vertices.map((v) => fours * v + set);
      primitive
        .setAttribute(`JOINTS_${set}`, this.values('VEC4', taken(joints, own, 4)))
        .setAttribute(`WEIGHTS_${set}`, this.values('VEC4', taken(weights, own, 4)));
    }
  }

  private values(type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4', array: VertexNumbers): Accessor {
    return this.document.createAccessor().setType(type).setArray(array).setBuffer(this.buffer);
  }
}

type VertexNumbers = Float32Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;

const rested = (mesh: Mesh): [Mesh, WrittenShape] => [mesh, { rest: mesh, targets: [] }];

/** The scale that a stretch is; undefined if it shears. */
function scaleOf([x, xy, xz, yx, y, yz, zx, zy, z]: Mat3): [number, number, number] | undefined {
  const most = 1e-9 * Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
  return [xy, xz, yx, yz, zx, zy].every((shear) => Math.abs(shear) <= most) ? [x, y, z] : undefined;
}

/** A deforming mesh at one of its samples. */
const sampleOf = ({ normals }: Mesh, motion: SampledPointsMotion, k: number): RestShape => ({
  positions: pointsAt(motion, k),
  normals: normalsAt(motion, k) ?? normals,
});

const difference = (a: RestShape, b: RestShape): RestShape => ({
  positions: a.positions.map((x, i) => x - b.positions[i]),
  normals: a.normals.map((x, i) => x - b.normals[i]),
});

/** The vertices that triangles use, rising, and the triangles of them. */
function compact(indices: Uint32Array): { indices: Uint32Array<ArrayBuffer>; vertices: Uint32Array } {
  const vertices = Uint32Array.from(new Set(indices)).sort();
  const places = new Map(Array.from(vertices, (v, i) => [v, i]));
  return { indices: Uint32Array.from(indices, (v) => places.get(v)!), vertices };
}

function taken<T extends Float32Array | Uint16Array>(values: T, vertices: Uint32Array, width: number) {
  const size = vertices.length * width;
  const out = values instanceof Float32Array ? new Float32Array(size) : new Uint16Array(size);
  vertices.forEach((v, i) => {
    out.set(values.subarray(width * v, width * v + width), width * i);
  });
  return out;
}
