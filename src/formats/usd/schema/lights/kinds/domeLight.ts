import type { DomeLight } from '../../../../../scene/types.ts';
import { domeTexture, skyGradient } from '../domeLights.ts';
import { emissionOf, spectrumOf } from '../lightInputs.ts';
import type { LightSchema } from './lightSchema.ts';

export const DOME_LIGHT: LightSchema<DomeLight> = {
  typeNames: ['DomeLight', 'DomeLight_1'],
  moves: false,
  async read({ context, textures, prim, frame }) {
    const color = emissionOf(context, prim);
    const dome = { kind: 'dome', path: prim.path, color, ...(await spectrumOf(context, prim)) } as const;
    return { ...dome, ...skyGradient(context, prim, color), ...(await domeTexture(context, textures, prim, frame)) };
  },
};
