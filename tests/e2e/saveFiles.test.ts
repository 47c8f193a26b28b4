import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { decode } from 'fast-png';
import { unzipSync } from 'fflate';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { sphericalOf } from '../../src/formats/spherical/sphericalOf.ts';
import { memoryFile } from '../../src/formats/zip/zipSource.ts';
import { parseDocument } from '../../src/graph/document/parse.ts';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import type { Command } from '../../src/graph/edits/commands.ts';
import { add, connect, edited, set } from '../support/graphKit.ts';
import { savingProject } from '../support/savingGraph.ts';
import { videoStream } from '../support/videoStream.ts';
import { difference, type MonitoredPage, Program, sharedPage, shots } from './program.ts';
import { ASKED, drop, serveAsked } from './support.ts';

let program: Program;
beforeAll(async () => {
  program = await Program.start();
});
afterAll(() => program.stop());

async function withGraph(): Promise<MonitoredPage> {
  const options = { viewport: { width: 1280, height: 900 } };
  const visit = await (await program.open(`?backend=webgl&scene=${ASKED}`, options, serveAsked)).ready();
  await visit.page.keyboard.press('Control+Shift+G');
  await node(visit.page, 'output').waitFor();
  return visit;
}
const shared = sharedPage(withGraph);

/** The saving project in the shared page, with its graph. */
const opened = async (...commands: readonly Command[]): Promise<MonitoredPage> => openIn(await shared(), commands);

async function openIn(visit: MonitoredPage, commands: readonly Command[]): Promise<MonitoredPage> {
  const content = Buffer.from(serializeDocument(edited(savingProject(), ...commands)));
  await visit.opens(() => drop(visit, [{ name: 'passing.slowlight.json', content }]));
  await node(visit.page, 'still').waitFor();
  return visit.ready();
}

const node = (page: Page, id: string) => page.locator(`.react-flow__node[data-id="${id}"]`);

async function downloaded(
  { page }: MonitoredPage,
  id: string,
): Promise<{ readonly name: string; readonly content: Buffer }> {
  const download = page.waitForEvent('download');
  await node(page, id).getByRole('button', { name: 'Download the file' }).click();
  const file = await download;
  await file.saveAs(join(shots, `download-${file.suggestedFilename()}`));
  return { name: file.suggestedFilename(), content: readFileSync(await file.path()) };
}

/** Presentation time of each frame of a film [s], by ffprobe. */
function frameTimes(path: string): number[] {
  const asked = ['-v', 'error', '-show_entries', 'frame=pts_time', '-of', 'csv=p=0', path];
  return execFileSync('ffprobe', asked)
    .toString()
    .trim()
    .split(/\s+/)
    .map((line) => Number.parseFloat(line));
}

it('a saved picture equals that of the command line, and a film has all its frames', async () => {
  const visit = await opened();
  const still = await downloaded(visit, 'still');
  expect(still.name).toBe('picture.png');
  const picture = decode(still.content, { checkCrc: true });
  expect(picture).toMatchObject({ width: 64, height: 48 });
  const [project, there] = [join(shots, 'passing.slowlight.json'), join(shots, 'passing.png')];
  writeFileSync(project, serializeDocument(savingProject()));
  const flags = ['--size', '64x48', '--time', '0.5', '--samples', '2', '--backend', 'webgl'];
  execFileSync(process.execPath, ['bin/slowlight.js', 'render', project, '-o', there, ...flags]);
  expect(still.content.equals(readFileSync(there))).toBe(true);

  const film = await downloaded(visit, 'film');
  expect(film.name).toBe('film.mp4');
  const path = join(shots, 'download-film.mp4');
  expect(videoStream(path, 'width,height,r_frame_rate,nb_read_frames,color_space')).toBe('stream,64,48,bt709,8/1,5');
  expect(frameTimes(path)).toEqual([0, 0.125, 0.25, 0.375, 0.5]);
  // Seeking to its time finds the third frame.
  const jump = ['-v', 'error', '-ss', '0.25', '-i', path, '-frames:v', '1', '-f', 'rawvideo', '-pix_fmt', 'rgba', '-'];
  const raw = execFileSync('ffmpeg', jump);
  expect(difference(Uint8Array.from(raw), Uint8Array.from(picture.data))).toBeLessThan(6);
});

