import { departureAt } from './departure.ts';
import { cosineDirection, turnedTo } from './directions.ts';
import { frameOf, type Lighting, rayBack } from './lighting.ts';
import { transmitted } from './passage.ts';
import { pixelSequence } from './sequence.ts';
import { surfaceAt } from './surface.ts';
import type { Hit } from './types.ts';

/** Directions that are asked for. */
const RAYS = 64;

/**
 * ∫ V cos θ dω/π over the hemisphere of the rest frame: the share of the sky that a surface sees, weighted by the cosine, V = 1 where light from afar comes
 * through. By as many rays as leave an error of a few percent.
 */
export function openness(lighting: Lighting, hit: Hit): number {
  const { scene } = lighting;
  const at = departureAt(scene, hit);
  const frame = frameOf(lighting, hit.velocity);
  const { normal } = surfaceAt(scene, hit);
  const bits = new Int32Array(Float32Array.from(hit.position).buffer);
  const numbers = pixelSequence(bits[0] ^ bits[2], bits[1], bits[2]);
  let open = 0;
  for (let i = 0; i < RAYS; i++) {
    const L = cosineDirection(normal, numbers(i));
    const ray = rayBack(lighting, at, frame.out(turnedTo(at.side, L)));
    open += transmitted(scene, { ray, begin: at.clear, from: hit }, Number.POSITIVE_INFINITY);
  }
  return open / RAYS;
}
