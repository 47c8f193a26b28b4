import { sceneDome, showsDome } from '../../scene/lights/sceneLights.ts';
import type { Scene } from '../../scene/types.ts';
import { NO_LIGHT, plus } from '../spectral/sampledRadiance.ts';
import type { Sky, TracedLight } from './lightingContext.ts';
import { tracedLight } from './lightTracers.ts';

/** The scene's dome, or that of the stars or of a clear day, with the discs of `lights`. */
export function skyOf(scene: Scene, lights: readonly TracedLight[]): Sky {
  const dome = tracedLight(sceneDome(scene), scene);
  const discs = lights.flatMap(({ disc }) => disc ?? []);
  return {
    isSeen: showsDome(scene),
    radiance: (n, context) => dome.radiance?.(n, context) ?? NO_LIGHT,
    sunDiscs: (n, context) =>
      discs.reduce((sum, disc) => plus(sum, context.emitted(disc.sourceSpectrum), disc.factor(n)), NO_LIGHT),
    ...(dome.sampler && { sampler: dome.sampler }),
  };
}
