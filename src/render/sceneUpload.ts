import {
  BufferAttribute,
  BufferGeometry,
  type DataTexture,
  DoubleSide,
  FrontSide,
  Mesh,
  NodeMaterial,
  Scene as ThreeScene,
} from 'three/webgpu';
import type { Vec3 } from '../math/vec3.ts';
import { boundingBox } from '../scene/bounds.ts';
import { restToWorld } from '../scene/resample.ts';
import { subdivideObject } from '../scene/subdivide.ts';
import type { Scene, SceneObject, Texture } from '../scene/types.ts';
import { type Batch, type BatchArrays, makeBatches } from './batches.ts';
import { type Body, makeBody } from './bodies.ts';
import { Environment } from './environment.ts';
import { FloatTable } from './floatTable.ts';
import { Frame } from './frame.ts';
import { PointStore } from './pointStore.ts';
import { MATERIAL_TEXELS, type SurfaceSources } from './surface.ts';
import { uploadTexture } from './textures.ts';
import type { Uniforms } from './uniforms.ts';
import type { VertexSources } from './vertexStage.ts';

/** Edges longer than this share of the scene are cut, until so many triangles have been added. */
const LONGEST_EDGE = 1 / 100;
const ADDED_TRIANGLES = 400_000;

/** One draw call with what its shaders read, and its materials, made when they are first asked for. */
export interface Drawable {
  readonly batch: Batch;
  readonly mesh: Mesh<BufferGeometry, NodeMaterial>;
  readonly vertex: VertexSources;
  readonly surface: SurfaceSources;
  readonly materials: Map<string, NodeMaterial>;
}

let uploads = 0;

/** A scene on the GPU. */
export class SceneUpload {
  /** Tells uploads apart. */
  readonly serial = uploads++;
  readonly scene: Scene;
  /** Speed of light it was made for; only what is authored in the rest frame and sampled depends on it. */
  readonly speedOfLight: number;
  readonly dependsOnSpeedOfLight: boolean;
  readonly bodies: readonly Body[];
  readonly drawables: readonly Drawable[];
  readonly environment: Environment;
  readonly frame: Frame;
  readonly opaque = new ThreeScene();
  readonly transparent = new ThreeScene();
  /** Half the diagonal of the scene [m]. */
  readonly radius: number;
  private readonly objects = new FloatTable(256);
  private readonly samples = new FloatTable(1024);
  private readonly materials = new FloatTable(256);
  private readonly points = new Map<number, PointStore>();
  private readonly textures = new Map<Texture, DataTexture>();

  constructor(scene: Scene, speedOfLight: number, uniforms: Uniforms) {
    this.scene = scene;
    this.speedOfLight = speedOfLight;
    this.dependsOnSpeedOfLight = scene.objects.some(isSampledAtRest);
    const inWorld = scene.objects.map((o) => (isSampledAtRest(o) ? restToWorld(o, speedOfLight) : o));
    const spheres = inWorld.map((object, i) => makeBody(object, i + 1));
    this.radius = sceneRadius(spheres);
    this.bodies = cutLongEdges(inWorld, this.radius).map((object, i) => makeBody(object, i + 1));
    this.environment = new Environment(scene);
    this.frame = new Frame({ objects: this.objects, samples: this.samples, points: this.points });
    for (const { id, object } of this.bodies)
      if (object.motion.kind === 'sampled-points')
        this.points.set(id, new PointStore(object.motion, object.mesh.normals));
    this.fillMaterials();
    this.drawables = makeBatches({ ...scene, objects: this.bodies.map((b) => b.object) }, this.bodies).map((batch) =>
      this.makeDrawable(batch, uniforms),
    );
  }

  dispose(): void {
    for (const { mesh, materials } of this.drawables) {
      mesh.geometry.dispose();
      for (const material of materials.values()) material.dispose();
    }
    for (const store of this.points.values()) store.dispose();
    for (const image of this.textures.values()) image.dispose();
    for (const table of [this.objects, this.samples, this.materials]) table.dispose();
    this.environment.dispose();
  }

