import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { outputFolder, scene, slowlight } from './program.ts';

const folder = outputFolder();
const movers = scene('movers.usda');

test('help and version', async () => {
  const help = await slowlight('--help');
  expect(help.code).toBe(0);
  for (const word of ['render', 'probe', 'inspect', 'compare', 'serve', '130']) expect(help.out).toContain(word);
  const { version } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8')) as {
    version: string;
  };
  expect((await slowlight('--version')).out.trim()).toBe(version);
});

test('a pipe closed early is not an error', () => {
  const program = fileURLToPath(new URL('../../bin/slowlight.js', import.meta.url));
  const { stderr } = spawnSync('sh', ['-c', `'${process.execPath}' '${program}' render --help | true`], {
    encoding: 'utf8',
  });
  expect(stderr).not.toContain('EPIPE');
});

const out = (name: string): string => join(folder, name);

test.each([
  ['no command', ['paint'], 2, 'paint'],
  ['an unknown flag', ['inspect', movers, '--fast'], 2, '--fast'],
  ['the speed of light as a velocity', ['render', movers, '-o', out('a.png'), '--beta', '1,0,0'], 2, 'speed of light'],
  ['a format that is not written', ['render', movers, '-o', out('a.avi')], 2, '.png, .exr, .mp4 or .gif'],
  ['a GIF too fast', ['render', movers, '-o', out('a.gif'), '--frames', '0:2', '--fps', '60'], 2, 'not 60'],
  ['data channels in a PNG', ['render', movers, '-o', out('a.png'), '--aov', 'depth'], 2, '.exr'],
  ['a film without frames', ['render', movers, '-o', out('a.mp4')], 2, '--frames'],
  ['a film of odd size', ['render', movers, '-o', out('a.mp4'), '--frames', '0:2', '--size', '31x20'], 2, 'even'],
  [
    'frames without a placeholder for their number',
    ['render', movers, '-o', out('a.png'), '--frames', '0:2'],
    2,
    'a.####.png',
  ],
  ['two kinds of time', ['render', movers, '-o', out('a.mp4'), '--frames', '0:2', '--time', '1'], 2, '--time'],
  [
    'a GPU backend for the reference renderer',
    ['render', movers, '-o', out('a.png'), '--pipeline', 'reference', '--backend', 'webgl'],
    2,
    '--backend webgl',
  ],
  [
    'an inexact solver for the reference renderer',
    ['render', movers, '-o', out('a.png'), '--pipeline', 'reference', '--solver', 'newton'],
    2,
    '--solver newton',
  ],
  [
    'threads for the raster pipeline',
    ['render', movers, '-o', out('a.png'), '--pipeline', 'raster', '--threads', '2'],
    2,
    '--threads',
  ],
  [
    'mirrors for the raster pipeline',
    ['render', movers, '-o', out('a.png'), '--no-mirrors'],
    2,
    'add --pipeline reference',
  ],
  ['no threads at all', ['render', movers, '-o', out('a.png'), '--threads', '0'], 2, '1 to 1024'],
  ['a missing camera', ['render', movers, '-o', out('a.png'), '--camera', '/No'], 2, '/World/Eye'],
  ['a missing folder', ['render', movers, '-o', join(folder, 'none', 'a.png')], 3, 'no folder'],
  ['a scene faster than light', ['render', scene('too-fast.usda'), '-o', out('a.png')], 3, '/World/Leaving'],
  ['neither prim nor pixel', ['probe', movers], 2, '--prim'],
])('%s is rejected with a remedy', async (_, args, code, word) => {
  const result = await slowlight(...args);
  expect(result.code, result.err).toBe(code);
  expect(result.err).toContain(word);
});

test('a folder as output is rejected', async () => {
  mkdirSync(out('folder.png'));
  const { code, err } = await slowlight('render', movers, '-o', out('folder.png'));
  expect(code).toBe(3);
  expect(err).toContain('is a folder');
});
