import { EXTMeshGPUInstancing, KHRLightsPunctual, KHRMaterialsVariants } from '@gltf-transform/extensions';
import { AnimationMixer, type InstancedMesh, Matrix4, Vector3 } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { describe, expect, it } from 'vitest';
import { find, GltfBuilder } from '../../../tests/support/gltfBuilder.ts';
import { inWords } from '../../../tests/support/inWords.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { random } from '../../math/random.ts';
import { distance } from '../../math/vec3.ts';
import { inEnglish } from '../../messages/message.ts';
import { vertexPosition } from '../../scene/motion/motion.ts';
import { memorySource } from '../files/fileSource.ts';
import { readGltf } from './index.ts';

describe('KHR_materials_variants', () => {
  /** A shoe, red by default; the sole has no variants. */
  function shoe(): GltfBuilder {
    const kit = new GltfBuilder();
    const variants = kit.doc.createExtension(KHRMaterialsVariants);
    const [beach, street] = ['beach', 'street'].map((name) => variants.createVariant(name));
    const material = (name: string) => kit.doc.createMaterial(name);
    const mapping = (name: string, ...of: (typeof beach)[]) => {
      const made = variants.createMapping().setMaterial(material(name));
      for (const variant of of) made.addVariant(variant);
      return made;
    };
    const list = variants.createMappingList().addMapping(mapping('blue', beach)).addMapping(mapping('grey', street));
    const upper = kit.triangle().setMaterial(material('red')).setExtension('KHR_materials_variants', list);
    const sole = kit.triangle().setMaterial(material('white'));
    kit.scene.addChild(kit.meshNode('Shoe', upper, sole));
    return kit;
  }

  it.each([
    [undefined, '', 'red'],
    ['beach', 'beach', 'blue'],
    ['street', 'street', 'grey'],
  ])('with the variant %s uses %s in %s', async (asked, chosen, name) => {
    const scene = await shoe().read(asked === undefined ? {} : { variants: new Map([['material', asked]]) });
    expect(scene.variants).toEqual([{ set: 'material', options: ['beach', 'street'], chosen }]);
    const { groups } = find(scene, '/Shoe').mesh;
    expect(groups.map((group) => scene.materials[group.material].name)).toEqual([name, 'white']);
    expect(scene.diagnostics).toEqual([]);
  });

  it('rejects missing variants, and lists the existing ones', async () => {
    const variants = new Map([['material', 'moon']]);
    await expect(shoe().read({ variants })).rejects.toThrow('a.glb: no variant moon of its materials; there are beach');
    const plain = new GltfBuilder();
    plain.scene.addChild(plain.meshNode('Plain', plain.triangle()));
    await expect(plain.read({ variants })).rejects.toThrow('no variant moon of its materials; the file has none');
    expect((await plain.read({ variants: new Map([['/Car{paint}', 'red']]) })).variants).toBeUndefined();
  });

  it('rejects references to missing variants', async () => {
    const json = {
      asset: { version: '2.0' },
      extensionsUsed: ['KHR_materials_variants'],
      extensions: { KHR_materials_variants: { variants: [{ name: 'a' }] } },
      materials: [{}],
      meshes: [
        {
          primitives: [
            { attributes: {}, extensions: { KHR_materials_variants: { mappings: [{ material: 0, variants: [1] }] } } },
          ],
        },
      ],
    };
    const files = memorySource({ 'a.gltf': new TextEncoder().encode(JSON.stringify(json)) });
    await expect(readGltf(files, 'a.gltf')).rejects.toThrow('mesh 0: refers to variants 1, of which there are 1');
  });
});

