import {
  EXTMeshGPUInstancing,
  KHRLightsPunctual,
  KHRMaterialsAnisotropy,
  KHRMaterialsClearcoat,
  KHRMaterialsDispersion,
  KHRMaterialsEmissiveStrength,
  KHRMaterialsIOR,
  KHRMaterialsIridescence,
  KHRMaterialsPBRSpecularGlossiness,
  KHRMaterialsSheen,
  KHRMaterialsSpecular,
  KHRMaterialsTransmission,
  KHRMaterialsUnlit,
  KHRMaterialsVariants,
  KHRMaterialsVolume,
  KHRTextureTransform,
} from '@gltf-transform/extensions';
import { expect } from 'vitest';
import { decodePicture } from '../../src/cli/files/decodePicture.ts';
import { vertexPosition } from '../../src/scene/motion/motion.ts';
import type { Material, Scene } from '../../src/scene/types.ts';
import { find, type GltfBuilder } from '../support/gltfBuilder.ts';
import { solidKtx2 } from '../support/ktx2Kit.ts';
import { approximated, type ClaimGroup, leftOut, read, refused } from './claim.ts';
import { type Fill, glb, json, kinds, withMaterial } from './gltfExamples.ts';
import { FOUR_PIXELS_WEBP, PIXEL, WEBP } from './pictures.ts';
import { C } from './usdKit.ts';

const base = (scene: Scene): Material => scene.materials[find(scene, '/Thing').mesh.groups[0].material];

const picture = (kit: GltfBuilder, bytes: Uint8Array = PIXEL, mime = 'image/png') =>
  kit.doc.createTexture('bark').setImage(Uint8Array.from(bytes)).setMimeType(mime);

