import type { Accessor, Buffer, Document, Node as GltfNode, Primitive } from '@gltf-transform/core';
import { msg } from '../../../messages/message.ts';
import { pointSamples } from '../../../scene/motion/motion.ts';
import { normalsAt, pointsAt } from '../../../scene/streaming/samplePoints.ts';
import type { Mesh, MeshGroup, SampledPointsMotion, Scene, SceneObject } from '../../../scene/types.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import type { ExportMotion } from '../../write/exportMotion.ts';
import { GltfMaterialWriter } from './writeMaterials.ts';

/** Most samples of a deforming mesh: each is a morph target, and each has a weight at the time of every other. */
export const MAX_MORPH_TARGETS = 128;

type ExportObject = SceneObject & { readonly motion: ExportMotion };

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
    const made = this.document.createMesh(node.getName());
    for (const group of mesh.groups) made.addPrimitive(this.primitive(mesh, group, deforming, isWritten));
    node.setMesh(made);
    return isWritten ? deforming : undefined;
  }

  private primitive(mesh: Mesh, group: MeshGroup, motion: SampledPointsMotion | undefined, moves: boolean): Primitive {
    const { indices, vertices } = compact(mesh.indices.subarray(group.start, group.start + group.count));
    const own = (values: Float32Array): Float32Array => taken(values, vertices, 3);
    const times = motion && (moves ? motion.times : motion.times.subarray(0, 1));
    const points = times ? Array.from(times, (_, k) => own(pointsAt(motion, k))) : [own(mesh.positions)];
    const shaded = motion !== undefined && normalsAt(motion, 0) !== undefined;
    const normals = shaded ? points.map((_, k) => own(normalsAt(motion, k)!)) : [own(mesh.normals)];
    const primitive = this.document
      .createPrimitive()
      .setAttribute('POSITION', this.values('VEC3', points[0]))
      .setAttribute('NORMAL', this.values('VEC3', normals[0]))
      // v counts down from the top.
      .setAttribute(
        'TEXCOORD_0',
        this.values(
          'VEC2',
          taken(mesh.uvs, vertices, 2).map((x, i) => (i % 2 ? 1 - x : x)),
        ),
      )
      .setIndices(this.document.createAccessor().setType('SCALAR').setArray(indices).setBuffer(this.buffer))
      .setMaterial(this.materials.of(group.material, mesh.doubleSided));
    if (mesh.colors) primitive.setAttribute('COLOR_0', this.values('VEC3', taken(mesh.colors, vertices, 3)));
    for (let k = 1; moves && k < points.length; k++) {
      const target = this.document.createPrimitiveTarget();
      target.setAttribute('POSITION', this.values('VEC3', difference(points[k], points[0])));
      if (normals[k]) target.setAttribute('NORMAL', this.values('VEC3', difference(normals[k], normals[0])));
      primitive.addTarget(target);
    }
    return primitive;
  }

  private values(type: 'VEC2' | 'VEC3', array: Float32Array): Accessor {
    return this.document.createAccessor().setType(type).setArray(Float32Array.from(array)).setBuffer(this.buffer);
  }
}

const difference = (a: Float32Array, b: Float32Array): Float32Array => a.map((x, i) => x - b[i]);

/** The vertices that triangles use, rising, and the triangles of them. */
function compact(indices: Uint32Array): { indices: Uint32Array<ArrayBuffer>; vertices: Uint32Array } {
  const vertices = Uint32Array.from(new Set(indices)).sort();
  const places = new Map(Array.from(vertices, (v, i) => [v, i]));
  return { indices: Uint32Array.from(indices, (v) => places.get(v)!), vertices };
}

function taken(values: Float32Array, vertices: Uint32Array, width: number): Float32Array {
  const out = new Float32Array(vertices.length * width);
  vertices.forEach((v, i) => {
    out.set(values.subarray(width * v, width * v + width), width * i);
  });
  return out;
}
