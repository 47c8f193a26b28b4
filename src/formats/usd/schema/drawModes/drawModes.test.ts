import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../../math/vec3.ts';
import type { Scene, SceneObject } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { encodePng } from '../../../image/encodePng.ts';
import type { ReadOptions } from '../../../readOptions.ts';
import { readUsd } from '../../read.ts';

const PICTURE = encodePng(1, 1, Uint8Array.of(255, 0, 0, 255));
const read = (prims: string, options?: ReadOptions): Promise<Scene> =>
  readUsd(
    memorySource({
      'a.usda': new TextEncoder().encode(`#usda 1.0\n( metersPerUnit = 1 )\n${prims}\n`),
      'p.png': PICTURE,
    }),
    'a.usda',
    options,
  );
const model = (said: string, body = 'def Sphere "S" { float3[] extent = [(0, 0, 0), (2, 4, 6)] }'): string =>
  `def Xform "M" ( kind = "component" ) {\n${said}\n${body}\n}`;
const cards = (said: string): Promise<Scene> => read(model(`uniform token model:drawMode = "cards"\n${said}`));
const named = ({ objects }: Scene, name: string): SceneObject => objects.find(({ path }) => path === `/M/${name}`)!;

/** The place of a picture's point on a card whose positions are linear in its uvs. */
function placeOf({ mesh: { positions, uvs } }: SceneObject, s: number, t: number): Vec3 {
  for (let i = 0; 2 * i < uvs.length; i++)
    if (uvs[2 * i] === s && uvs[2 * i + 1] === t) return [positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]];
  throw new Error(`no corner ${s}, ${t}`);
}

describe('cards', () => {
  it('are six faces in the colour of the model, where it has no pictures', async () => {
    const scene = await cards('uniform token model:cardGeometry = "box"\nfloat3 model:drawModeColor = (0.25, 0.5, 1)');
    expect(scene.objects.map(({ path }) => path)).toEqual(
      ['XPos', 'XNeg', 'YPos', 'YNeg', 'ZPos', 'ZNeg'].map((side) => `/M/card${side}`),
    );
    for (const { mesh } of scene.objects)
      expect(scene.materials[mesh.groups[0]!.material]!.baseColor).toEqual([0.25, 0.5, 1]);
    // Outwards, from the middle of the box.
    for (const { mesh } of scene.objects) {
      const out = [0, 1, 2].map((k) => mesh.positions[k]! - [1, 2, 3][k]!);
      expect(out.reduce((sum, x, k) => sum + x * mesh.normals[k]!, 0)).toBeGreaterThan(0);
    }
  });

  it('show pictures upright and as seen from outside', async () => {
    const sides = ['XPos', 'XNeg', 'YPos', 'YNeg', 'ZPos', 'ZNeg'];
    const scene = await cards(
      `uniform token model:cardGeometry = "box"\n${sides.map((side) => `asset model:cardTexture${side} = @p.png@`).join('\n')}`,
    );
    // The lower left and the upper right of the picture. For sides z is up; for the top, y.
    expect(placeOf(named(scene, 'cardXPos'), 0, 0)).toEqual([2, 0, 0]);
    expect(placeOf(named(scene, 'cardXPos'), 1, 1)).toEqual([2, 4, 6]);
    expect(placeOf(named(scene, 'cardXNeg'), 0, 0)).toEqual([0, 4, 0]);
    expect(placeOf(named(scene, 'cardYPos'), 0, 0)).toEqual([2, 4, 0]);
    expect(placeOf(named(scene, 'cardYNeg'), 0, 0)).toEqual([0, 0, 0]);
    expect(placeOf(named(scene, 'cardZPos'), 0, 0)).toEqual([0, 0, 6]);
    expect(placeOf(named(scene, 'cardZPos'), 1, 1)).toEqual([2, 4, 6]);
    // Seen from below, with y down: on the right x is greatest, and above y is least.
    expect(placeOf(named(scene, 'cardZNeg'), 1, 1)).toEqual([2, 0, 0]);
    const { material } = named(scene, 'cardXPos').mesh.groups[0]!;
    expect(scene.materials[material]).toMatchObject({ opacityThreshold: expect.closeTo(0.1, 6) });
    expect(scene.materials[material]!.baseColorTexture).toBeDefined();
  });

  it('cross in the middle, and borrow the mirrored picture of the other side', async () => {
    const scene = await cards('asset model:cardTextureYNeg = @p.png@');
    expect(scene.objects.map(({ path }) => path)).toEqual(['/M/cardYPos', '/M/cardYNeg']);
    expect(placeOf(named(scene, 'cardYNeg'), 0, 0)).toEqual([0, 2, 0]);
    // At the same place, seen from behind.
    expect(placeOf(named(scene, 'cardYPos'), 0, 0)).toEqual([0, 2, 0]);
    expect(placeOf(named(scene, 'cardYPos'), 1, 1)).toEqual([2, 2, 6]);
  });

  it('from textures are not read, which is told', async () => {
    const { diagnostics, objects } = await cards('uniform token model:cardGeometry = "fromTexture"');
    expect(objects).toHaveLength(6);
    expect(diagnostics.map(({ code }) => code)).toContain('usd.draw-mode');
  });
});

