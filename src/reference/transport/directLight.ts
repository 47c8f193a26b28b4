import { length, normalize } from '../../math/vec3.ts';
import { maxOfFilter, scaleFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import { type IncidentLight, type LightingContext, rayBack } from '../lights/lightingContext.ts';
import { type Brdf, evaluateBrdf } from '../materials/brdf.ts';
import { NO_LIGHT, plus, type SampledRadiance } from '../spectral/sampledRadiance.ts';
import { IRRADIANCE_POWER, type LightReceiver, receivedLight } from '../spectral/spectralContext.ts';
import type { SurfaceOrigin } from './rayOrigin.ts';
import { transmittance } from './transmittance.ts';

/** Radiance that a surface at rest in `here` reflects of the sampled lights, in its rest frame. */
export function directLight(
  lighting: LightingContext,
  at: SurfaceOrigin,
  brdf: Brdf,
  here: LightReceiver,
): SampledRadiance {
  let sum = NO_LIGHT;
  for (const source of lighting.directLights) {
    const incident = source.sample?.(lighting, at);
    if (incident) sum = plus(sum, reflectedLight(lighting, at, brdf, here, incident));
  }
  return sum;
}

function reflectedLight(
  lighting: LightingContext,
  at: SurfaceOrigin,
  brdf: Brdf,
  here: LightReceiver,
  incident: IncidentLight,
): SampledRadiance {
  const { dx, rayDirection, end, sourceSpectrum, sourceFrame, weight } = incident;
  const n = normalize(dx);
  const filter = evaluateBrdf(brdf, here.frame.fromWorld(n));
  if (!filter || maxOfFilter(filter) === 0) return NO_LIGHT;
  const beam = { ray: rayBack(lighting, at, rayDirection), begin: at.clearance / length(rayDirection), from: at.hit };
  const visibility = transmittance(lighting.scene, beam, end);
  if (visibility === 0) return NO_LIGHT;
  const irradiance = receivedLight(here, n, sourceFrame, IRRADIANCE_POWER, ({ context }) =>
    context.emitted(sourceSpectrum),
  );
  return here.context.filtered(irradiance, scaleFilter(filter, visibility * weight));
}