describe('EXT_mesh_gpu_instancing', () => {
  const COUNT = 7;
  function trees(next: () => number, isStill: boolean): GltfBuilder {
    const kit = new GltfBuilder();
    const many = (f: () => readonly number[]): number[] => Array.from({ length: COUNT }, f).flat();
    const batch = kit.doc
      .createExtension(EXTMeshGPUInstancing)
      .createInstancedMesh()
      .setAttribute(
        'TRANSLATION',
        kit.values(
          'VEC3',
          many(() => [4 * next(), next(), 4 * next()]),
        ),
      )
      .setAttribute(
        'ROTATION',
        kit.values(
          'VEC4',
          many(() => fromAxisAngle([next(), 1, next()], 6 * next())),
        ),
      )
      .setAttribute(
        'SCALE',
        kit.values(
          'VEC3',
          many(() => [0.5 + next(), 1 + next(), 1]),
        ),
      );
    const node = kit.meshNode('Tree', kit.triangle([0, 0, 0, 1, 0, 0, 0, 2, 1]));
    node.setExtension('EXT_mesh_gpu_instancing', batch).setTranslation([1, 2, 3]).setScale([2, 2, 2]);
    kit.scene.addChild(node);
    if (!isStill) {
      kit.animate(node, 'translation', [0, 1, 2], [0, 0, 0, 3, 1, 0, 0, 0, 4]);
      kit.animate(node, 'rotation', [0, 2], [0, 0, 0, 1, ...fromAxisAngle([0, 1, 0], 2)]);
    }
    return kit;
  }

  it.each([true, false])('places instances as in three.js (at rest: %s)', async (isStill) => {
    const glb = await trees(random(5), isStill).glb();
    const scene = await readGltf(memorySource({ 'a.glb': glb }), 'a.glb', { chordTolerance: 1e-5 });
    const gltf = await new GLTFLoader().parseAsync(glb.slice().buffer, '');
    const mixer = new AnimationMixer(gltf.scene);
    if (!isStill) mixer.clipAction(gltf.animations[0]).play();
    let instanced: InstancedMesh | undefined;
    gltf.scene.traverse((thing) => {
      if ('isInstancedMesh' in thing) instanced = thing as InstancedMesh;
    });
    expect(scene.objects.map((o) => o.path)).toEqual(Array.from({ length: COUNT }, (_, i) => `/Tree/Instance${i}`));
    let worst = 0;
    for (const t of [0, 0.3, 1.1, 1.9]) {
      mixer.setTime(t);
      gltf.scene.updateMatrixWorld(true);
      for (const [i, object] of scene.objects.entries()) {
        const matrix = new Matrix4();
        instanced!.getMatrixAt(i, matrix);
        for (let v = 0; v < 3; v++) {
          const p = new Vector3().fromBufferAttribute(instanced!.geometry.attributes.position, v).applyMatrix4(matrix);
          p.applyMatrix4(instanced!.matrixWorld);
          worst = Math.max(worst, distance([p.x, p.y, p.z], vertexPosition(object, v, t, 1e9)));
        }
      }
    }
    expect(worst).toBeLessThan(1e-4);
  });

  it('instances of equal scale share their mesh', async () => {
    const kit = new GltfBuilder();
    const places = kit.values('VEC3', [0, 0, 0, 5, 0, 0, 9, 0, 0]);
    const sizes = kit.values('VEC3', [1, 1, 1, 2, 2, 2, 2, 2, 2]);
    const batch = kit.doc.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
    batch
      .setAttribute('TRANSLATION', places)
      .setAttribute('SCALE', sizes)
      .setAttribute('_ID', kit.ints('SCALAR', [1, 2, 3]));
    kit.scene.addChild(kit.meshNode('Stone', kit.triangle()).setExtension('EXT_mesh_gpu_instancing', batch));
    const { objects, diagnostics } = await kit.read();
    expect(objects[1].mesh).toBe(objects[2].mesh);
    expect(objects[0].mesh).not.toBe(objects[1].mesh);
    expect(objects[2].motion).toMatchObject({ kind: 'static', pose: { position: [9, 0, 0] } });
    expect(diagnostics.map((d) => inEnglish(d.message))).toEqual(['_ID of its instances are left out']);
  });

  it('rejects attributes of different lengths', async () => {
    const kit = new GltfBuilder();
    const batch = kit.doc.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
    batch.setAttribute('TRANSLATION', kit.values('VEC3', [0, 0, 0, 5, 0, 0]));
    batch.setAttribute('SCALE', kit.values('VEC3', [1, 1, 1]));
    kit.scene.addChild(kit.meshNode('Stone', kit.triangle()).setExtension('EXT_mesh_gpu_instancing', batch));
    await expect(kit.read()).rejects.toThrow('/Stone: SCALE of its instances has 1 of VEC3, for 2; export it again');
  });
});

describe('unsupported content is reported', () => {
  it('of lights and cameras', async () => {
    const kit = new GltfBuilder();
    const spot = kit.doc.createExtension(KHRLightsPunctual).createLight('Spot').setType('spot').setRange(12);
    kit.scene.addChild(kit.meshNode('Floor', kit.triangle()));
    kit.scene.addChild(kit.doc.createNode('Spot').setExtension('KHR_lights_punctual', spot));
    const flat = kit.doc.createCamera('Flat').setType('orthographic');
    const wide = kit.doc.createCamera('Wide').setType('perspective').setYFov(4);
    kit.scene.addChild(kit.doc.createNode('Flat').setCamera(flat)).addChild(kit.doc.createNode('Wide').setCamera(wide));
    const { cameras, lights, diagnostics } = await kit.read();
    expect(cameras).toEqual([]);
    expect(lights).toMatchObject([{ kind: 'sphere', shaping: { inner: 0, outer: Math.PI / 4, focus: 0 } }]);
    expect(diagnostics.map(inWords)).toEqual([
      'a.glb: /Spot: its range of 12 m is left out: light goes on for ever',
      'a.glb: /Flat: an orthographic camera is not read; it is left out',
      'a.glb: /Wide: its field of view is 4 rad; it is left out',
    ]);
  });

  it('of colours that are not opaque', async () => {
    const alpha = async (mode: 'OPAQUE' | 'BLEND', last: number): Promise<string[]> => {
      const kit = new GltfBuilder();
      const colors = kit.values('VEC4', [1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, last]);
      const glass = kit
        .triangle()
        .setAttribute('COLOR_0', colors)
        .setMaterial(kit.doc.createMaterial().setAlphaMode(mode));
      kit.scene.addChild(kit.meshNode('Glass', glass));
      return (await kit.read()).diagnostics.map(inWords);
    };
    expect(await alpha('BLEND', 0.5)).toEqual(['a.glb: mesh Glass: the opacity of its vertex colours is left out']);
    expect([...(await alpha('BLEND', 1)), ...(await alpha('OPAQUE', 0.5))]).toEqual([]);
  });
});
