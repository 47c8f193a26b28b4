import { build } from './buildProject.ts';
import { drive } from './drive.ts';

const ABOUT = {
  title: 'Layers',
  lookFor:
    "The picture is put together of its layers, as the program's forerunners did it: light without ambient occlusion, times what each place sees of the sky, smoothed but not across edges; then a lens that is in focus a few metres ahead, and the glare of what is bright. Mute a node, and see what it adds.",
};

/** The full graph of the source documents: light without ambient occlusion, times blurred ambient occlusion, with lens effects. */
export const layers = () =>
  build(ABOUT, {
    ...drive,
    lighting: { type: 'deferred-lighting', set: { occlusion: false }, from: { gbuffer: 'seen.gbuffer' } },
    occlusion: { type: 'ambient-occlusion', from: { gbuffer: 'seen.gbuffer' } },
    denoised: {
      type: 'post-process',
      set: { effect: 'bilateral-filter', arg1: 2 },
      from: { image: 'occlusion.mask' },
    },
    dimmed: {
      type: 'mix-color',
      set: { mode: 'multiply', alpha: 1 },
      from: { below: 'lighting.image', above: 'denoised.image' },
    },
    lens: { type: 'depth-of-field', set: { focus: 6, aperture: 200 }, from: { image: 'dimmed.image' } },
    glare: { type: 'post-process', set: { effect: 'bloom' }, from: { image: 'lens.image' } },
    toneMap: { type: 'tone-map', from: { image: 'glare.image' } },
    output: { type: 'output', from: { image: 'toneMap.image' } },
  });