it('a 360° picture and a 360° film say what they are, and the page shows the picture too', async () => {
  const visit = await opened(
    ...[set('camera', 'lens', 'equirectangular'), set('still', 'height', 32), set('film', 'height', 32)],
  );
  await visit.shot('equirectangular');
  const still = await downloaded(visit, 'still');
  expect(await sphericalOf(memoryFile(still.content), still.name)).toMatchObject({
    projection: 'equirectangular',
    stereo: 'none',
  });
  expect(decode(still.content)).toMatchObject({ width: 64, height: 32 });
  await downloaded(visit, 'film');
  const path = join(shots, 'download-film.mp4');
  const asked = ['-v', 'error', '-show_entries', 'stream_side_data=projection', '-of', 'csv=p=0', path];
  expect(execFileSync('ffprobe', asked).toString()).toContain('equirectangular');
  expect(frameTimes(path)).toEqual([0, 0.125, 0.25, 0.375, 0.5]);
  await visit.opens(() => drop(visit, [{ name: 'film.mp4', content: readFileSync(path) }]));
  const time = visit.page.getByRole('slider', { name: 'World time' });
  await expect.poll(() => time.getAttribute('aria-valuemax')).toBe('0.625');
  await (await visit.finest()).shot('film-seen');
});

it('what the page saves of a 360° film that is flown through is what the command line draws', async () => {
  const visit = await shared();
  const document = edited(
    parseDocument(readFileSync('examples/clocks-around.slowlight.json', 'utf8')),
    ...[add('frames', 'save-video'), set('frames', 'name', 'f_##.png'), set('frames', 'samples', 1)],
    ...[set('frames', 'width', 96), set('frames', 'height', 64), connect('tone.image', 'frames.image')],
    ...[set('frames', 'from', 0), set('frames', 'to', 4), set('frames', 'fps', 0.5)],
  );
  const folder = join(shots, 'clocks');
  mkdirSync(join(folder, 'panoramas'), { recursive: true });
  const clocks = readFileSync('examples/panoramas/clocks.mp4');
  writeFileSync(join(folder, 'panoramas/clocks.mp4'), clocks);
  writeFileSync(join(folder, 'clocks.slowlight.json'), serializeDocument(document));
  await visit.opens(() =>
    drop(visit, [
      { name: 'clocks.slowlight.json', content: Buffer.from(serializeDocument(document)) },
      { name: 'clocks.mp4', content: clocks },
    ]),
  );
  await node(visit.page, 'frames').waitFor();
  const { content } = await downloaded(visit, 'frames');
  const saved = Object.values(unzipSync(content)).map((png) => Uint8Array.from(decode(png).data));
  const drawn = ['render', join(folder, 'clocks.slowlight.json'), '--folder', folder, '--backend', 'webgl'];
  execFileSync(process.execPath, ['bin/slowlight.js', ...drawn]);
  const there = ['f_00.png', 'f_01.png', 'f_02.png'].map((name) =>
    Uint8Array.from(decode(readFileSync(join(folder, name))).data),
  );
  expect(saved).toHaveLength(3);
  // Two decoders: they interpolate colours differently. Hands of clocks are few pixels.
  const moved = difference(saved[0]!, saved[1]!);
  expect(moved).toBeGreaterThan(1);
  saved.forEach((picture, i) => {
    expect(difference(picture, there[i]!)).toBeLessThan(moved / 2);
  });
});

