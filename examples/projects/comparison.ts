import { build } from './buildProject.ts';
import { drive } from './drive.ts';

const ABOUT = {
  title: 'Seen and there',
  lookFor:
    'At the left what you see at 0.4 c, at the right what an ordinary renderer draws of the same moment. Move the border (Alpha): lamp posts jump, the farther ahead the more, and lose their blue; the moving box is where it was, then where it is. Set the mode to normal, and both shine through.',
};

/** The observed picture beside that of an ordinary renderer. */
export const comparison = () =>
  build(ABOUT, {
    ...drive,
    lighting: { type: 'deferred-lighting', from: { gbuffer: 'seen.gbuffer' } },
    ordinary: { type: 'rasterize', from: { view: 'camera.view' } },
    plain: { type: 'deferred-lighting', from: { gbuffer: 'ordinary.gbuffer' } },
    over: {
      type: 'mix-color',
      set: { mode: 'wipe', alpha: 0.5 },
      from: { below: 'plain.image', above: 'lighting.image' },
    },
    toneMap: { type: 'tone-map', from: { image: 'over.image' } },
    output: { type: 'output', from: { image: 'toneMap.image' } },
  });