describe('lines', () => {
  it('along the axes have length 1', async () => {
    const { objects } = await read(model('uniform token model:drawMode = "origin"'));
    expect(objects.map(({ path }) => path)).toEqual(['/M/origin']);
    const { positions } = objects[0]!.mesh;
    for (const k of [0, 1, 2]) {
      const along = [...positions].filter((_, i) => i % 3 === k);
      expect(Math.max(...along)).toBeCloseTo(1, 1);
      expect(Math.min(...along)).toBeCloseTo(0, 1);
    }
  });
});

it('what has no size is drawn as it is, which is told', async () => {
  const { objects, diagnostics } = await read(
    model('uniform token model:drawMode = "bounds"', 'def Xform "Empty" {}\ndef Camera "Eye" {}') +
      '\ndef Cube "Rest" {}',
  );
  expect(objects.map(({ path }) => path)).toEqual(['/Rest']);
  expect(diagnostics.map(({ code }) => code)).toContain('usd.draw-mode');
});

it('a prim inside of a model is read as it is, when it is asked for', async () => {
  const bounds = model('uniform token model:drawMode = "bounds"', 'def Sphere "S" {}');
  const pathsOf = async (prim: string) => (await read(bounds, { prim })).objects.map(({ path }) => path);
  expect(await pathsOf('/M/S')).toEqual(['/M/S']);
  expect(await pathsOf('/M')).toEqual(['/M/bounds']);
});

it('native instances of a model, and prototypes of an instancer, each have their stand-in', async () => {
  const chair = `class "Chair" ( kind = "component" ) { uniform token model:drawMode = "bounds"\ndef Cube "Seat" { double size = 2 } }`;
  const place = (at: string) =>
    `double3 xformOp:translate = ${at}\nuniform token[] xformOpOrder = ["xformOp:translate"]`;
  const instance = (name: string, at: string) =>
    `def Xform "${name}" ( instanceable = true\nprepend inherits = </Chair> ) { ${place(at)} }`;
  const crowd = `def PointInstancer "Crowd" ( kind = "group" ) {
    int[] protoIndices = [0, 0]
    point3f[] positions = [(0, 9, 0), (5, 9, 0)]
    rel prototypes = </Crowd/Kind>
    ${instance('Kind', '(0, 0, 0)')}
  }`;
  const { objects } = await read([chair, instance('A', '(1, 0, 0)'), instance('B', '(7, 0, 0)'), crowd].join('\n'));
  const places = objects.map(({ path, motion }) => [path, motion.kind === 'static' && motion.pose.position]);
  expect(places).toEqual([
    ['/A/bounds', [1, 0, 0]],
    ['/B/bounds', [7, 0, 0]],
    [expect.stringContaining('Crowd'), [0, 9, 0]],
    [expect.stringContaining('Crowd'), [5, 9, 0]],
  ]);
  expect(new Set(objects.map(({ mesh }) => mesh.positions.length)).size).toBe(1);
});
