import {
  KHRLightsPunctual,
  KHRMaterialsEmissiveStrength,
  KHRMaterialsIOR,
  KHRMaterialsUnlit,
  KHRTextureTransform,
} from '@gltf-transform/extensions';
import { describe, expect, it } from 'vitest';
import { find, GltfBuilder } from '../../../../tests/support/gltfBuilder.ts';
import { fromAxisAngle } from '../../../math/quat.ts';
import { distance, type Vec3 } from '../../../math/vec3.ts';
import { inEnglish } from '../../../messages/message.ts';
import { positionAt } from '../../../physics/worldLines/worldLine.ts';
import { originWorldLine, vertexPosition } from '../../../scene/motion/motion.ts';
import { memorySource } from '../../files/fileSource.ts';
import { encodePng } from '../../image/encodePng.ts';
import { readGltf } from '../index.ts';

/** Far above every speed here [m/s]. */
const C = 1e9;

describe('glTF meshes', () => {
  it('strips and fans become triangles, lines tubes', async () => {
    const kit = new GltfBuilder();
    const square = [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0];
    const normals = kit.values('VEC3', [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
    const strip = kit.triangle(square).setMode(5).setAttribute('NORMAL', normals);
    const fan = kit.triangle([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]).setMode(6).setAttribute('NORMAL', normals);
    kit.scene.addChild(kit.meshNode('Strip', strip)).addChild(kit.meshNode('Fan', fan));
    kit.scene.addChild(kit.meshNode('Wire', kit.triangle().setMode(1)));
    const scene = await kit.read();
    expect([...find(scene, '/Strip').mesh.indices]).toEqual([0, 1, 2, 1, 3, 2]);
    expect([...find(scene, '/Fan').mesh.indices]).toEqual([1, 2, 0, 2, 3, 0]);
    expect(scene.objects.length).toBe(3);
    expect(scene.diagnostics.map((d) => [d.code, inEnglish(d.place)])).toEqual([['gltf.primitive', 'a.glb']]);
  });

  it('without normals triangles are flat, and share no vertex', async () => {
    const kit = new GltfBuilder();
    const fold = kit.triangle([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]).setIndices(kit.ints('SCALAR', [0, 1, 2, 0, 3, 1]));
    kit.scene.addChild(kit.meshNode('Fold', fold));
    const { mesh } = find(await kit.read(), '/Fold');
    expect([...mesh.indices]).toEqual([0, 1, 2, 3, 4, 5]);
    expect([...mesh.normals]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0]);
    expect([...mesh.uvs]).toEqual(new Array(12).fill(0));
  });

  it('joins primitives, keeps their materials, reads colours, flips v and applies texture transforms', async () => {
    const kit = new GltfBuilder();
    const png = encodePng(1, 2, Uint8Array.from([255, 0, 0, 9, 0, 0, 255, 9]));
    const image = kit.doc.createTexture('Paint').setImage(png).setMimeType('image/png');
    const red = kit.doc.createMaterial('Red').setBaseColorTexture(image).setBaseColorFactor([1, 0.5, 0.25, 0.5]);
    const transform = kit.doc.createExtension(KHRTextureTransform).createTransform();
    transform
      .setOffset([0.5, 0])
      .setScale([1, 2])
      .setRotation(Math.PI / 2);
    red.getBaseColorTextureInfo()?.setExtension('KHR_texture_transform', transform).setMagFilter(9728).setWrapS(33071);
    const strong = kit.doc
      .createExtension(KHRMaterialsEmissiveStrength)
      .createEmissiveStrength()
      .setEmissiveStrength(4);
    const glow = kit.doc.createMaterial('Glow').setEmissiveFactor([1, 0, 0.5]).setAlphaMode('MASK').setAlphaCutoff(0.3);
    glow.setExtension('KHR_materials_emissive_strength', strong).setDoubleSided(true);
    glow.setExtension('KHR_materials_ior', kit.doc.createExtension(KHRMaterialsIOR).createIOR().setIOR(2.4));
    const uvs = kit.values('VEC2', [0, 0, 1, 0, 0, 0.5]);
    const bytes = kit.doc
      .createAccessor()
      .setType('VEC4')
      .setArray(Uint8Array.from([255, 0, 0, 9, 0, 255, 0, 9, 0, 0, 255, 9]));
    const a = kit.triangle().setMaterial(red).setAttribute('TEXCOORD_0', uvs);
    const b = kit.triangle().setMaterial(glow).setAttribute('COLOR_0', bytes.setNormalized(true));
    kit.scene.addChild(kit.meshNode('Both', a, b));
    const scene = await kit.read();
    const { mesh } = find(scene, '/Both');
    expect(mesh.groups).toEqual([
      { start: 0, count: 3, material: 0 },
      { start: 3, count: 3, material: 1 },
    ]);
    expect([...mesh.colors!]).toEqual([...new Array(9).fill(1), 1, 0, 0, 0, 1, 0, 0, 0, 1]);
    // A quarter turn: (u, v) → (v, −u) after the scale, then the offset, then v up.
    const expected = [0.5, 1, 0.5, 2, 1.5, 1];
    expected.forEach((x, i) => {
      expect(mesh.uvs[i]).toBeCloseTo(x, 6);
    });
    const [first, second] = scene.materials;
    expect(first).toMatchObject({ name: 'Red', baseColor: [1, 0.5, 0.25], opacity: 1, opacityThreshold: 0 });
    expect(first.baseColorTexture).toMatchObject({
      width: 1,
      height: 2,
      filter: 'nearest',
      wrapS: 'clamp',
      wrapT: 'repeat',
    });
    expect([...first.baseColorTexture!.data]).toEqual([255, 0, 0, 255, 0, 0, 255, 255]);
    expect([first.ior, second.ior]).toEqual([undefined, 2.4]);
    expect(second).toMatchObject({ emissive: [4, 0, 2], opacityThreshold: 0.3 });
    expect(mesh.doubleSided).toBe(true);
    expect(scene.diagnostics.map((d) => d.code)).toEqual(['gltf.vertex-alpha', 'gltf.mixed-sides']);
  });

  it('an unlit material emits its colour', async () => {
    const kit = new GltfBuilder();
    const unlit = kit.doc.createExtension(KHRMaterialsUnlit).createUnlit();
    const sign = kit.doc
      .createMaterial('Sign')
      .setBaseColorFactor([0.2, 0.4, 0.6, 1])
      .setExtension('KHR_materials_unlit', unlit);
    kit.scene.addChild(kit.meshNode('Sign', kit.triangle().setMaterial(sign)));
    const [material] = (await kit.read()).materials;
    expect(material).toMatchObject({ baseColor: [0, 0, 0], emissive: [0.2, 0.4, 0.6], metallic: 0 });
  });

  it('gives every object a unique path that is valid in USD', async () => {
    const kit = new GltfBuilder();
    const parent = kit.meshNode('Körper 1.2', kit.triangle());
    parent.addChild(kit.meshNode('Mesh', kit.triangle())).addChild(kit.meshNode('Mesh', kit.triangle()));
    kit.scene.addChild(parent).addChild(kit.meshNode('3D', kit.triangle())).addChild(kit.meshNode('', kit.triangle()));
    const paths = (await kit.read()).objects.map((o) => o.path);
    expect(paths).toEqual(['/Körper_1_2/Mesh_2', '/Körper_1_2/Mesh', '/Körper_1_2/Mesh_1', '/_3D', '/Node4']);
  });

  it('a sheared matrix is kept', async () => {
    const json = {
      asset: { version: '2.0' },
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0, matrix: [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1] }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }],
      bufferViews: [{ buffer: 0, byteLength: 36 }],
      buffers: [{ byteLength: 36, uri: 'my%20points.bin' }],
    };
    const points = new Uint8Array(Float32Array.from([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer);
    const files = memorySource({
      'x/a.gltf': new TextEncoder().encode(JSON.stringify(json)),
      'x/my points.bin': points,
    });
    const [object] = (await readGltf(files, 'x/a.gltf')).objects;
    const places = [0, 1, 2].map((v) => vertexPosition(object, v, 0, C));
    const expected: Vec3[] = [
      [3, 0, 0],
      [4, 0, 0],
      [3.5, 1, 0],
    ];
    for (const [v, place] of places.entries()) expect(distance(place, expected[v])).toBeLessThan(1e-6);
  });
});

