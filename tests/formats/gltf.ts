import type { Document } from '@gltf-transform/core';
import {
  EXTMeshGPUInstancing,
  KHRLightsPunctual,
  KHRMaterialsEmissiveStrength,
  KHRMaterialsIOR,
  KHRMaterialsUnlit,
  KHRMaterialsVariants,
  KHRTextureTransform,
} from '@gltf-transform/extensions';
import { expect } from 'vitest';
import { vertexPosition } from '../../src/scene/motion.ts';
import type { Material, Scene } from '../../src/scene/types.ts';
import { dracoGlb, meshoptGlb } from '../support/gltfCompress.ts';
import { find, Kit } from '../support/gltfKit.ts';
import { PIXEL, WEBP } from './pictures.ts';
import { approximated, type Files, type Group, leftOut, read, refused } from './row.ts';
import { C } from './usdKit.ts';

/** A document with a triangle at `/Thing`, further filled; as one file. */
type Fill = (kit: Kit, thing: ReturnType<Kit['meshNode']>) => void;
function filled(fill: Fill): Kit {
  const kit = new Kit();
  const thing = kit.meshNode('Thing', kit.triangle());
  kit.scene.addChild(thing);
  fill(kit, thing);
  return kit;
}
const glb =
  (fill: Fill = () => {}, more: Files = {}) =>
  async (): Promise<Files> => ({ 'a.glb': await filled(fill).glb(), ...more });

/** With its triangle compressed, which the example would not be of without. */
const packed = (extension: string, pack: (doc: Document) => Promise<Uint8Array>) => async (): Promise<Files> => {
  const { doc } = filled((kit, thing) => {
    for (const p of thing.getMesh()!.listPrimitives()) p.setIndices(kit.ints('SCALAR', [0, 1, 2]));
  });
  const bytes = await pack(doc);
  expect(new TextDecoder('latin1').decode(bytes)).toMatch(new RegExp(`"${extension}":\\{"b`));
  return { 'a.glb': bytes };
};

/** With a material on its triangle. */
const worn = (fill: (material: ReturnType<Kit['doc']['createMaterial']>, kit: Kit) => void, more: Files = {}) =>
  glb((kit, thing) => {
    const material = kit.doc.createMaterial('Paint');
    for (const primitive of thing.getMesh()!.listPrimitives()) {
      primitive.setMaterial(material);
      primitive.setAttribute('TEXCOORD_0', kit.values('VEC2', [0, 0, 1, 0, 0, 1]));
      primitive.setAttribute('TEXCOORD_1', kit.values('VEC2', [0, 0, 1, 0, 0, 1]));
    }
    fill(material, kit);
  }, more);

const base = (scene: Scene): Material => scene.materials[find(scene, '/Thing').mesh.groups[0].material];

