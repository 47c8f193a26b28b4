import type { Int } from '../../shaders/types.ts';
import { IRRADIANCE_POWER, type RadianceAccumulator } from '../color/radiance.ts';
import type { LitSurface } from './kinds/litSurface.ts';
import type { AddReflected, ReflectedLight } from './kinds/surfaceInLightFrame.ts';
import { lightAtEmission } from './lightAtEmission.ts';
import { lightShader } from './lightShaders.ts';
import type { LightTexels } from './lightTexels.ts';

/** Adds the light of a local light that a surface reflects. `slot`: index among the shadow casters; undefined if it is none. */
export function addLocalLight(
  surface: LitSurface,
  light: LightTexels,
  slot: Int | number | undefined,
  accumulator: RadianceAccumulator,
): void {
  const { dx, time, uniforms } = surface;
  const emitter = lightAtEmission(light, dx, time, uniforms);
  const visibility = surface.visibility?.ofLocalLight(slot, light, emitter)?.toVar();
  const { source, colored } = light;
  const addOne = ({ reflectance, D }: ReflectedLight): void =>
    accumulator.addReflected(
      light.color,
      visibility ? reflectance.mul(visibility) : reflectance,
      { ...(D && { D }), ...(source && { source }), ...(colored !== undefined && { colored }) },
      IRRADIANCE_POWER,
    );
  const add: AddReflected = (diffuse, specular) => {
    if (specular && !diffuse.D && !specular.D)
      return addOne({ reflectance: diffuse.reflectance.add(specular.reflectance) });
    addOne(diffuse);
    if (specular) addOne(specular);
  };
  lightShader(light.kind).addReflected(surface, light, emitter, add);
}
