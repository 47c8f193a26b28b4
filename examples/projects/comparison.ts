import { build } from './build.ts';
import { drive } from './kit.ts';

const ABOUT = {
  title: 'Seen and there',
  lookFor:
    'What you see at 0.4 c, over what an ordinary renderer draws of the same moment: both shine through. Lamp posts stand apart, and the farther ahead the more; the moving box is where it was, and where it is. Set the mode to split or wipe to see them side by side.',
};

/** What is seen, over what an ordinary renderer would draw: both shine through. */
export const comparison = () =>
  build(ABOUT, {
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