/** A triangle as JSON; `more` is laid over it. */
const json = (more: object): Files => ({
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
const triangles = (count: number) => (scene: Scene) =>
  expect(find(scene, '/Thing').mesh.indices.length).toBe(3 * count);
const kinds =
  (...wanted: string[]) =>
  (scene: Scene) =>
    expect(scene.objects.map(({ motion }) => motion.kind)).toEqual(wanted);

const files: Group = {
  title: 'Files',
  rows: [
    read(
      '`.glb`, and `.gltf` with its `.bin` and pictures beside it or inside',
      'a scene in metres, Y up',
      json({}),
      triangles(1),
    ),
    read(
      '`KHR_draco_mesh_compression`',
      'unpacked',
      packed('KHR_draco_mesh_compression', (doc) => dracoGlb(doc, 'edgebreaker')),
      triangles(1),
    ),
    read(
      '`EXT_meshopt_compression`, `KHR_meshopt_compression`, `KHR_mesh_quantization`',
      'unpacked',
      packed('EXT_meshopt_compression', (doc) => meshoptGlb(doc, 'filter')),
      triangles(1),
    ),
    read(
      '`extras.slowlight` of the scene: `speedOfLight`, `title`, `lookFor`, `beta`, `openAt`',
      'what the author suggests for viewing',
      json({ scenes: [{ nodes: [0], extras: { slowlight: { speedOfLight: 10, title: 'Street' } } }] }),
      (s) => expect(s.hints).toEqual({ speedOfLight: 10, title: 'Street' }),
    ),
    leftOut(
      'every other extension that is only used',
      'named',
      'gltf.ignored-extension',
      json({ extensionsUsed: ['EXT_new'] }),
      triangles(1),
    ),
    refused(
      'an extension that is required and not read, and is more than a look',
      'with its name',
      'gltf.unsupported-extension',
      json({ extensionsUsed: ['EXT_new'], extensionsRequired: ['EXT_new'] }),
    ),
    refused('glTF 1', 'with its version', 'gltf.version', json({ asset: { version: '1.0' } })),
    refused('JSON that is damaged', 'with the place', 'gltf.damaged', { 'a.gltf': '{' }),
    refused('JSON that is not as the schema has it', 'with place and value', 'gltf.invalid', json({ nodes: {} })),
    refused(
      'a file or buffer that is cut off',
      'with what it holds and should',
      'gltf.truncated',
      json({ buffers: [{ byteLength: 40, uri: 'a.bin' }] }),
    ),
    refused('a buffer that is not there', 'with its name', 'gltf.missing-file', { 'a.gltf': json({})['a.gltf'] }),
    refused(
      'an index of what is not there',
      'with place and number',
      'gltf.bad-reference',
      json({ nodes: [{ mesh: 7 }] }),
    ),
    refused(
      'bytes that are not there',
      'with their place',
      'gltf.out-of-range',
      json({ bufferViews: [{ buffer: 0, byteLength: 36, byteOffset: 4 }] }),
    ),
    refused(
      'nodes in themselves, or with two parents',
      'with the node',
      'gltf.bad-tree',
      json({ nodes: [{ mesh: 0, children: [0] }] }),
    ),
    refused(
      'more objects, vertices or bytes than a scene may have',
      'with the number',
      'gltf.too-large',
      json({ accessors: [{ componentType: 5126, count: 2 ** 30, type: 'VEC3' }] }),
    ),
  ],
};

const shapes: Group = {
  title: 'Nodes and shapes',
  rows: [
    read(
      'nodes, with translation, rotation, scale or a matrix (also a shearing one)',
      'an object for each node with a mesh; `/Parent/Child`, or `/Parent/Child/Mesh` where the node holds more',
      glb((_, thing) => thing.setTranslation([1, 2, 3])),
      (s) => expect(vertexPosition(find(s, '/Thing'), 0, 0, C)).toEqual([1, 2, 3]),
    ),
    read(
      'triangles, strips, fans; several primitives',
      'one mesh with a run of triangles for each material; flat where there are no normals',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]).setMode(5));
      }),
      triangles(3),
    ),
    read(
      'sparse accessors',
      'the values they change',
      json({
        accessors: [
          {
            componentType: 5126,
            count: 3,
            type: 'VEC3',
            sparse: {
              count: 1,
              indices: { bufferView: 1, componentType: 5123 },
              values: { bufferView: 0, byteOffset: 12 },
            },
          },
        ],
        bufferViews: [
          { buffer: 0, byteLength: 36 },
          { buffer: 0, byteLength: 2 },
        ],
      }),
      (s) => expect([...find(s, '/Thing').mesh.positions.subarray(0, 3)]).toEqual([1, 0, 0]),
    ),
    read(
      '`EXT_mesh_gpu_instancing`',
      'an object for each instance: `/Node/Instance0`',
      glb((kit, thing) => {
        const of = kit.doc.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
        thing.setExtension(
          'EXT_mesh_gpu_instancing',
          of.setAttribute('TRANSLATION', kit.values('VEC3', [0, 0, 0, 5, 0, 0])),
        );
      }),
      (s) => expect(s.objects.map((o) => o.path)).toEqual(['/Thing/Instance0', '/Thing/Instance1']),
    ),
    read(
      '`KHR_node_visibility`',
      'hidden nodes are not shown',
      json({
        extensionsUsed: ['KHR_node_visibility'],
        scenes: [{ nodes: [0, 1] }],
        nodes: [
          { name: 'Thing', mesh: 0 },
          { mesh: 0, extensions: { KHR_node_visibility: { visible: false } } },
        ],
      }),
      (s) => expect(s.objects.length).toBe(1),
    ),
    leftOut(
      'points, lines',
      'named',
      'gltf.primitive',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle().setMode(1));
      }),
      triangles(1),
    ),
    leftOut(
      'attributes of instances beside place, turn and size',
      'named',
      'gltf.instance-attributes',
      glb((kit, thing) => {
        const of = kit.doc.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
        of.setAttribute('TRANSLATION', kit.values('VEC3', [0, 0, 0])).setAttribute(
          '_COLOR',
          kit.values('VEC3', [1, 0, 0]),
        );
        thing.setExtension('EXT_mesh_gpu_instancing', of);
      }),
    ),
    approximated(
      'single-sided and double-sided materials on one mesh',
      'all of it double-sided',
      'gltf.mixed-sides',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle().setMaterial(kit.doc.createMaterial().setDoubleSided(true)));
      }),
      (s) => expect(find(s, '/Thing').mesh.doubleSided).toBe(true),
    ),
    refused(
      'a triangle with a vertex that is not there',
      'with the number',
      'gltf.bad-index',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle().setIndices(kit.ints('SCALAR', [0, 1, 7])));
      }),
    ),
    refused(
      'an attribute with too few values',
      'with the numbers',
      'gltf.bad-attribute',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle().setAttribute('NORMAL', kit.values('VEC3', [0, 0, 1])));
      }),
    ),
  ],
};

