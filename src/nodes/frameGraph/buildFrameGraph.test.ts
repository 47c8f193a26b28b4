import { describe, expect, it } from 'vitest';
import { add, build, connect, set } from '../../../tests/support/graphKit.ts';
import { saying } from '../../../tests/support/inWords.ts';
import type { Command } from '../../graph/edits/commands.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { makeScene } from '../../scene/defaults.ts';
import { contentKey, frameGraphStructure } from '../../scene/frameGraph/frameGraph.ts';
import { nodeLibrary } from '../library.ts';
import { evaluatedPicture, renderSettings } from '../pictures/renderSettings.ts';
import { type Services, workerServices } from '../services.ts';
import type { PictureSpec } from '../socketValues.ts';

const loaded = { scene: makeScene({ name: 'a', hints: { speedOfLight: 10 } }) };

/** Output of a graph behind a camera. */
const FILES: Readonly<Record<string, string>> = {
  'add.fs': `#version 430 core
uniform vec2 iResolution;
uniform sampler2D baseColorSampler1, baseColorSampler2;
uniform float alpha;
layout(location = 0) out vec4 Color;
void main() {
  vec2 uv = gl_FragCoord.xy / iResolution;
  Color = vec4(texture(baseColorSampler1, uv).rgb + texture(baseColorSampler2, uv).rgb * alpha, 1.0);
}`,
  'wrong.fs': 'void main() {\n  discard;\n}',
  'long.fs': '/'.repeat(70_000),
};

async function evaluated(...commands: readonly Command[]) {
  const document = build(
    add('read', 'read'),
    set('read', 'source', 'a.usda'),
    add('scene', 'scene'),
    add('console', 'relativity-console'),
    add('camera', 'scene-camera'),
    add('seen', 'relativity-rasterize'),
    add('light', 'deferred-lighting'),
    connect('read.geometry', 'scene.geometry.1'),
    connect('scene.scene', 'console.scene'),
    connect('console.relativity', 'camera.relativity'),
    connect('camera.view', 'seen.view'),
    connect('seen.gbuffer', 'light.gbuffer'),
    add('output', 'output'),
    ...commands,
  );
  const services: Services = {
    ...workerServices,
    readScene: async () => loaded,
    readFile: async (source) => new TextEncoder().encode(FILES[source]),
    renderStill: async ({ width, height, options: { seed } }) =>
      new Float32Array(3 * width * height).fill(Number(seed)),
  };
  return new Evaluator(nodeLibrary).evaluate(document, 'output', services);
}
async function pictured(...commands: readonly Command[]): Promise<PictureSpec> {
  const evaluation = await evaluated(...commands);
  const picture = evaluatedPicture(evaluation);
  expect([...evaluation.results.values()].filter(({ status }) => status === 'failed')).toEqual([]);
  return picture!;
}

const toned = (from: string, id = 'tone'): Command[] => [add(id, 'tone-map'), connect(`${from}.image`, `${id}.image`)];
const shown = (from: string): Command => connect(`${from}.image`, 'output.image');
const blur = (id: string, from: string, arg1 = 3): Command[] => [
  add(id, 'post-process'),
  set(id, 'arg1', arg1),
  connect(from, `${id}.image`),
];

describe('a picture of one G-buffer', () => {
  it('is shaded, exposed and tone mapped without a frame graph', async () => {
    const picture = await pictured(
      ...toned('light'),
      set('tone', 'exposure', 2),
      set('light', 'occlusion', false),
      shown('tone'),
    );
    expect(picture.frameGraph).toBeUndefined();
    expect(renderSettings(picture, 0.5)).toMatchObject({ exposure: 2.5, tone: 'neutral', occlusionRadius: 0 });
  });

  it('is shown unchanged without a tone mapping node', async () => {
    const picture = await pictured(shown('light'));
    expect(picture).toMatchObject({ tone: 'linear', exposure: 0, metering: 'manual', falseColor: 'none' });
  });
});

