import { type Mesh as ThreeMesh, Vector3 } from 'three';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { describe, expect, it } from 'vitest';
import { inWords } from '../../../tests/support/inWords.ts';
import { fromAxisAngle } from '../../math/quat.ts';
import { distance } from '../../math/vec3.ts';
import { makeMaterial, makeObject, makeScene } from '../../scene/defaults.ts';
import { box, sphere } from '../../scene/mesh/primitives.ts';
import { vertexPosition } from '../../scene/motion/motion.ts';
import { decodeImage } from '../image/decodeImage.ts';
import { writeObj } from './write.ts';

const cube = box([1, 2, 3]);
const data = Uint8Array.of(10, 20, 30, 255);
const texture = {
  name: 'dot',
  width: 1,
  height: 1,
  data,
  colorSpace: 'srgb',
  filter: 'linear',
  wrapS: 'repeat',
  wrapT: 'repeat',
} as const;
const scene = makeScene({
  name: 'still',
  upAxis: 'Z',
  materials: [
    makeMaterial({ name: '/Materials/Red paint', baseColor: [0.5, 0.25, 0.125] }),
    makeMaterial({ name: '/Materials/Red paint', baseColorTexture: texture }),
  ],
  objects: [
    makeObject({
      path: '/World/A',
      mesh: cube,
      motion: { kind: 'static', pose: { position: [10, 20, 30], orientation: fromAxisAngle([1, 2, 3], 1) } },
    }),
    makeObject({
      path: '/World/B',
      mesh: { ...cube, groups: [{ start: 0, count: cube.indices.length, material: 1 }] },
      motion: {
        kind: 'sampled',
        times: Float64Array.of(1, 2),
        poses: Float64Array.of(0, 0, 5, 0, 0, 0, 1, 9, 9, 9, 0, 0, 0, 1),
      },
    }),
  ],
  lights: [{ kind: 'dome', path: '/Sky', color: [1, 1, 1] }],
});
const text = (bytes: Uint8Array | undefined): string => new TextDecoder().decode(bytes);

describe('a scene written as OBJ', () => {
  const { files, diagnostics } = writeObj(scene, 'a.obj');

  it('has every corner at its world position, with Y up, read by three.js', () => {
    const meshes = new OBJLoader().parse(text(files.get('a.obj'))).children as ThreeMesh[];
    expect(meshes.map((m) => m.name)).toEqual(['World/A', 'World/B']);
    for (const [i, object] of scene.objects.entries()) {
      const { position, normal } = meshes[i].geometry.attributes;
      expect(position.count).toBe(cube.indices.length);
      for (const [corner, v] of cube.indices.entries()) {
        const [x, y, z] = vertexPosition(object, v, 1, 1e9);
        const p = new Vector3().fromBufferAttribute(position, corner);
        expect(distance([p.x, p.y, p.z], [x, z, -y])).toBeLessThan(1e-5);
      }
      // The edges of the first triangle are perpendicular to its normal.
      const [a, b] = [0, 1].map((k) => new Vector3().fromBufferAttribute(position, k));
      expect(b.sub(a).dot(new Vector3().fromBufferAttribute(normal, 0))).toBeCloseTo(0, 5);
    }
  });

  it('has its materials and textures, with unique names', () => {
    const library = new MTLLoader().parse(text(files.get('a.mtl')), '');
    expect(text(files.get('a.obj'))).toContain('mtllib a.mtl\n');
    expect(text(files.get('a.obj')).match(/usemtl .*/g)).toEqual([
      'usemtl Materials/Red_paint',
      'usemtl Materials/Red_paint_1',
    ]);
    expect(Object.keys(library.materialsInfo)).toEqual(['Materials/Red_paint', 'Materials/Red_paint_1']);
    expect(text(files.get('a.mtl'))).toContain('Kd 0.5 0.25 0.125\n');
    expect(text(files.get('a.mtl'))).toContain('map_Kd a_0.png\n');
    expect(decodeImage(files.get('a_0.png')!, 'a_0.png').data).toEqual(data);
  });

  it('has roughness and metalness textures in the red channel, and normal maps', () => {
    const map = { ...texture, colorSpace: 'linear' } as const;
    const written = writeObj(
      makeScene({
        name: 'a',
        materials: [
          makeMaterial({
            name: 'm',
            roughnessTexture: { texture: map, channel: 1, scale: 0.5, bias: 0.25 },
            normalTexture: { texture: map, strength: [1, 1] },
          }),
        ],
      }),
      'a.obj',
    );
    expect(text(written.files.get('a.mtl'))).toContain('Pr 1\n');
    expect(text(written.files.get('a.mtl'))).toContain('norm a_0.png\nmap_Pr a_1.png\n');
    const reds = decodeImage(written.files.get('a_1.png')!, 'a_1.png').data.filter((_, i) => i % 4 === 0);
    expect([...reds]).toEqual([...data.filter((_, i) => i % 4 === 1)].map((g) => Math.round(g / 2 + 63.75)));
  });

  it('writes meshes with more lines than a call may have arguments', () => {
    const mesh = sphere(1, { segments: 400 });
    const { files: large } = writeObj(
      makeScene({ name: 'large', objects: [makeObject({ path: '/A', mesh })] }),
      'a.obj',
    );
    expect(text(large.get('a.obj')).match(/^v /gm)).toHaveLength(mesh.positions.length / 3);
    expect(text(large.get('a.obj')).match(/^f /gm)).toHaveLength(mesh.indices.length / 3);
  });

  it('reports lost content', () => {
    expect(diagnostics.map((d) => `${d.code} ${inWords(d)}`)).toEqual([
      'convert.motion a.obj: /World/B: OBJ has no motion: it is written where it is at 1 s',
      'convert.left-out a.obj: /Sky: OBJ has no lights and no cameras; it is left out',
    ]);
  });
});