const picture = (kit: Kit, bytes: Uint8Array = PIXEL, mime = 'image/png') =>
  kit.doc.createTexture('bark').setImage(Uint8Array.from(bytes)).setMimeType(mime);

const looks: Group = {
  title: 'Materials',
  rows: [
    read(
      'base colour, emission (× `KHR_materials_emissive_strength`), roughness, metalness, `KHR_materials_ior`, double sides, vertex colours',
      'the same',
      worn((m, { doc }) => {
        m.setBaseColorFactor([1, 0, 0, 1]).setEmissiveFactor([1, 1, 1]);
        m.setExtension(
          'KHR_materials_emissive_strength',
          doc.createExtension(KHRMaterialsEmissiveStrength).createEmissiveStrength().setEmissiveStrength(5),
        );
        m.setExtension('KHR_materials_ior', doc.createExtension(KHRMaterialsIOR).createIOR().setIOR(1.25));
      }),
      (s) => expect(base(s)).toMatchObject({ baseColor: [1, 0, 0], emissive: [5, 5, 5], ior: 1.25 }),
    ),
    read(
      'alpha mode `MASK`, `BLEND`',
      'opacity and its threshold; with `OPAQUE` alpha does not count',
      worn((m) => {
        m.setAlphaMode('MASK').setAlphaCutoff(0.25).setBaseColorFactor([1, 1, 1, 0.5]);
      }),
      (s) => expect(base(s)).toMatchObject({ opacity: 0.5, opacityThreshold: 0.25 }),
    ),
    read(
      '`KHR_materials_unlit`',
      'a surface that sends out its colour and reflects nothing',
      worn((m, { doc }) => {
        m.setBaseColorFactor([1, 0, 0, 1]).setExtension(
          'KHR_materials_unlit',
          doc.createExtension(KHRMaterialsUnlit).createUnlit(),
        );
      }),
      (s) => expect(base(s)).toMatchObject({ baseColor: [0, 0, 0], emissive: [1, 0, 0] }),
    ),
    read(
      'PNG and JPEG pictures of base colour and emission',
      'textures of 8 bits',
      worn((m, kit) => {
        m.setBaseColorTexture(picture(kit));
      }),
      (s) => expect(base(s).baseColorTexture?.width).toBe(1),
    ),
    read(
      '`KHR_texture_transform`',
      'moved into the uvs',
      worn((m, kit) => {
        m.setBaseColorTexture(picture(kit));
        m.getBaseColorTextureInfo()!.setExtension(
          'KHR_texture_transform',
          kit.doc.createExtension(KHRTextureTransform).createTransform().setScale([3, 3]),
        );
      }),
      (s) => expect(Math.max(...find(s, '/Thing').mesh.uvs)).toBe(3),
    ),
    read(
      '`KHR_materials_variants`',
      'the variant that is asked for (set `material`); the scene lists what there is',
      glb((kit, thing) => {
        const variants = kit.doc.createExtension(KHRMaterialsVariants);
        const red = variants.createVariant('red');
        const mapping = variants.createMapping().setMaterial(kit.doc.createMaterial('Red')).addVariant(red);
        thing
          .getMesh()!
          .listPrimitives()[0]
          .setExtension('KHR_materials_variants', variants.createMappingList().addMapping(mapping));
      }),
      (s) => expect(base(s).name).toBe('Red'),
      { options: { variants: new Map([['material', 'red']]) } },
    ),
    approximated(
      'an emission texture with other uvs than the base colour’s',
      'the base colour’s are used for both',
      'gltf.second-uvs',
      worn((m, kit) => {
        m.setBaseColorTexture(picture(kit)).setEmissiveTexture(picture(kit));
        m.getEmissiveTextureInfo()!.setTexCoord(1);
      }),
    ),
    leftOut(
      'normal, occlusion and metallic-roughness textures',
      'named; factors count',
      'gltf.ignored-texture',
      worn((m, kit) => {
        m.setRoughnessFactor(0.5).setMetallicRoughnessTexture(picture(kit));
      }),
      (s) => expect(base(s).roughness).toBe(0.5),
    ),
    leftOut(
      'the opacity of vertex colours',
      'named',
      'gltf.vertex-alpha',
      worn((m, kit) => {
        m.setAlphaMode('BLEND');
        for (const p of kit.doc.getRoot().listMeshes()[0].listPrimitives())
          p.setAttribute('COLOR_0', kit.values('VEC4', [1, 0, 0, 0.5, 1, 0, 0, 0.5, 1, 0, 0, 0.5]));
      }),
    ),
    leftOut(
      'a picture that is damaged, too large, or neither PNG nor JPEG (WebP, KTX2)',
      'named with what it is',
      'gltf.texture',
      worn((m, kit) => {
        m.setBaseColorTexture(picture(kit, WEBP));
      }),
      (s) => expect(base(s).baseColorTexture).toBeUndefined(),
    ),
    leftOut(
      'a picture that is not there',
      'named with where it was looked for; it can be dropped on the page',
      'file.missing-texture',
      json({ images: [{ uri: 'bark.png' }] }),
      (s) => expect(s.diagnostics[0].missing?.lookedFor).toEqual(['bark.png']),
    ),
    refused('a variant that is asked for and not there', 'with those that are', 'gltf.no-variant', json({}), {
      variants: new Map([['material', 'red']]),
    }),
  ],
};

