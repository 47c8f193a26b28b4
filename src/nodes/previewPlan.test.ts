import { expect, it } from 'vitest';
import { makeScene } from '../scene/defaults.ts';
import { MOST_STEPS } from '../scene/plan.ts';
import { DEFAULT_SETTINGS } from '../scene/view.ts';
import type { GBuffer, Image } from './define.ts';
import { planned } from './plan.ts';
import { previewPlan } from './previewPlan.ts';

const scene = makeScene({ name: 'a' });
const gbuffer = (over: Partial<GBuffer> = {}): GBuffer => ({
  ...DEFAULT_SETTINGS,
  scene,
  maxSpeed: 0.9,
  camera: '',
  ride: false,
  fovY: undefined,
  ...over,
});
const [seen, there] = [gbuffer(), gbuffer({ view: 'galilean' })];
const light = (buffer: GBuffer): Image => ({
  step: { kind: 'light', buffer, shadows: true, occlusion: true },
  gbuffer: buffer,
});
const toned = (image: Image): Image => ({
  step: { kind: 'tone', tone: 'agx', exposure: 1, metering: 'manual', image },
  gbuffer: image.gbuffer,
});
const blurred = (image: Image, sigma = 8): Image => ({
  step: { kind: 'effect', effect: 'gaussian-blur', args: [sigma, 30], image, buffer: image.gbuffer },
  gbuffer: image.gbuffer,
});
const mixed = (below: Image, above: Image): Image => ({
  step: { kind: 'mix', mode: 'normal', alpha: 0.5, below, above },
  gbuffer: below.gbuffer,
});

/** As the page shows a picture of an image. */
function besideOf(image: Image) {
  const { plan, scenes } = planned(image);
  return { settings: { ...DEFAULT_SETTINGS, ...(plan && { plan }) }, scenes };
}

it('all images are steps of one plan, each once; curves are among them, and blurs shrink with the picture', () => {
  const [lit, smooth] = [light(seen), blurred(light(seen))];
  const end = toned(smooth);
  const made = new Map<string, Image | GBuffer>([
    ['buffer', seen],
    ['lit', lit],
    ['smooth', smooth],
    ['tone', end],
    ['output', end],
  ]);
  const { plan, places } = previewPlan(made, besideOf(end), 0.25);
  expect(plan.steps.map(({ kind }) => kind)).toEqual(['light', 'effect', 'tone']);
  expect(plan.steps[1]).toMatchObject({ args: [2, 30], image: 0 });
  expect(Object.fromEntries(places)).toEqual({
    buffer: { kind: 'gbuffer', buffer: 0 },
    lit: { kind: 'image', step: 0, light: true },
    smooth: { kind: 'image', step: 1, light: true },
    tone: { kind: 'image', step: 2, light: false, metered: 1 },
    output: { kind: 'image', step: 2, light: false, metered: 1 },
  });
});

it('G-buffers are those of the picture, in its order; what takes another one has no place', () => {
  const picture = mixed(light(seen), light(there));
  const stranger = light(gbuffer({ scene: makeScene({ name: 'b' }) }));
  const made = new Map<string, Image | GBuffer>([
    ['there', there],
    ['other', light(there)],
    ['stranger', stranger],
  ]);
  const { plan, places } = previewPlan(made, besideOf(picture), 1);
  expect(plan.others).toEqual(planned(picture).plan?.others);
  expect(places.get('there')).toEqual({ kind: 'gbuffer', buffer: 1 });
  expect(plan.steps).toMatchObject([{ kind: 'light', buffer: 1 }]);
  expect(places.has('stranger')).toBe(false);
  expect(previewPlan(made, besideOf(light(seen)), 1).places.size).toBe(0);
});

it('what a plan has no room for has no place', () => {
  const long = new Map<string, Image>();
  let image = light(seen);
  for (let i = 0; i < MOST_STEPS + 5; i++) {
    long.set(`${i}`, image);
    image = blurred(image, i / 10);
  }
  const { plan, places } = previewPlan(long, besideOf(light(seen)), 1);
  expect(plan.steps).toHaveLength(MOST_STEPS);
  expect(places.size).toBe(MOST_STEPS);
});
