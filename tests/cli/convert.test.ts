import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { hasUsdCore, python } from '../support/pythonOracles.ts';
import { outputFolder, scene, slowlight, slowlightJson } from './program.ts';

const folder = outputFolder();
const out = (name: string): string => join(folder, name);

interface Conversion {
  readonly files: string[];
  readonly diagnostics: { code: string; place: string }[];
}
interface Inspection {
  readonly fastest: { path: string; speed: number };
  readonly objects: { path: string; motion: string; triangles: number }[];
  readonly cameras: { path: string }[];
}

test('USD is converted to glTF, OBJ and USD', async () => {
  const before = await slowlightJson<Inspection>('inspect', scene('movers.usda'));
  for (const name of ['a.glb', 'a.gltf', 'b.usda', 'b.usdc', 'b.usdz']) {
    const { files } = await slowlightJson<Conversion>('convert', scene('movers.usda'), out(name));
    expect(files[0]).toBe(out(name));
    expect(files.every(existsSync)).toBe(true);
    const after = await slowlightJson<Inspection>('inspect', out(name));
    expect(after.objects.map((o) => [o.path, o.triangles])).toEqual(before.objects.map((o) => [o.path, o.triangles]));
    expect(after.cameras.map((o) => o.path)).toEqual(before.cameras.map((o) => o.path));
    expect(after.fastest.path).toBe(before.fastest.path);
    expect(after.fastest.speed).toBeCloseTo(before.fastest.speed, 5);
  }
  const { code, err } = await slowlight('convert', out('a.glb'), out('c.obj'));
  expect(code, err).toBe(0);
  expect(err).toMatch(/^warning: c\.obj: \/World\/\S+: OBJ has no motion/m);
  expect(readFileSync(out('c.obj'), 'utf8').match(/^f /gm)).toHaveLength(36);
});

test('glTF is converted to USD', async () => {
  await slowlight('convert', scene('movers.usda'), out('d.glb'));
  const before = await slowlightJson<Inspection>('inspect', out('d.glb'));
  await slowlight('convert', out('d.glb'), out('d.usda'));
  const after = await slowlightJson<Inspection>('inspect', out('d.usda'));
  expect(after.objects).toEqual(before.objects);
});

test('binary USD equals the text', async () => {
  const report = await slowlightJson<Conversion>('convert', scene('movers.usda'), out('e.usdc'));
  expect(report.files).toEqual([out('e.usdc')]);
  expect(readFileSync(out('e.usdc')).subarray(0, 8).toString()).toBe('PXR-USDC');
  await slowlight('convert', scene('movers.usda'), out('e.usda'));
  const [binary, text] = [
    await slowlightJson<Inspection>('inspect', out('e.usdc')),
    await slowlightJson<Inspection>('inspect', out('e.usda')),
  ];
  expect(binary.objects).toEqual(text.objects);
});

test.runIf(hasUsdCore())('Pixar’s own programs have the same stage in text, binary and package', async () => {
  const names = ['f.usda', 'f.usdc', 'f.usdz'];
  for (const name of names) expect((await slowlight('convert', scene('movers.usda'), out(name))).code).toBe(0);
  const flattened = `
import sys
from pxr import Usd
for path in sys.argv[1:]:
    text = Usd.Stage.Open(path).Flatten().ExportToString()
    print(repr(text.split('doc = """')[0] + text.split('"""')[-1]))`;
  const [text, ...others] = python('-c', flattened, ...names.map(out))
    .trim()
    .split('\n');
  expect(text.length).toBeGreaterThan(1000);
  for (const other of others) expect(other).toBe(text);
});

test('unwritable output is rejected, and other files are not overwritten', async () => {
  const unknown = await slowlight('convert', scene('movers.usda'), out('a.fbx'));
  expect(unknown.code).toBe(2);
  expect(unknown.err).toContain('.glb, .obj, not as .fbx');
  expect((await slowlight('convert', out('nothing.usda'), out('g.glb'))).code).toBe(3);
  expect((await slowlight('convert', scene('movers.usda'), join(folder, 'no', 'g.glb'))).code).toBe(3);
  const same = await slowlight('convert', scene('movers.usda'), scene('movers.usda'));
  expect(same.code).toBe(2);
  expect(same.err).toContain('over itself');
  const own = join(folder, 'own');
  mkdirSync(own);
  writeFileSync(join(own, 'h.mtl'), 'mine');
  const taken = await slowlight('convert', scene('movers.usda'), join(own, 'h.obj'));
  expect(taken.code).toBe(3);
  expect(taken.err).toContain('h.mtl is there already');
  expect(readFileSync(join(own, 'h.mtl'), 'utf8')).toBe('mine');
  expect(existsSync(join(own, 'h.obj'))).toBe(false);
});

test('chosen variants are written, with the author’s viewing suggestions', async () => {
  writeFileSync(
    out('car.usda'),
    `#usda 1.0
( metersPerUnit = 1; customLayerData = { dictionary slowlight = { double speedOfLight = 10; string title = "Street" } } )
def "Car" ( variants = { string body = "box" }; prepend variantSets = "body" ) {
  variantSet "body" = { "box" { def Cube "Box" {} } "ball" { def Sphere "Ball" {} } }
}
`,
  );
  expect((await slowlight('convert', out('car.usda'), out('car.glb'), '--variant', '/Car{body}=ball')).code).toBe(0);
  const car = await slowlightJson<Inspection & { title: string; speedOfLight: number }>('inspect', out('car.glb'));
  expect(car).toMatchObject({ title: 'Street', speedOfLight: 10, objects: [{ path: '/Car/Ball' }] });

  writeFileSync(out('two.gltf'), twoAnimations());
  expect((await slowlight('convert', out('two.gltf'), out('two.usda'), '--animation', 'Slide')).code).toBe(0);
  const { fastest } = await slowlightJson<Inspection>('inspect', out('two.usda'));
  expect(fastest.speed).toBeCloseTo(3, 5);
});

/** A triangle at rest in one animation; in the other it moves 3 m in 1 s. */
function twoAnimations(): string {
  const numbers = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0);
  const values = (from: number, count: number, type: string) => ({
    bufferView: 0,
    byteOffset: 4 * from,
    componentType: 5126,
    count,
    type,
  });
  const animation = (name: string, output: number) => ({
    name,
    samplers: [{ input: 1, output }],
    channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }],
  });
  return JSON.stringify({
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'Thing', mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    animations: [animation('Rest', 2), animation('Slide', 3)],
    accessors: [values(0, 3, 'VEC3'), values(9, 2, 'SCALAR'), values(11, 2, 'VEC3'), values(17, 2, 'VEC3')],
    bufferViews: [{ buffer: 0, byteLength: 4 * numbers.length }],
    buffers: [
      {
        byteLength: 4 * numbers.length,
        uri: `data:application/octet-stream;base64,${Buffer.from(numbers.buffer).toString('base64')}`,
      },
    ],
  });
}