describe('glTF lights', () => {
  it('become distant and sphere lights', async () => {
    const kit = new GltfBuilder();
    const punctual = kit.doc.createExtension(KHRLightsPunctual);
    const sun = punctual.createLight('Sun').setType('directional').setColor([1, 0.5, 0]).setIntensity(4);
    const bulb = punctual.createLight('Bulb').setType('point').setIntensity(2);
    const sunNode = kit.doc.createNode('Sun').setExtension('KHR_lights_punctual', sun);
    // A quarter turn about x takes −z to +y.
    sunNode.setRotation([...fromAxisAngle([1, 0, 0], Math.PI / 2)]);
    const bulbNode = kit.meshNode('Lamp', kit.triangle()).setExtension('KHR_lights_punctual', bulb);
    kit.scene.addChild(sunNode).addChild(bulbNode.setTranslation([1, 2, 3]));
    const { lights, objects } = await kit.read();
    expect(lights[0]).toMatchObject({ kind: 'distant', path: '/Sun', color: [4, 2, 0] });
    const direction = lights[0].kind === 'distant' ? lights[0].direction : ([0, 0, 0] as const);
    expect(distance(direction, [0, 1, 0])).toBeLessThan(1e-6);
    expect(lights[1]).toMatchObject({
      kind: 'sphere',
      path: '/Lamp/Light',
      motion: { kind: 'static', pose: { position: [1, 2, 3] } },
    });
    // From far away the sphere shines as the point does: I = L π r².
    const { radius, color } = lights[1] as { radius: number; color: Vec3 };
    expect(color[0] * Math.PI * radius ** 2).toBeCloseTo(2, 12);
    expect(objects.map((o) => o.path)).toEqual(['/Lamp/Mesh']);
  });

  it('lights move with their nodes', async () => {
    const kit = new GltfBuilder();
    const bulb = kit.doc.createExtension(KHRLightsPunctual).createLight('Bulb').setType('point');
    const node = kit.doc.createNode('Bulb').setExtension('KHR_lights_punctual', bulb);
    kit.scene.addChild(node);
    kit.animate(node, 'translation', [0, 2], [0, 0, 5, 4, 0, 5]);
    const [lamp] = (await kit.read()).lights;
    expect(lamp.kind === 'sphere' && positionAt(originWorldLine(lamp.motion), 0.5, C)).toEqual([1, 0, 5]);
  });
});

