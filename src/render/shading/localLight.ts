import type { Float } from '../../shaders/types.ts';
import { IRRADIANCE_POWER, type RadianceAccumulator } from '../color/radiance.ts';
import type { LitSurface } from '../lights/kinds/litSurface.ts';
import type { AddReflected, ReflectedLight } from '../lights/kinds/surfaceInLightFrame.ts';
import { type LightAtEmission, lightAtEmission } from '../lights/lightAtEmission.ts';
import { lightShader } from '../lights/lightShaders.ts';
import type { LightTexels } from '../lights/lightTexels.ts';

/** The visibility of a local light at a surface; undefined: fully visible. */
export type LocalLightVisibility = (light: LightTexels, emitter: LightAtEmission) => Float | undefined;

/** Adds the light of a local light that a surface reflects. */
export function addLocalLight(
  receiver: LitSurface,
  light: LightTexels,
  accumulator: RadianceAccumulator,
  visibility?: LocalLightVisibility,
): void {
  const { dx, time, uniforms } = receiver;
  const emitter = lightAtEmission(light, dx, time, uniforms);
  const visibilityHere = visibility?.(light, emitter)?.toVar();
  const { source, colored } = light;
  const addOne = ({ share: reflectance, D }: ReflectedLight): void =>
    accumulator.addReflected(
      light.color,
      visibilityHere ? reflectance.mul(visibilityHere) : reflectance,
      { ...(D && { D }), ...(source && { source }), ...(colored !== undefined && { colored }) },
      IRRADIANCE_POWER,
    );
  const add: AddReflected = (diffuse, specular) => {
    if (specular && !diffuse.D && !specular.D) return addOne({ share: diffuse.share.add(specular.share) });
    addOne(diffuse);
    if (specular) addOne(specular);
  };
  lightShader(light.kind).addReflected(receiver, light, emitter, add);
}
