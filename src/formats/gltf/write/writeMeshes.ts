import type { Accessor, Buffer, Document, Node as GltfNode, Primitive } from '@gltf-transform/core';
import { msg } from '../../../messages/message.ts';
import { pointSamples } from '../../../scene/motion/motion.ts';
import type { RestShape } from '../../../scene/streaming/blendedPoints.ts';
import { normalsAt, pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { Mesh, MeshGroup, SampledPointsMotion, Scene, SceneObject } from '../../../scene/types.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import type { ExportMotion } from '../../write/exportMotion.ts';
import { GltfMaterialWriter } from './writeMaterials.ts';

/** Most samples of a deforming mesh: each is a morph target, and each has a weight at the time of every other. */
export const MAX_MORPH_TARGETS = 128;

type ExportObject = SceneObject & { readonly motion: ExportMotion };

/** What the vertices of a mesh are, in the axes of its node, and how they bend. */
export interface WrittenShape {
  readonly rest: RestShape;
  /** Displacements at weight 1. */
  readonly targets: readonly RestShape[];
  readonly influences?: VertexInfluences;
}

/** Joints and weights by vertex, the heaviest first; attributes hold four each. */
export interface VertexInfluences {
  /** A multiple of 4. */
  readonly perVertex: number;
  readonly joints: Uint16Array;
  readonly weights: Float32Array;
}

/** Writes the meshes of a scene: a primitive for each run of a material, with the vertices that it uses. */
export class MeshWriter {
  private readonly document: Document;
  private readonly buffer: Buffer;
  private readonly losses: DiagnosticLog;
  private readonly materials: GltfMaterialWriter;

  constructor(document: Document, buffer: Buffer, scene: Scene, losses: DiagnosticLog) {
    this.document = document;
    this.buffer = buffer;
    this.losses = losses;
    this.materials = new GltfMaterialWriter(document, scene, losses);
  }

  /** Gives back the motion that needs weights of morph targets. */
  addTo(node: GltfNode, { path, mesh, motion }: ExportObject): SampledPointsMotion | undefined {
    const deforming = pointSamples(motion);
    const isWritten = deforming !== undefined && deforming.times.length <= MAX_MORPH_TARGETS;
    if (deforming && !isWritten) {
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
    const rest = deforming ? sampleOf(mesh, deforming, 0) : mesh;
    const later = isWritten ? [...deforming.times.keys()].slice(1) : [];
    const targets = later.map((k) => difference(sampleOf(mesh, deforming!, k), rest));
    this.addShape(node, mesh, { rest, targets });
    return isWritten ? deforming : undefined;
  }

  addShape(node: GltfNode, mesh: Mesh, shape: WrittenShape): void {
    const made = this.document.createMesh(node.getName());
    for (const group of mesh.groups) made.addPrimitive(this.primitive(mesh, group, shape));
    node.setMesh(made);
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