const looks: ClaimGroup = {
  title: 'Materials',
  rows: [
    read(
      'base colour, emission (× `KHR_materials_emissive_strength`), roughness, metalness, `KHR_materials_ior`, double sides, vertex colours',
      'the same',
      withMaterial((m, { doc }) => {
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
      'alpha modes `MASK`, `BLEND`',
      'opacity and its threshold; with `OPAQUE` alpha is ignored',
      withMaterial((m) => {
        m.setAlphaMode('MASK').setAlphaCutoff(0.25).setBaseColorFactor([1, 1, 1, 0.5]);
      }),
      (s) => expect(base(s)).toMatchObject({ opacity: 0.5, opacityThreshold: 0.25 }),
    ),
    read(
      '`KHR_materials_unlit`',
      'a surface that emits its colour and reflects nothing; seen unshifted, it shows that colour exactly, without the tone curve',
      withMaterial((m, { doc }) => {
        m.setBaseColorFactor([1, 0, 0, 1]).setExtension(
          'KHR_materials_unlit',
          doc.createExtension(KHRMaterialsUnlit).createUnlit(),
        );
      }),
      (s) => expect(base(s)).toMatchObject({ baseColor: [0, 0, 0], emissive: [1, 0, 0], ior: 1, unlit: true }),
    ),
    read(
      '`KHR_materials_specular`: strength and colour, with textures',
      'the reflection of what is no metal',
      withMaterial((m, kit) => {
        const specular = kit.doc.createExtension(KHRMaterialsSpecular).createSpecular();
        specular.setSpecularFactor(0.5).setSpecularColorFactor([2, 1, 0]).setSpecularColorTexture(picture(kit));
        m.setExtension('KHR_materials_specular', specular);
      }),
      (s) =>
        expect(base(s).specular).toMatchObject({ factor: 0.5, color: [2, 1, 0], colorTexture: { colorSpace: 'srgb' } }),
    ),
    read(
      '`KHR_materials_clearcoat`: strength, roughness, with textures and a normal map',
      'a varnish over the material',
      withMaterial((m, kit) => {
        const coat = kit.doc.createExtension(KHRMaterialsClearcoat).createClearcoat();
        coat.setClearcoatFactor(0.5).setClearcoatRoughnessFactor(0.25).setClearcoatNormalTexture(picture(kit));
        m.setExtension('KHR_materials_clearcoat', coat);
      }),
      (s) =>
        expect(base(s).clearcoat).toMatchObject({ factor: 0.5, roughness: 0.25, normalTexture: { strength: [1, 1] } }),
    ),
    read(
      '`KHR_materials_transmission`, `KHR_materials_volume`, `KHR_materials_dispersion`, with textures',
      'clear glass: a thin sheet, or a body that refracts and absorbs',
      withMaterial((m, kit) => {
        const clear = kit.doc.createExtension(KHRMaterialsTransmission).createTransmission();
        m.setExtension('KHR_materials_transmission', clear.setTransmissionFactor(0.5));
        const volume = kit.doc.createExtension(KHRMaterialsVolume).createVolume().setThicknessFactor(0.25);
        m.setExtension('KHR_materials_volume', volume.setAttenuationColor([1, 0.5, 0]).setAttenuationDistance(2));
        const spread = kit.doc.createExtension(KHRMaterialsDispersion).createDispersion().setDispersion(0.25);
        m.setExtension('KHR_materials_dispersion', spread);
      }),
      (s) =>
        expect(base(s)).toMatchObject({
          transmission: { factor: 0.5 },
          volume: { thickness: 0.25, attenuationColor: [1, 0.5, 0], attenuationDistance: 2 },
          dispersion: 0.25,
        }),
    ),
    read(
      '`KHR_materials_anisotropy`, with texture',
      'grooves that widen the reflection along one direction of the uvs',
      withMaterial((m, kit) => {
        const grooves = kit.doc.createExtension(KHRMaterialsAnisotropy).createAnisotropy();
        grooves.setAnisotropyStrength(0.5).setAnisotropyRotation(0.25).setAnisotropyTexture(picture(kit));
        m.setExtension('KHR_materials_anisotropy', grooves);
      }),
      (s) =>
        expect(base(s).anisotropy).toMatchObject({
          strength: 0.5,
          rotation: 0.25,
          directionTexture: { colorSpace: 'linear' },
        }),
    ),
    read(
      '`KHR_materials_sheen`, with textures',
      'fuzz that reflects at grazing angles, over the material and under its varnish',
      withMaterial((m, kit) => {
        const sheen = kit.doc.createExtension(KHRMaterialsSheen).createSheen();
        sheen.setSheenColorFactor([0.5, 0.25, 1]).setSheenColorTexture(picture(kit)).setSheenRoughnessFactor(0.25);
        m.setExtension('KHR_materials_sheen', sheen);
      }),
      (s) =>
        expect(base(s).sheen).toMatchObject({
          color: [0.5, 0.25, 1],
          colorTexture: { colorSpace: 'srgb' },
          roughness: 0.25,
        }),
    ),
    read(
      '`KHR_materials_iridescence`, with textures',
      'a thin film whose interference depends on the wavelength in the rest frame',
      withMaterial((m, kit) => {
        const film = kit.doc.createExtension(KHRMaterialsIridescence).createIridescence();
        film.setIridescenceFactor(0.5).setIridescenceIOR(1.25).setIridescenceThicknessMaximum(500);
        m.setExtension('KHR_materials_iridescence', film);
      }),
      (s) =>
        expect(base(s).iridescence).toMatchObject({
          factor: 0.5,
          ior: 1.25,
          thickness: [expect.closeTo(1e-7, 12), expect.closeTo(5e-7, 12)],
        }),
    ),
    read(
      '`KHR_materials_pbrSpecularGlossiness`, with textures',
      'base colour, metalness and roughness by the rule of the extension’s appendix',
      withMaterial((m, { doc }) => {
        const glossy = doc.createExtension(KHRMaterialsPBRSpecularGlossiness).createPBRSpecularGlossiness();
        glossy.setDiffuseFactor([0, 0, 0, 1]).setSpecularFactor([1, 0.8, 0.3]).setGlossinessFactor(0.75);
        m.setExtension('KHR_materials_pbrSpecularGlossiness', glossy);
      }),
      (s) =>
        expect(base(s)).toMatchObject({
          baseColor: [1, 0.8, 0.3].map((x) => expect.closeTo(x, 6)),
          metallic: expect.closeTo(1, 6),
          roughness: 0.25,
        }),
    ),
    read(
      'PNG and JPEG pictures of base colour and emission',
      '8-bit textures',
      withMaterial((m, kit) => {
        m.setBaseColorTexture(picture(kit));
      }),
      (s) => expect(base(s).baseColorTexture?.width).toBe(1),
    ),
    read(
      '`KHR_texture_transform`',
      'applied to the uvs',
      withMaterial((m, kit) => {
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
      'the requested variant (set `material`); the scene lists all',
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
      'textures of one material with different uvs',
      'the uvs of the first are used, in the order base colour, emission, normal, metallic-roughness',
      'gltf.second-uvs',
      withMaterial((m, kit) => {
        m.setBaseColorTexture(picture(kit)).setEmissiveTexture(picture(kit));
        m.getEmissiveTextureInfo()!.setTexCoord(1);
      }),
    ),
    read(
      'normal and metallic-roughness textures',
      'applied per pixel',
      withMaterial((m, kit) => {
        m.setMetallicRoughnessTexture(picture(kit)).setRoughnessFactor(0.5);
        m.setNormalTexture(picture(kit)).setNormalScale(0.25);
      }),
      (s) =>
        expect(base(s)).toMatchObject({
          roughnessTexture: { channel: 1, scale: 0.5, texture: { colorSpace: 'linear' } },
          metallicTexture: { channel: 2, scale: 1 },
          normalTexture: { strength: [0.25, 0.25] },
        }),
    ),
    read(
      'extras `slowlight:albedo:uv`, `slowlight:albedo:ir`, `slowlight:emission:temperature` [K] of a material',
      'the reflectance of invisible light, and emission that shifts as that of a blackbody',
      withMaterial((m) => {
        m.setExtras({ 'slowlight:albedo:ir': 0.5, 'slowlight:emission:temperature': 3000 });
      }),
      (s) => expect(base(s)).toMatchObject({ ir: 0.5, emissionTemperature: 3000 }),
    ),
    leftOut(
      'such extras that are not numbers or are out of range',
      'reported',
      'gltf.slowlight',
      withMaterial((m) => {
        m.setExtras({ 'slowlight:albedo:uv': 7, 'slowlight:emission:temperature': 'hot' });
      }),
      (s) => expect(base(s).uv).toBeUndefined(),
    ),
    read(
      'occlusion textures and their strength',
      'they dim the light from the sky and from other surfaces',
      withMaterial((m, kit) => {
        m.setOcclusionTexture(picture(kit)).setOcclusionStrength(0.25);
      }),
      (s) => expect(base(s).occlusionTexture).toMatchObject({ channel: 0, scale: 0.25, bias: 0.75 }),
    ),
    read(
      'the extras `slowlight:albedo:uv` and `:ir` as `{ "image": 0, "channel": 1 }`',
      'reflectance of invisible light from that channel of the image',
      withMaterial((m, kit) => {
        m.setBaseColorTexture(picture(kit)).setExtras({ 'slowlight:albedo:ir': { image: 0, channel: 1, scale: 0.5 } });
      }),
      (s) =>
        expect(base(s).irTexture).toMatchObject({ channel: 1, scale: 0.5, bias: 0, texture: { colorSpace: 'linear' } }),
    ),
    leftOut(
      'alpha of vertex colours',
      'reported',
      'gltf.vertex-alpha',
      withMaterial((m, kit) => {
        m.setAlphaMode('BLEND');
        for (const p of kit.doc.getRoot().listMeshes()[0].listPrimitives())
          p.setAttribute('COLOR_0', kit.values('VEC4', [1, 0, 0, 0.5, 1, 0, 0, 0.5, 1, 0, 0, 0.5]));
      }),
    ),
    read(
      '`EXT_texture_webp`, `EXT_texture_avif`; WebP and AVIF without them',
      'decoded by the browser in the page, by libwebp and libavif on the command line; where that fails, the picture beside it. Code gives a decoder (`decodePicture`)',
      withMaterial((m, kit) => {
        m.setBaseColorTexture(picture(kit, FOUR_PIXELS_WEBP));
      }),
      (s) => expect([...base(s).baseColorTexture!.data.subarray(0, 8)]).toEqual([255, 0, 0, 255, 0, 255, 0, 255]),
      { options: { decodePicture } },
    ),
    read(
      '`KHR_texture_basisu`; KTX2 without it: Basis Universal (ETC1S, UASTC), 8 bits a channel, with or without Zstandard',
      'the largest level, to the byte as Basis Universal’s own transcoder decodes it; the same in the page and on the command line',
      withMaterial((m, kit) => {
        m.setBaseColorTexture(picture(kit, solidKtx2(200, 10, 20, 255), 'image/ktx2'));
      }),
      (s) => expect([...base(s).baseColorTexture!.data.subarray(0, 4)]).toEqual([200, 10, 20, 255]),
    ),
    leftOut(
      'a picture that is damaged or too large, or KTX2 with several pictures or other formats (BC7, ASTC, floats)',
      'reported with what it is',
      'file.unreadable-texture',
      withMaterial((m, kit) => {
        m.setBaseColorTexture(picture(kit, WEBP));
      }),
      (s) => expect(base(s).baseColorTexture).toBeUndefined(),
    ),
    leftOut(
      'a missing picture',
      'reported with the places that were searched; the file can be dropped on the page',
      'file.missing-texture',
      json({ images: [{ uri: 'bark.png' }] }),
      (s) => expect(s.diagnostics[0].missing?.lookedFor).toEqual(['bark.png']),
    ),
    refused('a requested variant that does not exist', 'with those that exist', 'gltf.no-variant', json({}), {
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

const lights: ClaimGroup = {
  title: 'Lights and cameras',
  rows: [
    read(
      '`KHR_lights_punctual`: point, spot',
      'a sphere of 5 cm with the same luminous intensity, a spot limited to its cone; it moves with its node',
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
    read(
      'the extra `slowlight:spectrum` of a light: `"2856 K"`, `"sodium"` …',
      'the spectrum of its light',
      glb((kit) => {
        const lamp = kit.doc.createExtension(KHRLightsPunctual).createLight().setType('point');
        const spectrum = lamp.setExtras({ 'slowlight:spectrum': '2856 K' });
        kit.scene.addChild(kit.doc.createNode('Lamp').setExtension('KHR_lights_punctual', spectrum));
      }),
      (s) => expect(s.lights[0]).toMatchObject({ spectrum: { kind: 'thermal', temperature: 2856 } }),
    ),
    leftOut(
      'the extra `slowlight:spectrum` of a light as `"lamp.csv"`, a table beside the scene, if it is missing',
      'reported; if the table exists, the light has its spectrum',
      'file.missing-spectrum',
      glb((kit) => {
        const lamp = kit.doc.createExtension(KHRLightsPunctual).createLight().setType('point');
        const spectrum = lamp.setExtras({ 'slowlight:spectrum': 'lamp.csv' });
        kit.scene.addChild(kit.doc.createNode('Lamp').setExtension('KHR_lights_punctual', spectrum));
      }),
      (s) => expect(s.lights[0]).not.toHaveProperty('spectrum'),
    ),
    leftOut(
      'the range of a light',
      'reported; the light has no cutoff distance',
      'gltf.light',
      glb(light('point', 7)),
      (s) => expect(s.lights.length).toBe(1),
    ),
    read(
      'perspective cameras',
      'cameras that move with their node',
      glb((kit) => {
        kit.scene.addChild(
          kit.doc.createNode('Eye').setCamera(kit.doc.createCamera().setType('perspective').setYFov(0.5)),
        );
      }),
      (s) => expect(s.cameras).toMatchObject([{ path: '/Eye', fovY: 0.5 }]),
    ),
    leftOut(
      'orthographic cameras',
      'reported',
      'gltf.camera',
      glb((kit) => {
        kit.scene.addChild(kit.doc.createNode('Eye').setCamera(kit.doc.createCamera().setType('orthographic')));
      }),
      (s) => expect(s.cameras).toEqual([]),
    ),
  ],
};

/** A mesh fully weighted to one joint. */
function skinned(
  kit: GltfBuilder,
  thing: ReturnType<GltfBuilder['meshNode']>,
  place: number,
): ReturnType<GltfBuilder['meshNode']> {
  const joint = kit.doc.createNode('Joint');
  kit.scene.addChild(joint);
  thing.setSkin(kit.doc.createSkin().addJoint(joint));
  for (const p of thing.getMesh()!.listPrimitives()) {
    p.setAttribute('JOINTS_0', kit.ints('VEC4', Array(12).fill(place)));
    p.setAttribute('WEIGHTS_0', kit.values('VEC4', [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]));
  }
  return joint;
}

const motion: ClaimGroup = {
  title: 'Animations',
  rows: [
    read(
      'translation and rotation: linear, cubic spline',
      'rigid motion in the world frame',
      [
        glb((kit, thing) => kit.animate(thing, 'translation', [0, 1], [0, 0, 0, 4, 0, 0])),
        glb((kit, thing) => {
          const values = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0];
          kit.animate(thing, 'translation', [0, 1], values, 'CUBICSPLINE');
        }),
      ],
      (s) => {
        kinds('sampled')(s);
        expect(vertexPosition(find(s, '/Thing'), 0, 0.5, C)[0]).toBeCloseTo(2, 6);
      },
    ),
    read(
      'scale, shear, morph weights and joints',
      'one path per vertex',
      [
        glb((kit, thing) => kit.animate(thing, 'scale', [0, 1], [1, 1, 1, 3, 3, 3])),
        glb((kit, thing) => {
          const target = kit.doc.createPrimitiveTarget().setAttribute('POSITION', kit.values('VEC3', Array(9).fill(1)));
          for (const p of thing.getMesh()!.listPrimitives()) p.addTarget(target);
          kit.animate(thing, 'weights', [0, 1], [0, 1]);
        }),
        glb((kit, thing) => {
          const joint = skinned(kit, thing, 0);
          kit.animate(joint, 'rotation', [0, 1], [0, 0, 0, 1, 0, 0, Math.SQRT1_2, Math.SQRT1_2]);
        }),
      ],
      kinds('sampled-points'),
    ),
    approximated(
      'step interpolation',
      'a ramp of at most one millisecond, which may be faster than light',
      'gltf.jump',
      glb((kit, thing) => kit.animate(thing, 'translation', [0, 1], [0, 0, 0, 4, 0, 0], 'STEP')),
      kinds('sampled'),
    ),
    approximated(
      'an interpolation that does not exist, as the 0 that some programs write',
      'linear, and reported',
      'gltf.interpolation',
      json({
        accessors: [
          { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' },
          { bufferView: 0, byteOffset: 8, componentType: 5126, count: 2, type: 'SCALAR' },
          { bufferView: 0, componentType: 5126, count: 2, type: 'VEC3' },
        ],
        animations: [
          {
            samplers: [{ input: 1, output: 2, interpolation: 0 }],
            channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }],
          },
        ],
      }),
      (s) => expect(vertexPosition(find(s, '/Thing'), 0, 0.5, C)).toEqual([0.5, 0, 0]),
    ),
    read(
      'several animations',
      'the first is used unless another is chosen (set `animation`)',
      glb((kit, thing) => {
        kit.animate(thing, 'translation', [0, 1], [0, 0, 0, 4, 0, 0]);
        kit.doc.createAnimation('Other');
      }),
      (s) => expect(s.variants).toEqual([{ set: 'animation', options: ['Move', 'Other'], chosen: 'Move' }]),
      { says: 'gltf.animations' },
    ),
    approximated(
      'a path that rotates too fast between its keys to be resampled within tolerance',
      'as close as the sample limit allows; the error is reported',
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
      'a rotating directional light',
      'held at its initial direction',
      'gltf.light',
      glb((kit, thing) => {
        light('directional')(kit, thing);
        kit.animate(kit.scene.listChildren()[1], 'rotation', [0, 1], [0, 0, 0, 1, 0, 1, 0, 0]);
      }),
      (s) => expect(s.lights.length).toBe(1),
    ),
    leftOut(
      'instances of a skinned mesh',
      'one is shown, because all follow the same joints',
      'gltf.instances',
      glb((kit, thing) => {
        skinned(kit, thing, 0);
        const of = kit.doc.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
        thing.setExtension(
          'EXT_mesh_gpu_instancing',
          of.setAttribute('TRANSLATION', kit.values('VEC3', [0, 0, 0, 5, 0, 0])),
        );
      }),
      (s) => expect(s.objects.length).toBe(1),
    ),
    leftOut(
      'animations of anything else (`KHR_animation_pointer`)',
      'reported',
      'gltf.channel',
      json({
        extensionsUsed: ['KHR_animation_pointer'],
        accessors: [0, 0]
          .map(() => ({ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }))
          .concat({ bufferView: 0, componentType: 5126, count: 2, type: 'SCALAR' }),
        animations: [{ samplers: [{ input: 2, output: 1 }], channels: [{ sampler: 0, target: { path: 'pointer' } }] }],
      }),
    ),
    refused(
      'inconsistent keys',
      'with the animation and the numbers',
      'gltf.bad-animation',
      glb((kit, thing) => kit.animate(thing, 'translation', [0, 1], [0, 0, 0])),
    ),
    refused(
      'inconsistent joints',
      'with the numbers',
      'gltf.bad-skin',
      glb((kit, thing) => {
        skinned(kit, thing, 7);
      }),
    ),
    refused('a requested animation that does not exist', 'with those that exist', 'gltf.no-animation', json({}), {
      animation: 'Jump',
    }),
  ],
};

export const materialGroups: readonly ClaimGroup[] = [looks, lights, motion];
