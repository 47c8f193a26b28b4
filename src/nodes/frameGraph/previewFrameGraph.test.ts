import { expect, it } from 'vitest';
import { makeScene } from '../../scene/defaults.ts';
import { MAX_PASSES } from '../../scene/frameGraph/frameGraph.ts';
import { DEFAULT_SETTINGS } from '../../scene/view/view.ts';
import type { GBufferSpec, ImageSpec } from '../socketValues.ts';
import { buildPicture } from './buildFrameGraph.ts';
import { previewFrameGraph } from './previewFrameGraph.ts';

const scene = makeScene({ name: 'a' });
const gbuffer = (over: Partial<GBufferSpec> = {}): GBufferSpec => ({
  ...DEFAULT_SETTINGS,
  scene,
  maxSpeed: 0.9,
  camera: '',
  ride: false,
  smooth: true,
  fovY: undefined,
  ...over,
});
const [seen, there] = [gbuffer(), gbuffer({ view: 'galilean' })];
const light = (buffer: GBufferSpec): ImageSpec => ({
  step: { kind: 'light', buffer, shadows: true, occlusion: true },
  gbuffer: buffer,
});
const toneMapped = (image: ImageSpec): ImageSpec => ({
  step: { kind: 'tone', tone: 'agx', exposure: 1, metering: 'manual', image },
  gbuffer: image.gbuffer,
});
const blurred = (image: ImageSpec, sigma = 8): ImageSpec => ({
  step: { kind: 'effect', effect: 'gaussian-blur', args: [sigma, 30], image, buffer: image.gbuffer },
  gbuffer: image.gbuffer,
});
const mixed = (below: ImageSpec, above: ImageSpec): ImageSpec => ({
  step: { kind: 'mix', mode: 'normal', alpha: 0.5, below, above },
  gbuffer: below.gbuffer,
});

/** The picture in which the page draws image previews. */
function besideOf(image: ImageSpec) {
  const { frameGraph, scenes } = buildPicture(image);
  return { settings: { ...DEFAULT_SETTINGS, ...(frameGraph && { frameGraph }) }, scenes };
}

it('all images are passes of one frame graph, each once, tone mapping included; blurs scale with the picture', () => {
  const [lit, smooth] = [light(seen), blurred(light(seen))];
  const end = toneMapped(smooth);
  const made = new Map<string, ImageSpec | GBufferSpec>([
    ['buffer', seen],
    ['lit', lit],
    ['smooth', smooth],
    ['tone', end],
    ['output', end],
  ]);
  const { plan: frameGraph, places } = previewFrameGraph(made, besideOf(end), 0.25);
  expect(frameGraph.passes.map(({ kind }) => kind)).toEqual(['light', 'effect', 'tone']);
  expect(frameGraph.passes[1]).toMatchObject({ args: [2, 30], image: 0 });
  expect(Object.fromEntries(places)).toEqual({
    buffer: { kind: 'gbuffer', buffer: 0 },
    lit: { kind: 'image', step: 0, light: true },
    smooth: { kind: 'image', step: 1, light: true },
    tone: { kind: 'image', step: 2, light: false, metered: 1 },
    output: { kind: 'image', step: 2, light: false, metered: 1 },
  });
});

it('G-buffers are those of the picture, in its order; images of other ones have no preview', () => {
  const picture = mixed(light(seen), light(there));
  const stranger = light(gbuffer({ scene: makeScene({ name: 'b' }) }));
  const made = new Map<string, ImageSpec | GBufferSpec>([
    ['there', there],
    ['other', light(there)],
    ['stranger', stranger],
  ]);
  const { plan: frameGraph, places } = previewFrameGraph(made, besideOf(picture), 1);
  expect(frameGraph.extraBuffers).toEqual(buildPicture(picture).frameGraph?.extraBuffers);
  expect(places.get('there')).toEqual({ kind: 'gbuffer', buffer: 1 });
  expect(frameGraph.passes).toMatchObject([{ kind: 'light', buffer: 1 }]);
  expect(places.has('stranger')).toBe(false);
  expect(previewFrameGraph(made, besideOf(light(seen)), 1).places.size).toBe(0);
});

it('images beyond the limits of a frame graph have no preview', () => {
  const long = new Map<string, ImageSpec>();
  let image = light(seen);
  for (let i = 0; i < MAX_PASSES + 5; i++) {
    long.set(`${i}`, image);
    image = blurred(image, i / 10);
  }
  const { plan: frameGraph, places } = previewFrameGraph(long, besideOf(light(seen)), 1);
  expect(frameGraph.passes).toHaveLength(MAX_PASSES);
  expect(places.size).toBe(MAX_PASSES);
});
