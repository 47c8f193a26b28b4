import { build } from './buildProject.ts';
import { drive } from './drive.ts';

const ABOUT = {
  title: 'Colours and bands',
  lookFor:
    'The same street twice: at the right as it is seen at 0.4 c, at the left coloured by the part of the spectrum that it left in. What is seen straight ahead left as infrared light; the farther to the side, the less it is shifted, and what flees before you keeps its colour. Choose another number in False colour: the Doppler factor, or how long ago the light left.',
};

/** Right: the observed street. Left: the part of the emitted spectrum that arrives as visible light, over the same picture. */
export const lesson = () =>
  build(ABOUT, {
    ...drive,
    lighting: { type: 'deferred-lighting', from: { gbuffer: 'seen.gbuffer' } },
    toneMap: { type: 'tone-map', from: { image: 'lighting.image' } },
    shift: { type: 'false-colour', set: { of: 'band' }, from: { image: 'toneMap.image' } },
    split: {
      type: 'mix-color',
      set: { mode: 'split', alpha: 0.5 },
      from: { below: 'shift.image', above: 'toneMap.image' },
    },
    output: { type: 'output', from: { image: 'split.image' } },
  });
