import { build } from './build.ts';
import { drive } from './kit.ts';

/** At the right the street as it is seen, at the left over the same picture which part of the emitted spectrum arrives as what is seen. */
export const lesson = () =>
  build({
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
