import type { Light, Scene } from '../../scene/types.ts';
import { CYLINDER_LIGHT } from './kinds/cylinderLight.ts';
import { DISK_LIGHT } from './kinds/diskLight.ts';
import { DISTANT_LIGHT } from './kinds/distantLight.ts';
import { DOME_LIGHT } from './kinds/domeLight.ts';
import type { LightTracer } from './kinds/lightTracer.ts';
import { NIGHT_SKY } from './kinds/nightSky.ts';
import { RECT_LIGHT } from './kinds/rectLight.ts';
import { SPHERE_LIGHT } from './kinds/sphereLight.ts';
import type { TracedLight } from './lightingContext.ts';

/** The reference renderer's light sampling, by kind. */
const LIGHTS: { readonly [K in Light['kind']]: LightTracer<Extract<Light, { readonly kind: K }>> } = {
  distant: DISTANT_LIGHT,
  sphere: SPHERE_LIGHT,
  rect: RECT_LIGHT,
  disk: DISK_LIGHT,
  cylinder: CYLINDER_LIGHT,
  dome: DOME_LIGHT,
  stars: NIGHT_SKY,
};

export function tracedLight(light: Light, scene: Scene): TracedLight {
  const tracer: LightTracer<Light> = LIGHTS[light.kind];
  return tracer.trace(light, scene);
}
