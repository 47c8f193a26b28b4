import { Document, type Node as GltfNode, type Primitive, WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { type FileSource, memorySource } from '../../src/formats/files/fileSource.ts';
import { readGltf } from '../../src/formats/gltf/index.ts';
import type { ReadOptions } from '../../src/formats/readOptions.ts';
import type { Scene, SceneObject } from '../../src/scene/types.ts';

/** A document under construction, with one buffer and shorthands to fill it. */
export class GltfBuilder {
  readonly doc = new Document();
  readonly scene = this.doc.createScene('Stage');
  private readonly buffer = this.doc.createBuffer();
  readonly animation = this.doc.createAnimation('Move');

  values(type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4' | 'MAT4', numbers: readonly number[]) {
    return this.doc.createAccessor().setType(type).setArray(Float32Array.from(numbers)).setBuffer(this.buffer);
  }
  ints(type: 'SCALAR' | 'VEC4', numbers: readonly number[]) {
    return this.doc.createAccessor().setType(type).setArray(Uint16Array.from(numbers)).setBuffer(this.buffer);
  }
  triangle(points: readonly number[] = [0, 0, 0, 1, 0, 0, 0, 1, 0]): Primitive {
    return this.doc.createPrimitive().setAttribute('POSITION', this.values('VEC3', points));
  }
  meshNode(name: string, ...primitives: Primitive[]): GltfNode {
    const mesh = this.doc.createMesh(name);
    for (const p of primitives) mesh.addPrimitive(p);
    return this.doc.createNode(name).setMesh(mesh);
  }
  animate(
    node: GltfNode,
    path: 'translation' | 'rotation' | 'scale' | 'weights',
    times: readonly number[],
    output: readonly number[],
    kind: 'LINEAR' | 'STEP' | 'CUBICSPLINE' = 'LINEAR',
  ): void {
    const type = path === 'weights' ? 'SCALAR' : path === 'rotation' ? 'VEC4' : 'VEC3';
    const sampler = this.doc
      .createAnimationSampler()
      .setInput(this.values('SCALAR', times))
      .setOutput(this.values(type, output))
      .setInterpolation(kind);
    const channel = this.doc.createAnimationChannel().setTargetNode(node).setTargetPath(path).setSampler(sampler);
    this.animation.addSampler(sampler).addChannel(channel);
  }
  glb(): Promise<Uint8Array> {
    return new WebIO().registerExtensions(ALL_EXTENSIONS).writeBinary(this.doc);
  }
  async files(): Promise<FileSource> {
    return memorySource({ 'a.glb': await this.glb() });
  }
  async read(options?: ReadOptions): Promise<Scene> {
    return readGltf(await this.files(), 'a.glb', options);
  }
}

/** The object at a path; otherwise throws an error that lists the existing paths. */
export const find = (scene: Scene, path: string): SceneObject => {
  const object = scene.objects.find((o) => o.path === path);
  if (!object) throw new Error(`no ${path} among ${scene.objects.map((o) => o.path).join(', ')}`);
  return object;
};