describe('glTF extensions', () => {
  it('skips invisible nodes, and reports unsupported extensions', async () => {
    const hidden = { KHR_node_visibility: { visible: false } };
    const json = {
      asset: { version: '2.0' },
      extensionsUsed: ['KHR_node_visibility', 'KHR_materials_ior', 'ACME_smell', 'EXT_texture_webp'],
      extensionsRequired: ['KHR_materials_ior', 'EXT_texture_webp'],
      materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
      textures: [{ sampler: 0, extensions: { EXT_texture_webp: { source: 0 } } }],
      samplers: [{ wrapS: 33071 }],
      images: [{ uri: 'data:image/webp;base64,UklGRg==' }],
      nodes: [{ extensions: hidden, children: [1] }, { camera: 0 }, { camera: 0, name: 'Seen' }],
      cameras: [{ type: 'perspective', perspective: { yfov: 1, znear: 1 } }],
    };
    const files = memorySource({ 'a.gltf': new TextEncoder().encode(JSON.stringify(json)) });
    const { cameras, diagnostics } = await readGltf(files, 'a.gltf');
    expect(cameras.map((c) => c.path)).toEqual(['/Seen']);
    expect(diagnostics.map((d) => [d.severity, inEnglish(d.message)])).toEqual([
      ['warning', 'the extension ACME_smell is left out'],
      ['warning', 'the extension EXT_texture_webp is left out; what uses it is shown without its picture or colour'],
      ['warning', 'its baseColorTexture has no picture that is read; shown without it'],
    ]);
  });
});

describe('glTF cameras', () => {
  it('looks along its node, moving or not', async () => {
    const kit = new GltfBuilder();
    const camera = kit.doc.createCamera('Eye').setType('perspective').setYFov(0.8);
    const node = kit.doc.createNode('Eye').setCamera(camera).setTranslation([0, 0, 5]);
    kit.scene.addChild(node);
    kit.animate(node, 'translation', [0, 2], [0, 0, 5, 4, 0, 5]);
    const [eye] = (await kit.read()).cameras;
    expect(eye).toMatchObject({ path: '/Eye', fovY: 0.8 });
    expect(eye.motion).toMatchObject({ kind: 'sampled' });
    expect(eye.motion.kind === 'sampled' && [...eye.motion.poses]).toEqual([0, 0, 5, 0, 0, 0, 1, 4, 0, 5, 0, 0, 0, 1]);
  });
});
