import { build } from './build.ts';
import { drive } from './kit.ts';

/** What is seen, over what an ordinary renderer would draw: both shine through. */
export const comparison = () =>
  build({
    ...drive,
    lighting: { type: 'deferred-lighting', from: { gbuffer: 'seen.gbuffer' } },
    ordinary: { type: 'rasterize', from: { view: 'camera.view' } },
    plain: { type: 'deferred-lighting', from: { gbuffer: 'ordinary.gbuffer' } },
    over: {
      type: 'mix-color',
      set: { mode: 'normal', alpha: 0.5 },
      from: { below: 'plain.image', above: 'lighting.image' },
    },
    toneMap: { type: 'tone-map', from: { image: 'over.image' } },
    output: { type: 'output', from: { image: 'toneMap.image' } },
  });