it('a stereo picture is shown, and saved with its mark', async () => {
  const visit = await opened(
    ...[set('camera', 'lens', 'stereo'), set('still', 'height', 64), set('film', 'height', 64)],
  );
  await visit.shot('stereo');
  const still = await downloaded(visit, 'still');
  expect(await sphericalOf(memoryFile(still.content), still.name)).toMatchObject({
    projection: 'equirectangular',
    stereo: 'top-bottom',
  });
  expect(decode(still.content)).toMatchObject({ width: 64, height: 64 });
});

it('a film is VP9 where no other codec is available, and a GIF needs none', async () => {
  const visit = await opened(
    ...[add('gif', 'save-video'), set('gif', 'name', 'film.gif'), set('gif', 'width', 63), set('gif', 'height', 48)],
    ...[set('gif', 'from', 0.25), set('gif', 'to', 0.75), set('gif', 'fps', 8), connect('tone.image', 'gif.image')],
  );
  const restore = await visit.page.evaluateHandle(() => {
    const real = VideoEncoder.isConfigSupported;
    VideoEncoder.isConfigSupported = (config) =>
      config.codec.startsWith('avc1') ? Promise.resolve({ supported: false, config }) : real.call(VideoEncoder, config);
    return () => {
      VideoEncoder.isConfigSupported = real;
    };
  });
  await downloaded(visit, 'film');
  await restore.evaluate((act) => act());
  const path = join(shots, 'download-film.mp4');
  expect(videoStream(path, 'codec_name,width,height,color_space,r_frame_rate,nb_read_frames')).toBe(
    'stream,vp9,64,48,bt709,8/1,5',
  );
  expect(frameTimes(path)).toEqual([0, 0.125, 0.25, 0.375, 0.5]);
  const gif = await downloaded(visit, 'gif');
  expect(gif.name).toBe('film.gif');
  const saved = join(shots, 'download-film.gif');
  expect(videoStream(saved, 'codec_name,width,height,nb_read_frames')).toBe('stream,gif,63,48,5');
  expect(frameTimes(saved)).toEqual([0, 0.13, 0.25, 0.38, 0.5]);
});

it('frames are saved as a zip, scenes as files, binary too; also by keyboard', async () => {
  const visit = await opened(
    ...[
      set('film', 'name', 'f_##.png'),
      set('film', 'to', 0.4),
      add('usd', 'write-usd'),
      set('usd', 'name', 'box.usdc'),
    ],
    connect('move.geometry', 'usd.geometry'),
  );
  const { page } = visit;
  const { name, content } = await downloaded(visit, 'film');
  expect(name).toBe('f.zip');
  const files = unzipSync(content);
  expect(Object.keys(files)).toEqual(['f_02.png', 'f_03.png']);
  expect(decode(files['f_03.png']!).text).toMatchObject({ worldTime: '0.375 s' });

  const clicked = await downloaded(visit, 'usd');
  expect([clicked.name, String.fromCharCode(...clicked.content.subarray(0, 8))]).toEqual(['box.usdc', 'PXR-USDC']);
  await node(page, 'usd').focus();
  await page.keyboard.press('Enter');
  const button = page.getByRole('region', { name: 'Write USD' }).getByRole('button', { name: 'Download the file' });
  await button.waitFor();
  const download = page.waitForEvent('download');
  // Immediately, because an inspector that has just been opened takes the focus.
  await button.press('Enter');
  const scene = await download;
  await page
    .getByText('box.usdc, which cannot represent everything: /Box: its uniform motion is sampled')
    .last()
    .waitFor();
  expect(scene.suggestedFilename()).toBe('box.usdc');
  expect(
    readFileSync(await scene.path())
      .subarray(0, 8)
      .toString(),
  ).toBe('PXR-USDC');
});

