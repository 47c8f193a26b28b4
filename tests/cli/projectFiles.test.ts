import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { add, build, connect, set } from '../support/graphKit.ts';
import { outputFolder, scene, slowlight } from './program.ts';

const folder = outputFolder();
const boxes = build(
  ...[add('box', 'box'), add('a', 'write-usd'), add('b', 'write-usd'), set('b', 'name', 'other.usdz')],
  ...[connect('box.geometry', 'a.geometry'), connect('a.geometry', 'b.geometry')],
);
const project = join(folder, 'boxes.slowlight.json');
writeFileSync(project, serializeDocument(boxes));
const into = join(folder, 'made');
mkdirSync(into);

test('the files requested by a project are written to the given folder', async () => {
  const { code, out, err } = await slowlight('render', project, '--folder', into, '--set', 'box.width=3', '--json');
  expect(code, err).toBe(0);
  expect(JSON.parse(out)).toEqual({ files: ['geometry.usda', 'other.usdz'].map((name) => join(into, name)) });
  expect(readFileSync(join(into, 'geometry.usda'), 'utf8')).toContain('(-1.5, -0.5, ');
});

test.each([
  ['two of one name', [project, '--set', 'b.name=geometry.usda'], 3, /two nodes write geometry\.usda/],
  ['a way out of the folder', [project, '--set', 'b.name=../x.usda'], 3, /b\.name: .*without folders/],
  ['no folder', [project, '--folder', join(folder, 'nowhere')], 3, /there is no folder/],
  ['a scene without -o', [scene('movers.usda')], 2, /-o/],
  ['a folder beside -o', [project, '-o', 'a.png', '--folder', into], 2, /--folder/],
])('nothing is written: %s', async (_, args, expectedCode, message) => {
  const before = readdirSync(into);
  const { code, err } = await slowlight('render', ...args, ...(args.includes('--folder') ? [] : ['--folder', into]));
  expect(code, err).toBe(expectedCode);
  expect(err).toMatch(message);
  expect(readdirSync(into)).toEqual(before);
});
