import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { savingProject } from '../support/savingGraph.ts';
import { videoStream } from '../support/videoStream.ts';
import { ask, outputFolder, programResult, slowlight, slowlightJson, start } from './program.ts';

const folder = outputFolder();
const project = join(folder, 'passing.slowlight.json');
writeFileSync(project, serializeDocument(savingProject()));

function into(name: string): string {
  const made = join(folder, name);
  mkdirSync(made);
  return made;
}

test('a project’s picture and film equal those of `render -o`', async () => {
  const here = into('both');
  const { files } = await slowlightJson<{ files: string[] }>('render', project, '--folder', here);
  expect(files).toEqual([join(here, 'film.mp4'), join(here, 'picture.png')]);
  const [still, film] = [join(folder, 'still.png'), join(folder, 'film.mp4')];
  const size = ['--size', '64x48'];
  await slowlightJson('render', project, '-o', still, ...size, '--time', '0.5', '--samples', '2');
  await slowlightJson('render', project, '-o', film, ...size, '--frames', '2:6', '--fps', '8', '--samples', '1');
  expect(readFileSync(files[1]!).equals(readFileSync(still))).toBe(true);
  expect(videoStream(files[0]!, 'width,height,r_frame_rate,nb_read_frames')).toBe('stream,64,48,8/1,5');
  const hashes = await Promise.all(
    [files[0]!, film].map((file) => ask('ffmpeg', '-v', 'error', '-i', file, '-f', 'framemd5', '-')),
  );
  expect(hashes[0]).toBe(hashes[1]);
});

test('frames and EXR files are written one by one, and flags override parameters', async () => {
  const here = into('frames');
  const sets = ['still.name=light.exr', 'film.name=f_###.png', 'film.to=0.5'].flatMap((text) => ['--set', text]);
  const { files } = await slowlightJson<{ files: string[] }>(
    'render',
    project,
    '--folder',
    here,
    ...sets,
    ...['--tone', 'agx', '--pipeline', 'reference'],
  );
  expect(files.map((file) => file.slice(here.length + 1))).toEqual([
    'f_002.png',
    'f_003.png',
    'f_004.png',
    'light.exr',
  ]);
  expect(readFileSync(files[3]!).readUInt32LE(0)).toBe(20000630);
  const about = readFileSync(files[0]!, 'latin1');
  expect(about).toContain('tone\0agx');
  expect(about).toContain('worldTime\0' + '0.25 s');
});

test('Ctrl-C leaves no partial files', async () => {
  const here = into('stopped');
  const child = start('render', project, '--folder', here, '--pipeline', 'reference', '--set', 'film.to=200');
  const ends = programResult(child);
  while (!readdirSync(here).some((name) => name.includes('.partial'))) {
    await new Promise((resolve) => setTimeout(resolve, 50));
    expect(child.exitCode).toBeNull();
  }
  child.kill('SIGINT');
  expect((await ends).code).toBe(130);
  expect(readdirSync(here)).toEqual([]);
});

test.each([
  ['a film of odd size', ['--set', 'film.width=63'], 3, /film\.width: .*even/],
  ['frames without numbers', ['--set', 'film.name=a.png'], 3, /film\.name: .*a\.####\.png/],
  ['a time of one’s own', ['--time', '1'], 2, /--time is for -o/],
  ['an observer who stays in place', ['--stay-in-place'], 2, /--stay-in-place is for -o/],
  ['a scene’s flag', ['--variant', 'a=b'], 2, /--variant is for scene files/],
])('nothing is written: %s', async (_, args, expectedCode, message) => {
  const here = join(folder, 'refused');
  mkdirSync(here, { recursive: true });
  const { code, err } = await slowlight('render', project, '--folder', here, ...args);
  expect(code, err).toBe(expectedCode);
  expect(err).toMatch(message);
  expect(readdirSync(here)).toEqual([]);
});
