import type { Document } from '@gltf-transform/core';
import { expect } from 'vitest';
import type { Scene } from '../../src/scene/types.ts';
import { find, GltfBuilder } from '../support/gltfBuilder.ts';
import type { Files } from './claim.ts';

/** A .glb with a triangle at `/Thing`, extended by `fill`. */
export type Fill = (kit: GltfBuilder, thing: ReturnType<GltfBuilder['meshNode']>) => void;
function filled(fill: Fill): GltfBuilder {
  const kit = new GltfBuilder();
  const thing = kit.meshNode('Thing', kit.triangle());
  kit.scene.addChild(thing);
  fill(kit, thing);
  return kit;
}
export const glb =
  (fill: Fill = () => {}, more: Files = {}) =>
  async (): Promise<Files> => ({ 'a.glb': await filled(fill).glb(), ...more });

/** With a compressed triangle. */
export const packed = (extension: string, pack: (doc: Document) => Promise<Uint8Array>) => async (): Promise<Files> => {
  const { doc } = filled((kit, thing) => {
    for (const p of thing.getMesh()!.listPrimitives()) p.setIndices(kit.ints('SCALAR', [0, 1, 2]));
  });
  const bytes = await pack(doc);
  expect(new TextDecoder('latin1').decode(bytes)).toMatch(new RegExp(`"${extension}":\\{"b`));
  return { 'a.glb': bytes };
};

/** With a material on its triangle. */
export const withMaterial = (
  fill: (material: ReturnType<GltfBuilder['doc']['createMaterial']>, kit: GltfBuilder) => void,
  more: Files = {},
) =>
  glb((kit, thing) => {
    const material = kit.doc.createMaterial('Paint');
    for (const primitive of thing.getMesh()!.listPrimitives()) {
      primitive.setMaterial(material);
      primitive.setAttribute('TEXCOORD_0', kit.values('VEC2', [0, 0, 1, 0, 0, 1]));
      primitive.setAttribute('TEXCOORD_1', kit.values('VEC2', [0, 0, 1, 0, 0, 1]));
    }
    fill(material, kit);
  }, more);

/** A triangle as JSON, overridden by `more`. */
export const json = (more: object): Files => ({
  'a.gltf': JSON.stringify({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'Thing', mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    buffers: [{ byteLength: 36, uri: 'a.bin' }],
    ...more,
  }),
  'a.bin': new Uint8Array(Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0).buffer),
});
export const triangles = (count: number) => (scene: Scene) =>
  expect(find(scene, '/Thing').mesh.indices.length).toBe(3 * count);
export const kinds =
  (...wanted: string[]) =>
  (scene: Scene) =>
    expect(scene.objects.map(({ motion }) => motion.kind)).toEqual(wanted);
