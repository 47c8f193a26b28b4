import type { Float } from '../../shaders/types.ts';
import { IRRADIANCE_POWER, type RadianceAccumulator } from '../color/radiance.ts';
import type { LitSurface } from '../lights/kinds/litSurface.ts';
import type { AddReflected, ReflectedLight } from '../lights/kinds/surfaceInLightFrame.ts';
import { type LightAtEmission, lightAtEmission } from '../lights/lightAtEmission.ts';
import { lightShader } from '../lights/lightShaders.ts';
import type { LightTexels } from '../lights/lightTexels.ts';

/** The share of a local light that gets to a surface past what is in its way; undefined: all of it. */
export type LocalLightVisibility = (light: LightTexels, emitter: LightAtEmission) => Float | undefined;

/** Adds what a surface reflects of a local light. */
export function addLocalLight(
  receiver: LitSurface,
  light: LightTexels,
  accumulator: RadianceAccumulator,
  visibility?: LocalLightVisibility,
): void {
  const { dx, time, uniforms } = receiver;
  const emitter = lightAtEmission(light, dx, time, uniforms);
  const visible = visibility?.(light, emitter)?.toVar();
  const { source, colored } = light;
  const addOne = ({ share, D }: ReflectedLight): void =>
    accumulator.addReflected(
      light.color,
      visible ? share.mul(visible) : share,
      { ...(D && { D }), ...(source && { source }), ...(colored !== undefined && { colored }) },
      IRRADIANCE_POWER,
    );
  const add: AddReflected = (matt, glossy) => {
    if (glossy && !matt.D && !glossy.D) return addOne({ share: matt.share.add(glossy.share) });
    addOne(matt);
    if (glossy) addOne(glossy);
  };
  lightShader(light.kind).addReflected(receiver, light, emitter, add);
}
