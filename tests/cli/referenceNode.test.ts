import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { expect, test } from 'vitest';
import { build, type NodeSketch } from '../../examples/projects/buildProject.ts';
import type { ExrImage } from '../../src/formats/image/exr.ts';
import { readExr } from '../../src/formats/image/readExr.ts';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { CancelledError } from '../../src/graph/evaluation/evaluator.ts';
import { DEFAULT_LIGHT } from '../../src/reference/lights/lightOptions.ts';
import { makeScene } from '../../src/scene/defaults.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS } from '../../src/scene/view/view.ts';
import { outputFolder, processorSeconds, programResult, scene, slowlight, start } from './program.ts';

const folder = outputFolder();
const at = (name: string): string => join(folder, name);

function project(name: string, nodes: Readonly<Record<string, NodeSketch>>): string {
  writeFileSync(at(name), serializeDocument(build({ title: name, lookFor: name }, nodes)));
  return at(name);
}

/** The graph from the scene's camera to the G-buffer. */
const seenFrom = (scene: NodeSketch): Record<string, NodeSketch> => ({
  scene,
  console: { type: 'relativity-console', set: { speedOfLight: 10 }, from: { scene: 'scene.scene' } },
  camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
  seen: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
});
const still = (set: NodeSketch['set']): NodeSketch => ({
  type: 'reference-render',
  set,
  from: { gbuffer: 'seen.gbuffer' },
});
const shaded: NodeSketch = { type: 'deferred-lighting', set: { occlusion: false }, from: { gbuffer: 'seen.gbuffer' } };
const showing = (image: string): NodeSketch => ({ type: 'output', from: { image: `${image}.image` } });

/** A file with a fast observer. */
const movers = {
  read: { type: 'read', set: { source: relative(folder, scene('movers.usda')) } },
  fast: { type: 'observer', set: { beta: [0.1, 0, -0.5] } },
  ...seenFrom({ type: 'scene', from: { geometry: ['read.geometry'], observer: 'fast.observer' } }),
} as const satisfies Record<string, NodeSketch>;

/** Matt objects under a sun and a black sky. */
const yard = {
  ground: { type: 'grid', set: { name: 'Ground', width: 40, length: 40 } },
  box: { type: 'box', set: { name: 'Box' } },
  standing: { type: 'transform', set: { position: [0, 0.5, 0] }, from: { geometry: 'box.geometry' } },
  matte: { type: 'material', set: { roughness: 1 }, from: { geometry: 'standing.geometry' } },
  sun: { type: 'sun', set: { direction: [-0.6, -0.7, -0.5], brightness: 2 } },
  dark: { type: 'sky', set: { brightness: 0 } },
  eye: { type: 'camera' },
  ...seenFrom({
    type: 'scene',
    from: { geometry: ['ground.geometry', 'matte.geometry', 'eye.geometry'], lights: ['sun.lights', 'dark.lights'] },
  }),
} as const satisfies Record<string, NodeSketch>;

/** The channels R, G, B of a picture. */
async function beauty(path: string, ...flags: string[]): Promise<ExrImage['channels']> {
  const file = `${path}.exr`;
  const { code, err } = await slowlight('render', path, '-o', file, ...flags);
  expect(code, err).toBe(0);
  return readExr(new Uint8Array(readFileSync(file)), file).channels;
}

test('the still equals the picture of the reference renderer, pixel by pixel', async () => {
  const size = { width: 48, height: 27 };
  const reference = ['--size', '48x27', '--pipeline', 'reference', '--samples'];
  const light = { samples: 2, seed: 7, bounces: 1, mirrors: false, time: 1 };
  const flags = ['2', '--seed', '7', '--bounces', '1', '--no-mirrors', '--time', '1'];
  const plain = project('plain.slowlight.json', { ...movers, lit: shaded, output: showing('lit') });
  const node = project('node.slowlight.json', {
    ...movers,
    truth: still({ ...size, ...light }),
    output: showing('truth'),
  });
  // The node's picture has its own time and its own noise, whatever the flags.
  const [expected, found] = await Promise.all([beauty(plain, ...reference, ...flags), beauty(node, ...reference, '1')]);
  expect(new Set(expected[0]?.data).size).toBeGreaterThan(300);
  expect(found).toEqual(expected);
});

