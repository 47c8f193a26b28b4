import { dot, normalize, vec3 } from 'three/tsl';
import type { SphereLight } from '../../../scene/types.ts';
import type { Float } from '../../../shaders/types.ts';
import { evaluateBrdf } from '../../brdf/brdf.ts';
import type { LightAtEmission } from '../lightAtEmission.ts';
import { frontOf, shapingFactor } from '../lightShaping.ts';
import { incidentSpectrumBetween } from '../restFrame.ts';
import type { LightShader } from './lightShader.ts';
import type { LitSurface } from './litSurface.ts';
import type { ReflectedLight } from './surfaceInLightFrame.ts';

/** A sphere of radius 0. */
export const POINT_LIGHT: LightShader<SphereLight> = {
  maxUnrolled: 4,
  needsAxes: false,
  extents: ({ radius }) => ({ x: 1, y: 1, radius, gain: 1 }),
  bulbRadius: ({ radius }) => radius,
  addReflected: (receiver, _, emitter, add) => add(pointLight(receiver, emitter)),
  silhouette: () => [vec3(0), vec3(0)],
  isParallelogram: false,
};

/** E = D² I/d², d in the light's rest frame. */
function pointLight(
  { brdf, rest }: LitSurface,
  { n, frame, center, shape, aliveFactor }: LightAtEmission,
): ReflectedLight {
  const shaping = shape && shapingFactor({ ...shape, front: frontOf(shape) }, normalize(center).negate());
  const falloff = dot(center, center).max(1e-12).reciprocal();
  const factor = [shaping, aliveFactor?.(center)].reduce<Float>(
    (product, factor) => (factor ? product.mul(factor) : product),
    falloff,
  );
  return { reflectance: evaluateBrdf(brdf, rest.into(n)).mul(factor), ...incidentSpectrumBetween(n, rest, frame) };
}