const light =
  (type: 'directional' | 'point' | 'spot', range?: number): Fill =>
  (kit) => {
    const made = kit.doc
      .createExtension(KHRLightsPunctual)
      .createLight()
      .setType(type)
      .setIntensity(Math.PI * 0.05 ** 2);
    if (range !== undefined) made.setRange(range);
    kit.scene.addChild(kit.doc.createNode('Lamp').setExtension('KHR_lights_punctual', made));
  };

const lights: Group = {
  title: 'Lights and cameras',
  rows: [
    read(
      '`KHR_lights_punctual`: point, spot',
      'a sphere of 5 cm of the same luminous intensity, a spot within its cone; it moves where its node does',
      glb(light('spot')),
      (s) =>
        expect(s.lights).toMatchObject([
          {
            kind: 'sphere',
            radius: 0.05,
            color: [1, 1, 1].map((x) => expect.closeTo(x, 12)),
            shaping: { inner: 0, outer: Math.PI / 4 },
          },
        ]),
    ),
    read('`KHR_lights_punctual`: directional', 'a distant light', glb(light('directional')), (s) =>
      expect(s.lights).toMatchObject([{ kind: 'distant', direction: [0, 0, -1] }]),
    ),
    leftOut('a range of a light', 'named; light goes on for ever', 'gltf.light', glb(light('point', 7)), (s) =>
      expect(s.lights.length).toBe(1),
    ),
    read(
      'perspective cameras',
      'cameras, moving where their node does',
      glb((kit) => {
        kit.scene.addChild(
          kit.doc.createNode('Eye').setCamera(kit.doc.createCamera().setType('perspective').setYFov(0.5)),
        );
      }),
      (s) => expect(s.cameras).toMatchObject([{ path: '/Eye', fovY: 0.5 }]),
    ),
    leftOut(
      'orthographic cameras',
      'named',
      'gltf.camera',
      glb((kit) => {
        kit.scene.addChild(kit.doc.createNode('Eye').setCamera(kit.doc.createCamera().setType('orthographic')));
      }),
      (s) => expect(s.cameras).toEqual([]),
    ),
  ],
};

