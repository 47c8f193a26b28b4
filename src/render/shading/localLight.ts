import { dot, normalize } from 'three/tsl';
import type { Float } from '../../shaders/types.ts';
import { IRRADIANCE_POWER, type RadianceAccumulator } from '../color/radiance.ts';
import { type LightAtEmission, lightAtEmission } from '../lights/lightAtEmission.ts';
import { frontOf, shapingFactor } from '../lights/lightShaping.ts';
import type { LightTexels } from '../lights/lightTable.ts';
import { incidentSpectrumBetween } from '../lights/restFrame.ts';
import { areaLight } from './areaLight.ts';
import { evaluateBrdf } from './brdf.ts';
import type { LitSurface } from './litSurface.ts';
import { sphereLight } from './sphereLight.ts';
import type { AddReflected, ReflectedLight } from './surfaceInLightFrame.ts';

/** The share of a lamp's light that gets to a surface past what is in its way. */
export type LocalLightVisibility = (lamp: LightTexels, seen: LightAtEmission) => Float | undefined;

/** What a surface sends on of a lamp's light; `shelter`: of one that throws shadows. */
export function addLocalLight(
  receiver: LitSurface,
  light: LightTexels,
  accumulator: RadianceAccumulator,
  visibility?: LocalLightVisibility,
): void {
  const { dx, time, uniforms } = receiver;
  const seen = lightAtEmission(light, dx, time, uniforms);
  const passing = visibility?.(light, seen)?.toVar();
  const { source, colored } = light;
  const sent = ({ share, D }: ReflectedLight): void =>
    accumulator.addReflected(
      light.color,
      passing ? share.mul(passing) : share,
      { ...(D && { D }), ...(source && { source }), ...(colored !== undefined && { colored }) },
      IRRADIANCE_POWER,
    );
  const send: AddReflected = (matt, glossy) => {
    if (!matt.D && !glossy.D) return sent({ share: matt.share.add(glossy.share) });
    sent(matt);
    sent(glossy);
  };
  if (light.kind === 'point') sent(pointLight(receiver, seen));
  else if (light.kind === 'sphere') sphereLight(receiver, light.radius, seen, send);
  else areaLight(receiver, { kind: light.kind, radius: light.radius }, seen, send);
}

/** E = D² I/d² with d in the lamp's frame. */
function pointLight(
  { brdf: look, rest }: LitSurface,
  { n, frame, center, shape, aliveFactor: shining }: LightAtEmission,
): ReflectedLight {
  const open = shape && shapingFactor({ ...shape, front: frontOf(shape) }, normalize(center).negate());
  const fall = dot(center, center).max(1e-12).reciprocal();
  const share = [open, shining?.(center)].reduce<Float>(
    (product, factor) => (factor ? product.mul(factor) : product),
    fall,
  );
  return { share: evaluateBrdf(look, rest.into(n)).mul(share), ...incidentSpectrumBetween(n, rest, frame) };
}
