import type { Hit } from '../acceleration/ray.ts';
import { type LightingContext, rayBack, restFrameOf } from '../lights/lightingContext.ts';
import { surfaceAt } from '../materials/surface.ts';
import { cosineDirection, toHemisphere } from '../sampling/directions.ts';
import { pixelSequence } from '../sampling/pixelSequence.ts';
import { reflectionOrigin } from './rayOrigin.ts';
import { visibility } from './transmittance.ts';

const OPENNESS_RAYS = 64;

/**
 * ∫ V cos θ dω/π over the hemisphere in the rest frame: the cosine-weighted fraction of the sky that is unoccluded, V = 1 where light from infinity is
 * transmitted. 64 rays leave an error of a few percent. docs/physics.md §9.5.
 */
export function openness(lighting: LightingContext, hit: Hit): number {
  const { scene } = lighting;
  const at = reflectionOrigin(scene, hit);
  const frame = restFrameOf(lighting, hit.velocity);
  const { normal } = surfaceAt(scene, hit);
  const bits = new Int32Array(Float32Array.from(hit.position).buffer);
  const sequence = pixelSequence(bits[0] ^ bits[2], bits[1], bits[2]);
  let open = 0;
  for (let i = 0; i < OPENNESS_RAYS; i++) {
    const L = cosineDirection(normal, sequence(i));
    const ray = rayBack(lighting, at, frame.toWorld(toHemisphere(at.geometricNormal, L)));
    open += visibility(scene, { ray, begin: at.clearance, from: hit }, Number.POSITIVE_INFINITY).fraction;
  }
  return open / OPENNESS_RAYS;
}