it('a long film reports progress, and can be cancelled', async () => {
  const visit = await opened(set('film', 'to', 60));
  const { page } = visit;
  await node(page, 'film').getByRole('button', { name: 'Download the file' }).click();
  const card = page.locator('[data-saving]');
  await card.getByText('Making film.mp4').waitFor();
  await expect.poll(() => card.getByRole('progressbar').getAttribute('aria-valuenow').then(Number)).toBeGreaterThan(0);
  expect(await node(page, 'still').getByRole('button', { name: 'Download the file' }).isDisabled()).toBe(true);
  await visit.shot('saving-film');
  await card.getByRole('button', { name: 'Cancel' }).click();
  await card.waitFor({ state: 'detached' });
  expect(await visit.refusals.count()).toBe(0);
});

it('reports a remedy where the browser cannot encode films, or the device is too small', async () => {
  const visit = await opened();
  const { page } = visit;
  const restore = await page.evaluateHandle(() => {
    const { VideoEncoder: encoder } = window;
    const { prototype } = WebGL2RenderingContext;
    const { getParameter } = prototype;
    Reflect.deleteProperty(window, 'VideoEncoder');
    return () => {
      Object.assign(window, { VideoEncoder: encoder });
      prototype.getParameter = getParameter;
    };
  });
  await node(page, 'film').getByRole('button', { name: 'Download the file' }).click();
  await visit.refusals.getByText('slowlight render passing.slowlight.json').waitFor();
  await visit.refusals.getByRole('button', { name: 'Copy the command' }).waitFor();
  await page.evaluate(() => {
    const { prototype } = WebGL2RenderingContext;
    const real = prototype.getParameter;
    prototype.getParameter = function (name) {
      return name === this.MAX_TEXTURE_SIZE ? 32 : real.call(this, name);
    };
  });
  await node(page, 'still').getByRole('button', { name: 'Download the file' }).click();
  await visit.refusals
    .getByText('64 × 48 pixels are too many for the graphics device here, which draws up to 32 along each side')
    .waitFor();
  // Why the film before was not made is past.
  expect(await visit.refusals.count()).toBe(1);
  await visit.refusals.getByRole('button', { name: 'Close' }).click();
  await restore.evaluate((act) => act());
});

/** An effect that shows one colour everywhere. */
const painted = (color: string): string => `#version 430 core
uniform sampler2D baseColorSampler1;
layout(location = 0) out vec4 Color;
void main() {
  Color = vec4(${color}, 1.0);
}
`;

it('the text of an effect is loaded from a file and saved to one; what is wrong with it is told by its line', async () => {
  const visit = await openIn(await withGraph(), [
    ...[add('effect', 'post-process'), set('effect', 'effect', 'written')],
    ...[connect('film.image', 'effect.image'), connect('effect.image', 'output.image')],
  ]);
  const { page } = visit;
  await node(page, 'effect').focus();
  await page.keyboard.press('Enter');
  const panel = page.getByRole('region', { name: 'Post process' });
  const load = async (text: string): Promise<void> => {
    const asked = page.waitForEvent('filechooser');
    await panel.getByRole('button', { name: 'Load text…' }).click();
    await (await asked).setFiles({ name: 'painted.frag', mimeType: 'text/plain', buffer: Buffer.from(text) });
  };
  await load(painted('gain'));
  await visit.refusals.getByText('line 5, column 16: gain is not declared here').waitFor();
  await load(painted('0.0, 1.0, 0.0'));
  await expect.poll(() => visit.middle()).toEqual([0, 255, 0]);
  expect(await visit.refusals.count()).toBe(0);
  expect(await panel.getByRole('textbox', { name: 'Shader text' }).inputValue()).toBe(painted('0.0, 1.0, 0.0'));

  const download = page.waitForEvent('download');
  await panel.getByRole('button', { name: 'Save text' }).click();
  const saved = await download;
  expect(saved.suggestedFilename()).toBe('effect.fs');
  expect(readFileSync(await saved.path(), 'utf8')).toBe(painted('0.0, 1.0, 0.0'));
  await visit.close();
});