describe('a frame graph', () => {
  it('has each pass once, however many nodes lead to it', async () => {
    const { frameGraph } = await pictured(
      ...blur('a', 'light.image'),
      ...blur('b', 'light.image'),
      ...blur('c', 'light.image', 5),
      add('ab', 'mix-color'),
      connect('a.image', 'ab.below'),
      connect('b.image', 'ab.above'),
      add('abc', 'mix-color'),
      connect('ab.image', 'abc.below'),
      connect('c.image', 'abc.above'),
      ...toned('abc'),
      shown('tone'),
    );
    expect(frameGraph?.extraBuffers).toEqual([]);
    expect(frameGraph?.passes.map(({ kind }) => kind).sort()).toEqual(['effect', 'effect', 'light', 'mix', 'mix']);
    expect(frameGraph?.passes.at(-1)).toMatchObject({ kind: 'mix' });
  });

  it('of an image that is doubled repeatedly has only as many passes as nodes', async () => {
    const doubled = Array.from({ length: 40 }, (_, i): Command[] => {
      const from = i === 0 ? 'light' : `m${i - 1}`;
      return [
        add(`m${i}`, 'mix-color'),
        set(`m${i}`, 'alpha', i / 40),
        connect(`${from}.image`, `m${i}.below`),
        connect(`${from}.image`, `m${i}.above`),
      ];
    });
    expect((await pictured(...doubled.flat(), shown('m39'))).frameGraph?.passes.length).toBe(41);
  });

  it('with too many passes is rejected at the output', async () => {
    const chain = Array.from({ length: 70 }, (_, i) =>
      blur(`b${i}`, i === 0 ? 'light.image' : `b${i - 1}.image`, i % 20),
    );
    const { target } = await evaluated(...chain.flat(), shown('b69'));
    expect(target).toMatchObject({ problem: { place: 'output', message: saying('64 steps') } });
  });

  const stills = (...seeds: readonly number[]) => [
    ...seeds.flatMap((seed, i): Command[] => [
      add(`s${i}`, 'reference-render'),
      connect('seen.gbuffer', `s${i}.gbuffer`),
      set(`s${i}`, 'seed', seed),
      add(`m${i}`, 'mix-color'),
      connect(i === 0 ? 'light.image' : `m${i - 1}.image`, `m${i}.below`),
      connect(`s${i}.image`, `m${i}.above`),
    ]),
    shown(`m${seeds.length - 1}`),
  ];

  it('has each still once, by content, which does not change its shape; the limit is four', async () => {
    const [one, other] = [
      (await pictured(...stills(1, 2, 1))).frameGraph!,
      (await pictured(...stills(3, 2, 3))).frameGraph!,
    ];
    expect(one.passes.filter(({ kind }) => kind === 'still')).toMatchObject([
      { still: { width: 480, height: 270 } },
      {},
    ]);
    expect(frameGraphStructure(one)).toBe(frameGraphStructure(other));
    expect(contentKey(one)).not.toBe(contentKey(other));
    expect(contentKey(one).length).toBeLessThan(2000);
    const { target } = await evaluated(...stills(1, 2, 3, 4, 5));
    expect(target).toMatchObject({ problem: { place: 'output', message: saying('4 stills') } });
  });

  it('converts masks to images and images to masks', async () => {
    const { frameGraph } = await pictured(
      add('ao', 'ambient-occlusion'),
      connect('seen.gbuffer', 'ao.gbuffer'),
      ...blur('soft', 'ao.mask'),
      ...blur('dim', 'light.image'),
      connect('soft.image', 'dim.mask'),
      shown('dim'),
    );
    const place = frameGraph!.passes.findIndex(({ kind }) => kind === 'occlusion');
    expect(frameGraph?.passes.at(-1)).toMatchObject({
      mask: frameGraph!.passes.findIndex((step) => 'image' in step && step.image === place),
    });
  });

  it('has the G-buffer of the relativity node, in either order; an ordinary G-buffer is another', async () => {
    const compared = ([below, above]: readonly [string, string]) =>
      pictured(
        add('plain', 'rasterize'),
        connect('camera.view', 'plain.view'),
        add('other', 'deferred-lighting'),
        connect('plain.gbuffer', 'other.gbuffer'),
        add('mix', 'mix-color'),
        connect(`${below}.image`, 'mix.below'),
        connect(`${above}.image`, 'mix.above'),
        ...toned('mix'),
        shown('tone'),
      );
    for (const order of [
      ['light', 'other'],
      ['other', 'light'],
    ] as const) {
      const picture = await compared(order);
      expect(picture.view).toBe('light-cone');
      expect(picture.frameGraph?.extraBuffers).toMatchObject([
        { scene: 0, view: 'galilean', dopplerMix: 0, beaming: 0 },
      ]);
      expect(picture.scenes).toEqual([picture.scene]);
    }
  });

  it('with an inner tone mapping pass is metered there', async () => {
    const picture = await pictured(
      ...toned('light'),
      set('tone', 'exposure', 1),
      add('false', 'false-colour'),
      set('false', 'of', 'doppler'),
      connect('tone.image', 'false.image'),
      add('split', 'mix-color'),
      connect('tone.image', 'split.below'),
      connect('false.image', 'split.above'),
      shown('split'),
    );
    const { exposure, tone, frameGraph } = renderSettings(picture, 0.5, () => ({ from: 0.5, to: 2 }));
    expect(picture.metering).toBe('automatic');
    expect({ exposure, tone }).toEqual({ exposure: 0, tone: 'linear' });
    expect(frameGraph?.passes.find(({ kind }) => kind === 'tone')).toMatchObject({ exposure: 1.5 });
    expect(frameGraph?.passes.find(({ kind }) => kind === 'false-colour')).toMatchObject({
      scale: { from: 0.5, to: 2 },
    });
  });

  it('has a shape that depends on its effects, not on their numbers', async () => {
    const of = async (arg1: number, effect = 'gaussian-blur') =>
      frameGraphStructure(
        (await pictured(...blur('a', 'light.image', arg1), set('a', 'effect', effect), shown('a'))).frameGraph!,
      );
    expect(await of(3)).toBe(await of(4));
    expect(await of(3)).not.toBe(await of(3, 'sharpen'));
  });
});