test('the rasterizer’s picture is the same for matt objects lit only by a sun', async () => {
  const set = { width: 96, height: 54, samples: 4, bounces: 0 };
  const both = { ...yard, truth: still(set), shaded };
  const difference: NodeSketch = {
    type: 'mix-color',
    set: { mode: 'difference', alpha: 1 },
    from: { below: 'truth.image', above: 'shaded.image' },
  };
  const path = project('difference.slowlight.json', { ...both, mix: difference, output: showing('mix') });
  const errors = await beauty(path, '--size', '96x54', '--backend', 'webgpu', '--samples', '4');
  const lit = await beauty(
    project('lit.slowlight.json', { ...both, output: showing('truth') }),
    ...['--size', '96x54', '--pipeline', 'reference'],
  );
  const green = (channels: ExrImage['channels']) => Float64Array.from(channels[1]!.data).sort();
  const mean = (channels: ExrImage['channels']) => green(channels).reduce((sum, value) => sum + value, 0) / (96 * 54);
  expect(mean(lit)).toBeGreaterThan(0.1);
  // Edges and spectral noise differ.
  expect(mean(errors) / mean(lit)).toBeLessThan(0.02);
  const most = green(errors)[Math.floor(0.97 * 96 * 54)]!;
  expect(most / mean(lit)).toBeLessThan(0.05);
});

test('a render that would take hours is rejected at the node, with a remedy', async () => {
  const path = project('large.slowlight.json', { ...yard, truth: still({}), output: showing('truth') });
  const refused = async (...sets: string[]) => {
    const { code, err } = await slowlight('render', path, '-o', at('no.png'), ...sets.flatMap((set) => ['--set', set]));
    return `${code} ${err}`;
  };
  expect(await refused('truth.width=8000', 'truth.height=8000')).toMatch(
    /^3 .*\n.*truth: 8000 × 8000 are 64\.0 million pixels, more than 4\.2 million; make it smaller/,
  );
  expect(await refused('truth.width=1920', 'truth.height=1080', 'truth.samples=6')).toMatch(
    /6 × 6 samples of 1920 × 1080 pixels are 74\.6 million, more than 67\.1 million; take 5 × 5, or fewer pixels/,
  );
  expect(existsSync(at('no.png'))).toBe(false);
});

test('Ctrl-C interrupts it', async () => {
  const set = { width: 1280, height: 720, samples: 8 };
  const path = project('long.slowlight.json', { ...yard, truth: still(set), output: showing('truth') });
  const child = start('render', path, '-o', at('long.png'));
  const ended = programResult(child);
  // It runs for minutes; by now it has read the scene and begun.
  while (processorSeconds(child) < 6) await new Promise((done) => setTimeout(done, 50));
  expect(child.exitCode).toBeNull();
  child.kill('SIGINT');
  expect(await ended).toMatchObject({ code: 130, err: '' });
});

test('it reports progress, and can be cancelled by its caller', async () => {
  const built = new URL('../../dist/lib/cli/pipelines/renderStill.js', import.meta.url).href;
  const { renderStill } = (await import(built)) as typeof import('../../src/cli/pipelines/renderStill.ts');
  const view = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: [0, 0, 0, 1], lens: perspective(1) } as const;
  const scene = makeScene({ name: 'empty' });
  const options = { seed: 0, ...DEFAULT_LIGHT };
  const size = { width: 40, height: 20 };
  const views = [view] as const;
  const picture = { pipeline: 'reference', scene, views, settings: DEFAULT_SETTINGS, ...size, samples: 1, options };
  const parts: (number | undefined)[] = [];
  const pixels = await renderStill(picture, { progress: (part) => parts.push(part) });
  expect(pixels.length).toBe(3 * 40 * 20);
  expect(parts).toEqual([1, 2, 3, 4, 5, 6].map((done) => done / 6));
  // Two views by the same threads: each half is the picture of one.
  const half = (x: number) => ({ ...view, viewport: { x, y: 0, width: 20, height: 20 } });
  const pair = await renderStill({ ...picture, views: [half(0), half(20)] }, { progress: () => {} });
  const alone = await renderStill({ ...picture, width: 20, height: 20 }, { progress: () => {} });
  for (let row = 0; row < 20; row++)
    for (const x of [0, 20])
      expect(pair.slice(3 * (40 * row + x), 3 * (40 * row + x + 20))).toEqual(alone.slice(60 * row, 60 * (row + 1)));
  expect(new Set(alone).size).toBeGreaterThan(100);
  const abort = new AbortController();
  const large = { ...picture, width: 4096, height: 4096, samples: 16 };
  const work = { signal: abort.signal, progress: () => abort.abort() };
  await expect(renderStill(large, work)).rejects.toMatchObject({ name: new CancelledError().name });
  await expect(renderStill(picture, work)).rejects.toMatchObject({ name: 'CancelledError' });
});