  private fillMaterials(): void {
    const { materials } = this.scene;
    this.materials.reserve(materials.length * MATERIAL_TEXELS);
    materials.forEach((m, i) => {
      const texels = [...m.baseColor, m.opacity, ...m.emissive, m.opacityThreshold, m.roughness, m.metallic, 0, 0];
      this.materials.values.set(texels, 4 * MATERIAL_TEXELS * i);
    });
    this.materials.upload();
  }

  private makeDrawable(batch: Batch, uniforms: Uniforms): Drawable {
    const geometry = makeGeometry(batch.arrays);
    const mesh = new Mesh(geometry, new NodeMaterial());
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    (batch.transparent ? this.transparent : this.opaque).add(mesh);
    const points = batch.kind === 'sampled-points' ? this.points.get(batch.bodies[0].id) : undefined;
    const baseColor = this.texture(batch.baseColorTexture);
    const emissive = this.texture(batch.emissiveTexture);
    return {
      batch,
      mesh,
      materials: new Map(),
      vertex: { kind: batch.kind, objects: this.objects, samples: this.samples, uniforms, ...(points && { points }) },
      surface: {
        materials: this.materials,
        uniforms,
        colored: batch.arrays.colors !== undefined,
        ...(baseColor && { baseColor }),
        ...(emissive && { emissive }),
      },
    };
  }

  private texture(image: Texture | undefined): DataTexture | undefined {
    if (!image) return undefined;
    const made = this.textures.get(image) ?? uploadTexture(image);
    this.textures.set(image, made);
    return made;
  }
}

const isSampledAtRest = ({ motion, authoredIn }: SceneObject): boolean =>
  authoredIn === 'rest' && (motion.kind === 'sampled' || motion.kind === 'sampled-points');

export const sideOf = (batch: Batch) => (batch.doubleSided ? DoubleSide : FrontSide);

function makeGeometry(arrays: BatchArrays): BufferGeometry {
  const geometry = new BufferGeometry();
  const set = (name: string, array: Float32Array, size: number) =>
    geometry.setAttribute(name, new BufferAttribute(array, size));
  set('position', arrays.positions, 3);
  set('normal', arrays.normals, 3);
  set('uv', arrays.uvs, 2);
  set('ids', arrays.ids, 2);
  if (arrays.colors) set('color', arrays.colors, 3);
  geometry.setIndex(new BufferAttribute(arrays.indices, 1));
  return geometry;
}

/** Half the diagonal of the box of all objects where they are at time 0, or at their first sample. */
function sceneRadius(bodies: readonly Body[]): number {
  const corners: number[] = [];
  for (const { line, radius } of bodies) {
    const at: Vec3 =
      line.kind === 'polyline' ? [line.positions[0], line.positions[1], line.positions[2]] : startOf(line);
    for (const side of [-radius, radius]) corners.push(at[0] + side, at[1] + side, at[2] + side);
  }
  const box = boundingBox(corners);
  return box ? Math.hypot(box.max[0] - box.min[0], box.max[1] - box.min[1], box.max[2] - box.min[2]) / 2 : 1;
}

const startOf = (line: Body['line']): Vec3 => ('position' in line ? line.position : [0, 0, 0]);

function cutLongEdges(objects: readonly SceneObject[], radius: number): SceneObject[] {
  const maxEdge = Math.max(2 * radius * LONGEST_EDGE, 1e-9);
  const total = objects.reduce((n, o) => n + o.mesh.indices.length / 3, 0);
  return objects.map((object) => {
    const triangles = object.mesh.indices.length / 3;
    const share = triangles / Math.max(1, total);
    const fair = ADDED_TRIANGLES * Math.max(share, 1 / objects.length);
    return subdivideObject(object, maxEdge, Math.ceil(triangles + fair)).result;
  });
}
