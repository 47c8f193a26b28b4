import { Document, WebIO } from '@gltf-transform/core';
import { describe, expect, it } from 'vitest';
import { InputError } from '../../scene/types.ts';
import { memorySource } from '../files/fileSource.ts';
import { encodePng } from '../image/encodePng.ts';
import { readGltf } from './index.ts';

/** A scene with a texture, a skin, a morph target and an animation. */
async function sample(): Promise<Uint8Array> {
  const doc = new Document();
  const buffer = doc.createBuffer();
  const floats = (type: 'SCALAR' | 'VEC3' | 'VEC4', array: readonly number[]) =>
    doc.createAccessor().setType(type).setArray(Float32Array.from(array)).setBuffer(buffer);
  const joints = doc.createAccessor().setType('VEC4').setArray(new Uint8Array(12)).setBuffer(buffer);
  const target = doc.createPrimitiveTarget().setAttribute('POSITION', floats('VEC3', [0, 0, 1, 0, 0, 1, 0, 0, 1]));
  const image = doc
    .createTexture('Dot')
    .setImage(encodePng(1, 1, Uint8Array.of(1, 2, 3, 255)))
    .setMimeType('image/png');
  const primitive = doc
    .createPrimitive()
    .setAttribute('POSITION', floats('VEC3', [0, 0, 0, 1, 0, 0, 0, 1, 0]))
    .setAttribute('JOINTS_0', joints)
    .setAttribute('WEIGHTS_0', floats('VEC4', [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]))
    .setIndices(
      doc
        .createAccessor()
        .setArray(Uint16Array.of(0, 1, 2))
        .setBuffer(buffer),
    )
    .setMaterial(doc.createMaterial().setBaseColorTexture(image))
    .addTarget(target);
  const bone = doc.createNode('Bone');
  const node = doc.createNode('Thing').setMesh(doc.createMesh().addPrimitive(primitive));
  node.setSkin(doc.createSkin().addJoint(bone));
  doc.createScene().addChild(node).addChild(bone);
  const sampler = doc.createAnimationSampler().setInput(floats('SCALAR', [0, 1]));
  sampler.setOutput(floats('VEC4', [0, 0, 0, 1, 0, 0, 1, 0]));
  const channel = doc.createAnimationChannel().setTargetNode(bone).setTargetPath('rotation').setSampler(sampler);
  doc.createAnimation('Turn').addSampler(sampler).addChannel(channel);
  return new WebIO().writeBinary(doc);
}

/** The error, or undefined if the file can still be read. */
async function attempt(bytes: Uint8Array): Promise<unknown> {
  try {
    await readGltf(memorySource({ 'a.glb': bytes }), 'a.glb');
    return undefined;
  } catch (error) {
    return error;
  }
}

type Json = Record<string, Record<string, unknown>[]>;
const encode = (json: object): Uint8Array => new TextEncoder().encode(JSON.stringify(json));
const jsonOf = (glb: Uint8Array): Json =>
  JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + new DataView(glb.buffer).getUint32(12, true))));

describe('a damaged glTF', () => {
  it('truncated anywhere is an InputError', async () => {
    const glb = await sample();
    expect(await attempt(glb)).toBeUndefined();
    for (let n = 0; n < glb.length; n += 5) expect(await attempt(glb.subarray(0, n))).toBeInstanceOf(InputError);
    const error = (await attempt(glb.subarray(0, glb.length - 8))) as InputError;
    expect(error.message).toMatch(/^a\.glb: .* the file is cut off; copy or export it again$/);
  });

  it('with an invalid value for any number of its JSON is read, or an InputError', async () => {
    const glb = await sample();
    const text = JSON.stringify(jsonOf(glb));
    const binary = glb.subarray(20 + new DataView(glb.buffer).getUint32(12, true) + 8);
    const places = [...text.matchAll(/(?<=[:,[])-?\d+(\.\d+)?/g)];
    for (const [i, place] of places.entries()) {
      const nonsense = ['-1', '1e9', '99', '0.5', 'null', '"x"', '{}'][i % 7];
      const broken = text.slice(0, place.index) + nonsense + text.slice(place.index + place[0].length);
      const json = JSON.parse(broken) as Json;
      if (json.buffers?.[0]) json.buffers[0].uri = 'a.bin';
      const files = memorySource({ 'a.gltf': encode(json), 'a.bin': binary });
      await readGltf(files, 'a.gltf').catch((error) => expect(error).toBeInstanceOf(InputError));
    }
  });

  it('has an error message', async () => {
    const attemptJson = async (json: object): Promise<string> => {
      const files = memorySource({ 'a.gltf': encode(json) });
      return readGltf(files, 'a.gltf').then(
        () => 'read',
        (error: Error) => error.message,
      );
    };
    const asset = { version: '2.0' };
    expect(await attemptJson({ asset: { version: '1.0' } })).toBe(
      'a.gltf: asset: glTF 1.0; only 2.0 is read, export it as 2.0',
    );
    expect(await attemptJson({ asset, nodes: [{ children: [1] }, { children: [0] }] })).toContain('or in itself');
    expect(await attemptJson({ asset, nodes: [{ mesh: 3 }] })).toContain(
      'node 0: refers to meshes 3, of which there are 0',
    );
    expect(await attemptJson({ asset, buffers: [{ byteLength: 4, uri: 'b.bin' }] })).toContain(
      'there is no file b.bin',
    );
    const huge = [{ componentType: 5126, count: 4e9, type: 'MAT4' }];
    expect(await attemptJson({ asset, accessors: huge })).toContain('accessors: unpack to 238 GiB');
    expect(await attemptJson({ asset, extensionsRequired: ['ACME_shape'] })).toContain(
      'it needs the extension ACME_shape, which is not read; export it without',
    );
    expect(await attemptJson({ asset, nodes: [{}, { mesh: '0' }] })).toBe(
      'a.gltf: nodes[1].mesh: is "0", not a whole number from 0; the file is damaged, export it again',
    );
    expect(await attemptJson({ asset, nodes: [{ rotation: [0, 0, 1] }] })).toContain(
      'nodes[0].rotation: is [0,0,1], not 4 numbers',
    );
    expect(await attemptJson({ asset, meshes: { a: 1 } })).toContain('meshes: is {"a":1}, not an array');
    expect(await attemptJson({ asset, meshes: [{}] })).toContain('meshes[0].primitives: is missing, not an array');
    expect(await attemptJson({ asset, extensions: { KHR_lights_punctual: { lights: [null] } } })).toContain(
      'extensions.KHR_lights_punctual.lights[0]: is null, not an object',
    );
    expect(await attemptJson({ asset, cameras: [{ type: 'perspective' }] })).toContain(
      'cameras[0].perspective: is missing',
    );
    expect(await attemptJson({ asset, images: [{}] })).toContain(
      'images[0]: is {}, not a picture: it needs uri or bufferView',
    );
    const lit = [{ extensions: { KHR_lights_punctual: { light: 2 } } }];
    expect(await attemptJson({ asset, nodes: lit })).toContain('node 0: refers to lights 2, of which there are 0');
    expect(await attemptJson({})).toBe('a.gltf: not a glTF: the JSON has no "asset"');
  });
});