it('an invalid effect text is rejected at its node, with line and column', async () => {
  const { results } = await evaluated(
    ...blur('own', 'light.image'),
    set('own', 'effect', 'written'),
    set('own', 'text', 'fn effect(p: Pixel) -> vec4f {\n  while (true) {}\n}'),
    shown('own'),
  );
  expect(results.get('own')).toMatchObject({
    problem: { code: 'shader.text', place: 'own', message: saying(/^line 2, column 3: /) },
  });
});

describe('an effect text in a file', () => {
  const mixed = (file: string) =>
    evaluated(
      ...blur('soft', 'light.image'),
      add('mix', 'mix-color'),
      set('mix', 'mode', 'written'),
      set('mix', 'file', file),
      set('mix', 'alpha', 0.25),
      connect('light.image', 'mix.below'),
      connect('soft.image', 'mix.above'),
      shown('mix'),
    );

  it('is a mode of Mix colour, with both images and alpha', async () => {
    const { frameGraph } = evaluatedPicture(await mixed('add.fs'))!;
    expect(frameGraph!.passes.map(({ kind }) => kind)).toEqual(['light', 'effect', 'effect']);
    expect(frameGraph!.passes[2]).toMatchObject({
      ...{ effect: { text: FILES['add.fs'] }, args: [0.25], image: 0, second: 1 },
    });
  });

  it('is named with the error in it, and bounded', async () => {
    const problem = async (file: string) => (await mixed(file)).results.get('mix');
    expect(await problem('wrong.fs')).toMatchObject({
      problem: { code: 'shader.text', message: saying(/^wrong\.fs: line 2, column 3: `discard` is not taken/) },
    });
    expect(await problem('long.fs')).toMatchObject({ problem: { message: saying(/70000 bytes/) } });
  });

  it('that reads a second image needs one', async () => {
    const text = 'fn effect(p: Pixel) -> vec4f { return image2(vec2i(0)); }';
    const own = [
      ...blur('own', 'light.image'),
      set('own', 'effect', 'written'),
      set('own', 'text', text),
      shown('own'),
    ];
    const { results } = await evaluated(...own);
    expect(results.get('own')).toMatchObject({ problem: { message: saying(/none is connected/) } });
    const passes = (await pictured(...own, ...blur('soft', 'light.image'), connect('soft.image', 'own.second')))
      .frameGraph!.passes;
    expect(passes.at(-1)).toMatchObject({ image: 0, second: 1 });
  });
});