const motion: Group = {
  title: 'Animations',
  rows: [
    read(
      'translation and rotation: linear, cubic spline',
      'rigid motion in the world frame',
      glb((kit, thing) => kit.animate(thing, 'translation', [0, 1], [0, 0, 0, 4, 0, 0])),
      (s) => {
        kinds('sampled')(s);
        expect(vertexPosition(find(s, '/Thing'), 0, 0.5, C)[0]).toBeCloseTo(2, 6);
      },
    ),
    read(
      'scale, shear, morph weights, joints',
      'a path for each vertex',
      glb((kit, thing) => kit.animate(thing, 'scale', [0, 1], [1, 1, 1, 3, 3, 3])),
      kinds('sampled-points'),
    ),
    approximated(
      'step',
      'a ramp of at most a millisecond, which may be faster than light',
      'gltf.jump',
      glb((kit, thing) => kit.animate(thing, 'translation', [0, 1], [0, 0, 0, 4, 0, 0], 'STEP')),
      kinds('sampled'),
    ),
    read(
      'several animations',
      'the first, unless another is chosen (set `animation`)',
      glb((kit, thing) => {
        kit.animate(thing, 'translation', [0, 1], [0, 0, 0, 4, 0, 0]);
        kit.doc.createAnimation('Other');
      }),
      (s) => expect(s.variants).toEqual([{ set: 'animation', options: ['Move', 'Other'], chosen: 'Move' }]),
      { says: 'gltf.animations' },
    ),
    approximated(
      'a path that turns too fast between its keys to be followed',
      'as near as is affordable; the error is told',
      'gltf.resampling',
      glb((kit, thing) => {
        const keys = Array.from({ length: 25000 }, (_, i) => i);
        kit.animate(
          thing,
          'rotation',
          keys,
          keys.flatMap((i) => [0, 0, Math.sin(i * 1.4), Math.cos(i * 1.4)]),
        );
      }),
      kinds('sampled'),
    ),
    approximated(
      'a directional light that turns',
      'held where it starts',
      'gltf.light',
      glb((kit, thing) => {
        light('directional')(kit, thing);
        kit.animate(kit.scene.listChildren()[1], 'rotation', [0, 1], [0, 0, 0, 1, 0, 1, 0, 0]);
      }),
      (s) => expect(s.lights.length).toBe(1),
    ),
    leftOut(
      'instances of a skinned mesh',
      'one is shown: all follow the same joints',
      'gltf.instances',
      glb((kit, thing) => {
        const skin = kit.doc.createSkin().addJoint(kit.doc.createNode('Joint'));
        kit.scene.addChild(skin.listJoints()[0]);
        thing.setSkin(skin);
        for (const p of thing.getMesh()!.listPrimitives())
          p.setAttribute('JOINTS_0', kit.ints('VEC4', Array(12).fill(0))).setAttribute(
            'WEIGHTS_0',
            kit.values('VEC4', [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]),
          );
        const of = kit.doc.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
        thing.setExtension(
          'EXT_mesh_gpu_instancing',
          of.setAttribute('TRANSLATION', kit.values('VEC3', [0, 0, 0, 5, 0, 0])),
        );
      }),
      (s) => expect(s.objects.length).toBe(1),
    ),
    refused(
      'keys that do not fit together',
      'with the animation and the numbers',
      'gltf.bad-animation',
      glb((kit, thing) => kit.animate(thing, 'translation', [0, 1], [0, 0, 0])),
    ),
    refused(
      'joints that do not fit together',
      'with the numbers',
      'gltf.bad-skin',
      glb((kit, thing) => {
        const joint = kit.doc.createNode('Joint');
        kit.scene.addChild(joint);
        thing.setSkin(kit.doc.createSkin().addJoint(joint));
        for (const p of thing.getMesh()!.listPrimitives())
          p.setAttribute('JOINTS_0', kit.ints('VEC4', Array(12).fill(7))).setAttribute(
            'WEIGHTS_0',
            kit.values('VEC4', [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]),
          );
      }),
    ),
    refused('an animation that is asked for and not there', 'with those that are', 'gltf.no-animation', json({}), {
      animation: 'Jump',
    }),
  ],
};

export const gltfGroups: readonly Group[] = [files, shapes, looks, lights, motion];
