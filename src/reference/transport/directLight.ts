import { length, normalize, type Vec3 } from '../../math/vec3.ts';
import { maxOfFilter, scaleFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import type { Hit } from '../acceleration/ray.ts';
import { type IncidentLight, type LightingContext, rayBack, restFrameOf } from '../lights/lightingContext.ts';
import { type Brdf, evaluateBrdf } from '../materials/brdf.ts';
import { NO_LIGHT, plus, type SampledRadiance } from '../spectral/sampledRadiance.ts';
import { IRRADIANCE_POWER, type LightReceiver, receivedLight } from '../spectral/spectralContext.ts';
import type { SurfaceOrigin } from './rayOrigin.ts';
import { absorbed, straightPass } from './transmissive.ts';
import { type RaySegment, visibility } from './transmittance.ts';

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
  const { fraction, glass } = visibility(lighting.scene, beam, end);
  if (fraction === 0) return NO_LIGHT;
  const light = (receiver: LightReceiver): SampledRadiance =>
    receivedLight(receiver, n, sourceFrame, IRRADIANCE_POWER, ({ context }) => context.emitted(sourceSpectrum));
  const irradiance = throughGlass(lighting, beam, n, glass, here, light);
  return here.context.filtered(irradiance, scaleFilter(filter, fraction * weight));
}

/** Light as it arrives past transmissive surfaces, each of which acts on it in its own rest frame. */
function throughGlass(
  lighting: LightingContext,
  beam: RaySegment,
  n: Vec3,
  [hit, ...behind]: readonly Hit[],
  receiver: LightReceiver,
  light: (receiver: LightReceiver) => SampledRadiance,
): SampledRadiance {
  if (!hit) return light(receiver);
  const frame = restFrameOf(lighting, hit.velocity);
  const { filter, volume, way } = straightPass(lighting.scene, beam, hit, frame);
  return receivedLight(receiver, n, frame, IRRADIANCE_POWER, (there) => {
    const arrived = throughGlass(lighting, beam, n, behind, there, light);
    return there.context.filtered(absorbed(there.context, arrived, volume, way), filter);
  });
}
