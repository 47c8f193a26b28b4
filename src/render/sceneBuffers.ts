import { BufferAttribute, BufferGeometry, InstancedBufferAttribute, InstancedBufferGeometry } from 'three/webgpu';
import type { Scene } from '../scene/types.ts';
import { SceneTextures } from './gbuffer/sceneTextures.ts';
import { type Batch, makeBatches } from './geometry/batches.ts';
import { type Body, makeBody } from './geometry/bodies.ts';
import { shareGeometry } from './geometry/sharedGeometry.ts';
import { INSTANCE_TEXELS, instanceTexels } from './geometry/vertexInput.ts';
import { isSampledAtRest, sceneRadius, worldObjects } from './geometry/worldObjects.ts';
import type { Gpu } from './gpu/device.ts';
import { FloatTable } from './gpu/floatTable.ts';
import { TriangleTable } from './tessellation/gpu/triangleTable.ts';

/** What does not depend on an observation: a scene's bodies, and its batches with their vertices, instances and textures on the GPU. All uploads of the scene have them in common. */
export class SceneBuffers {
  readonly scene: Scene;
  readonly bodies: readonly Body[];
  /** Half the diagonal of the scene [m]. */
  readonly radius: number;
  readonly batches: readonly Batch[];
  readonly textures: SceneTextures;
  /** Those that are drawn as patches, of batches that are not pieces. */
  readonly triangles: TriangleTable;
  /** The instance table (vertexInput.ts). */
  readonly instances = new FloatTable(256);
  private readonly speedOfLight: number;
  private readonly dependsOnSpeedOfLight: boolean;
  private readonly geometries: ReadonlyMap<Batch, BufferGeometry>;

  /** `speedOfLight` [m/s]: only objects that are authored in the rest frame and sampled depend on it. */
  constructor(scene: Scene, speedOfLight: number, { software, renderer }: Gpu) {
    this.scene = scene;
    this.triangles = new TriangleTable(renderer);
    this.speedOfLight = speedOfLight;
    this.dependsOnSpeedOfLight = scene.objects.some(isSampledAtRest);
    const objects = worldObjects(scene, speedOfLight);
    this.bodies = objects.map((object, i) => makeBody(object, i + 1));
    this.radius = sceneRadius(this.bodies);
    this.batches = makeBatches({ ...scene, objects }, this.bodies);
    this.geometries = new Map(this.batches.map((batch) => [batch, shareGeometry(geometryOf(batch))]));
    this.textures = new SceneTextures(!software);
    this.fillInstances();
  }

  /** Whether they are those of a scene at a speed of light [m/s]. */
  fits(scene: Scene | undefined, speedOfLight: number): boolean {
    return scene === this.scene && (!this.dependsOnSpeedOfLight || speedOfLight === this.speedOfLight);
  }

  /** All of a batch, with all its instances; no one changes it. */
  geometry(batch: Batch): BufferGeometry {
    return this.geometries.get(batch)!;
  }

  dispose(): void {
    for (const geometry of this.geometries.values()) geometry.dispose();
    this.textures.dispose();
    this.triangles.dispose();
    this.instances.dispose();
  }

  private fillInstances(): void {
    for (const { bodies, instancing } of this.batches) {
      if (!instancing) continue;
      this.instances.reserve(INSTANCE_TEXELS * (instancing.first + bodies.length));
      bodies.forEach(({ id, object }, i) => {
        const texels = instanceTexels(id - 1, instancing.materials[i], object.stretch);
        this.instances.values.set(texels, 4 * INSTANCE_TEXELS * (instancing.first + i));
      });
    }
    this.instances.upload();
  }
}

function geometryOf({ arrays, instancing }: Batch): BufferGeometry {
  const geometry = instancing ? instancedGeometry(instancing) : new BufferGeometry();
  const set = (name: string, array: Float32Array, size: number) =>
    geometry.setAttribute(name, new BufferAttribute(array, size));
  set('position', arrays.positions, 3);
  set('normal', arrays.normals, 3);
  set('uv', arrays.uvs, 2);
  if (!instancing) set('ids', arrays.ids, 2);
  if (arrays.colors) set('color', arrays.colors, 3);
  return geometry.setIndex(new BufferAttribute(arrays.indices, 1));
}

function instancedGeometry({ first, materials }: NonNullable<Batch['instancing']>): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.instanceCount = materials.length;
  const numbers = Float32Array.from(materials, (_, i) => first + i);
  return geometry.setAttribute('instance', new InstancedBufferAttribute(numbers, 1));
}

/** The buffers of scenes on one GPU: made for the first upload of a scene, disposed of with the last. */
export class SceneBufferPool {
  private readonly gpu: Gpu;
  private readonly users = new Map<SceneBuffers, number>();

  constructor(gpu: Gpu) {
    this.gpu = gpu;
  }

  /** Those of a scene at a speed of light [m/s]; `release` them once. */
  acquire(scene: Scene, speedOfLight: number): SceneBuffers {
    const existing = [...this.users.keys()].find((buffers) => buffers.fits(scene, speedOfLight));
    const buffers = existing ?? new SceneBuffers(scene, speedOfLight, this.gpu);
    this.users.set(buffers, (this.users.get(buffers) ?? 0) + 1);
    return buffers;
  }

  release(buffers: SceneBuffers): void {
    const others = (this.users.get(buffers) ?? 1) - 1;
    this.users.set(buffers, others);
    if (others > 0) return;
    this.users.delete(buffers);
    buffers.dispose();
  }
}
