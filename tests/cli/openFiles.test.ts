import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { decode } from 'fast-png';
import { zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { encodePng } from '../../src/formats/image/encodePng.ts';
import type { VariantSet } from '../../src/scene/types.ts';
import { GltfBuilder } from '../support/gltfBuilder.ts';
import { outputFolder, slowlight, slowlightJson } from './program.ts';

const folder = outputFolder();
const at = (name: string): string => join(folder, name);

const CAR = `#usda 1.0
( metersPerUnit = 1 )
def Xform "Car" (
    variants = { string paint = "grey" }
    prepend variantSets = "paint"
)
{
    variantSet "paint" = {
        "grey" { def Sphere "Body" {} }
        "pink" { def Sphere "Body" {} def Sphere "Bow" {} }
    }
}
`;
const text = (words: string) => new TextEncoder().encode(words);
interface Inspection {
  readonly name: string;
  readonly objects: readonly { readonly path: string; readonly motion: string }[];
  readonly variants: readonly VariantSet[];
  readonly diagnostics: readonly { readonly code: string }[];
}

test('a zip opens its first scene, or any other by name', async () => {
  const zip = zipSync({ 'a/car.usda': text(CAR), 'a/b/other.usda': text(CAR.replaceAll('"Car"', '"Bus"')) });
  writeFileSync(at('set.zip'), zip);
  expect((await slowlightJson<Inspection>('inspect', at('set.zip'))).objects[0].path).toBe('/Car/Body');
  expect((await slowlightJson<Inspection>('inspect', `${at('set.zip')}[a/b/other.usda]`)).objects[0].path).toBe(
    '/Bus/Body',
  );
  const picture = ['render', at('set.zip'), '-o', at('set.png'), '--size', '64x48'];
  expect((await slowlight(...picture, '--pipeline', 'reference', '--samples', '1')).code).toBe(0);
  const missing = await slowlight('inspect', `${at('set.zip')}[no.usda]`);
  expect([missing.code, missing.err]).toEqual([3, expect.stringMatching(/no such file; there is .*car\.usda/)]);
});

test('a panorama is a scene, which becomes a dome; six faces in a zip are one', async () => {
  const picture = encodePng(32, 16, new Uint8Array(4 * 32 * 16).fill(200));
  writeFileSync(at('sky.png'), picture);
  const drawn = ['render', at('sky.png'), '-o', at('sky-seen.png'), '--size', '32x24', '--beta', '0,0,-0.9'];
  expect((await slowlight(...drawn, '--pipeline', 'reference', '--samples', '1')).code).toBe(0);
  expect((await slowlight('convert', at('sky.png'), at('sky.usda'))).code).toBe(0);
  expect(readFileSync(at('sky.usda'), 'utf8')).toContain('inputs:texture:file = @textures/sky.png@');
  const names = ['right', 'left', 'top', 'bottom', 'front', 'back'];
  const face = encodePng(4, 4, new Uint8Array(64).fill(255));
  writeFileSync(at('faces.zip'), zipSync(Object.fromEntries(names.map((name) => [`cube/${name}.png`, face]))));
  expect((await slowlightJson<Inspection>('inspect', at('faces.zip'))).diagnostics).toEqual([]);
  writeFileSync(at('photo.png'), face);
  const refused = await slowlight('inspect', at('photo.png'));
  expect([refused.code, refused.err]).toEqual([3, expect.stringMatching(/4 × 4 pixels, and no panorama/)]);
});

test('a zip without a scene, a file that is no zip and a missing one are rejected', async () => {
  writeFileSync(at('empty.zip'), zipSync({ 'a.txt': text('x'), 'b.txt': text('y') }));
  writeFileSync(at('bad.zip'), 'PK, but no zip');
  mkdirSync(at('folder.zip'));
  for (const [name, about] of [
    ['empty', /none of its 2 files/],
    ['bad', /no directory/],
    ['gone', /no such file/],
    ['folder', /is a folder/],
  ] as const) {
    const { code, err } = await slowlight('inspect', at(`${name}.zip`));
    expect([code, err]).toEqual([3, expect.stringMatching(about)]);
  }
});

test('a missing file and a missing folder are reported', async () => {
  for (const path of ['none.usda', 'none/car.usda']) {
    const { code, err } = await slowlight('inspect', at(path));
    expect([code, err]).toEqual([3, expect.stringMatching(/(none|car)\.usda: no such file/)]);
  }
});

test('variants are listed, and can be chosen', async () => {
  writeFileSync(at('car.usda'), CAR);
  const usual = await slowlightJson<Inspection>('inspect', at('car.usda'));
  expect(usual.variants).toEqual([{ set: '/Car{paint}', options: ['grey', 'pink'], chosen: 'grey' }]);
  const pink = await slowlightJson<Inspection>('inspect', at('car.usda'), '--variant', '/Car{paint}=pink');
  expect(pink.objects.map(({ path }) => path)).toEqual(['/Car/Body', '/Car/Bow']);
  expect((await slowlight('inspect', at('car.usda'))).out).toContain('/Car{paint}: [grey], pink');
  expect((await slowlight('inspect', at('car.usda'), '--variant', 'pink')).code).toBe(2);
  const probed = await slowlight('probe', at('car.usda'), '--prim', '/Car/Bow', '--variant', '/Car{paint}=pink');
  expect(probed.code).toBe(0);
  expect((await slowlight('convert', at('car.usda'), at('pink.obj'), '--variant', '/Car{paint}=pink')).code).toBe(0);
});

test('animations are listed, and can be chosen by name or number', async () => {
  const kit = new GltfBuilder();
  const node = kit.meshNode('A', kit.triangle([0, 0, 0, 1, 0, 0, 0, 1, 0]));
  kit.scene.addChild(node);
  kit.animate(node, 'translation', [0, 1], [0, 0, 0, 5, 0, 0]);
  const still = kit.doc.createAnimationSampler().setInput(kit.values('SCALAR', [0, 1]));
  still.setOutput(kit.values('VEC3', [1, 1, 1, 1, 1, 1]));
  const channel = kit.doc.createAnimationChannel().setTargetNode(node).setTargetPath('translation').setSampler(still);
  kit.doc.createAnimation('Stay').addSampler(still).addChannel(channel);
  writeFileSync(at('two.glb'), await kit.glb());
  const motion = async (...flags: string[]) =>
    (await slowlightJson<Inspection>('inspect', at('two.glb'), ...flags)).objects[0].motion;
  expect((await slowlightJson<Inspection>('inspect', at('two.glb'))).variants).toEqual([
    { set: 'animation', options: ['Move', 'Stay'], chosen: 'Move' },
  ]);
  expect(await motion()).toBe('sampled');
  for (const flags of [
    ['--animation', 'Stay'],
    ['--animation', '1'],
    ['--variant', 'animation=Stay'],
  ])
    expect(await motion(...flags)).toBe('static');
  expect((await slowlight('inspect', at('two.glb'), '--animation', 'run')).code).toBe(3);
});

const MOVER = `#usda 1.0
( metersPerUnit = 1
  startTimeCode = 0
  endTimeCode = 48
  customLayerData = { dictionary slowlight = { double speedOfLight = 10 } } )
def Cube "Box" { double size = 1 }
def Cube "Mover"
{
    double size = 1
    double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 48: (6, 0, 0) }
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
`;
interface Changed extends Inspection {
  readonly startTime: number;
  readonly endTime: number;
  readonly fastest: { readonly path: string; readonly speed: number };
}

test('an animation can be retimed, and resulting speeds above c are reported', async () => {
  writeFileSync(at('mover.usda'), MOVER);
  const changed = await slowlightJson<Changed>(
    'inspect',
    at('mover.usda'),
    '--speed-factor',
    '2',
    '--start-offset',
    '3',
  );
  expect([changed.startTime, changed.endTime]).toEqual([3, 4]);
  expect(changed.fastest).toMatchObject({ path: '/Mover', speed: 6 });
  const tooFast = await slowlight('inspect', at('mover.usda'), '--speed-factor', '4');
  expect([tooFast.code, tooFast.out]).toEqual([3, expect.stringContaining('1.20 c')]);
});

test('objects can be given a flight at a chosen fraction of c', async () => {
  const flying = ['--fly', '/Box=0,0.8,0@1', '--fly', '/Mover=0.5,0,0'];
  const scene = await slowlightJson<Changed>('inspect', at('mover.usda'), ...flying, '--c', '100');
  expect(scene.fastest).toMatchObject({ path: '/Box', speed: 80 });
  expect(scene.objects.map(({ motion }) => motion)).toEqual(['uniform', 'uniform']);
  interface Probed {
    readonly vertices: readonly { readonly velocity: readonly number[]; readonly position: readonly number[] }[];
  }
  const height = async (shape: string) => {
    const flags = ['--prim', '/Box', '--view', 'galilean', '--time', '1', '--fly-shape', shape];
    const { vertices } = await slowlightJson<Probed>('probe', at('mover.usda'), ...flying, ...flags);
    const ys = vertices.map(({ position }) => position[1]);
    return Math.max(...ys) - Math.min(...ys);
  };
  expect(await height('world')).toBeCloseTo(1, 9);
  expect(await height('rest')).toBeCloseTo(0.6, 9);
  expect((await slowlight('inspect', at('mover.usda'), '--fly', '/None=0.5,0,0')).code).toBe(2);
  expect((await slowlight('inspect', at('mover.usda'), '--fly', '/Box=1,0,0')).code).toBe(2);
  expect((await slowlight('inspect', at('mover.usda'), '--fly', '/Box')).code).toBe(2);
});

test('WebGL draws a changed scene out of a zip', async () => {
  writeFileSync(at('mover.zip'), zipSync({ 'mover.usda': text(MOVER) }));
  const flags = ['--size', '96x64', '--fly', '/Box=0,0,-0.9@0', '--backend'];
  const pixels = async (backend: string) => {
    const file = at(`${backend}.png`);
    const { code, err } = await slowlight('render', at('mover.zip'), '-o', file, ...flags, backend);
    expect(code, err).toBe(0);
    return Uint8Array.from(decode(readFileSync(file)).data);
  };
  const [gl, gpu] = [await pixels('webgl'), await pixels('webgpu')];
  const difference = gl.reduce((sum, x, i) => sum + Math.abs(x - gpu[i]), 0) / gl.length;
  expect(difference).toBeLessThan(1);
});
