import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { hasUsdCore } from '../usdCore.ts';
import { outcome, outputFolder, scene, slowlight, slowlightJson, startIn } from './program.ts';

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

test('USD becomes glTF, OBJ and USD again', async () => {
  const before = await slowlightJson<Inspection>('inspect', scene('movers.usda'));
  for (const name of ['a.glb', 'a.gltf', 'b.usda', 'b.usdz']) {
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

test('glTF becomes USD', async () => {
  await slowlight('convert', scene('movers.usda'), out('d.glb'));
  const before = await slowlightJson<Inspection>('inspect', out('d.glb'));
  await slowlight('convert', out('d.glb'), out('d.usda'));
  const after = await slowlightJson<Inspection>('inspect', out('d.usda'));
  expect(after.objects).toEqual(before.objects);
});

test.runIf(hasUsdCore())('a binary USD is what the text is', async () => {
  expect((await slowlight('convert', scene('movers.usda'), out('e.usdc'))).code).toBe(0);
  expect(readFileSync(out('e.usdc')).subarray(0, 8).toString()).toBe('PXR-USDC');
  await slowlight('convert', scene('movers.usda'), out('e.usda'));
  const [binary, text] = [
    await slowlightJson<Inspection>('inspect', out('e.usdc')),
    await slowlightJson<Inspection>('inspect', out('e.usda')),
  ];
  expect(binary.objects).toEqual(text.objects);
});

test('without usd-core a binary USD is refused, and how to get it is told', async () => {
  const env = { ...process.env, SLOWLIGHT_PYTHON: join(folder, 'no-python') };
  const { code, err } = await outcome(startIn(env, 'convert', scene('movers.usda'), out('f.usdc')));
  expect(code).toBe(4);
  expect(err).toMatch(/pip install usd-core.*SLOWLIGHT_PYTHON.*\.usda or \.usdz/);
  expect(existsSync(out('f.usdc'))).toBe(false);
});

test('what cannot be written is refused, and nothing of others is written over', async () => {
  const unknown = await slowlight('convert', scene('movers.usda'), out('a.fbx'));
  expect(unknown.code).toBe(2);
  expect(unknown.err).toContain('.glb, .obj, .usdc, not as .fbx');
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
