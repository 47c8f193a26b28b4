import { addScaled, dot, length, negate, scale, type Vec3 } from '../../math/vec3.ts';
import type { Hit } from '../acceleration/ray.ts';
import { nearestHit } from '../intersection/tracedScene.ts';
import { type LightingContext, rayBackInside } from '../lights/lightingContext.ts';
import { sampleVisibleNormal } from '../materials/brdf.ts';
import { materialOf } from '../materials/material.ts';
import { type SurfacePoint, surfaceAt } from '../materials/surface.ts';
import { reflect, toHemisphere } from '../sampling/directions.ts';
import type { RestFrame } from '../spectral/restFrame.ts';
import { NO_LIGHT, plus, type SampledRadiance, times } from '../spectral/sampledRadiance.ts';
import { type SurfaceOrigin, transmissionOrigin } from './rayOrigin.ts';
import { coverage, isElsewhere, type RaySegment } from './transmittance.ts';

/** Upper bound of successive reflections inside a body. */
const MAX_INTERNAL_REFLECTIONS = 16;

/** Whether the hit is on a transparent body; double-sided sheets, which have no inside, are not. */
export function isGlass({ scene, options }: LightingContext, hit: Hit): boolean {
  if (!options.glass || scene.objects[hit.object].mesh.doubleSided) return false;
  const { opacity, opacityThreshold } = materialOf(scene, hit);
  return opacity < 1 && opacityThreshold === 0;
}

/** The transparent body at a hit, and functions that trace light around it. */
export interface GlassBody {
  /** Its rest frame, constant while light is inside. */
  readonly frame: RestFrame;
  readonly point: SurfacePoint;
  /** Follow both the reflected and the refracted ray; otherwise one of them, chosen at random. */
  readonly branches: boolean;
  /** Radiance from a direction of the rest frame, outside the body. */
  outside(from: SurfaceOrigin, direction: Vec3): SampledRadiance;
  /** Radiance along a segment inside the body that does not end at the body's own inner side. */
  along(beam: RaySegment): SampledRadiance;
}

/** Radiance of the body towards V by reflection and refraction, in its rest frame. */
export function glassRadiance(
  lighting: LightingContext,
  hit: Hit,
  at: SurfaceOrigin,
  V: Vec3,
  glass: GlassBody,
): SampledRadiance {
  const { ior, normal, opacity, roughness } = glass.point;
  const H = roughness < 0.05 ? normal : sampleVisibleNormal(normal, V, roughness * roughness, lighting.random);
  const d = negate(V);
  const F = dielectricFresnel(dot(V, H), ior);
  const mirror = (): SampledRadiance => glass.outside(at, reflect(d, H));
  const refract = (): SampledRadiance => {
    const inside = transmissionOrigin(lighting.scene, hit);
    const inward = refracted(d, H, 1 / ior);
    return inward
      ? times(insideRadiance(lighting, inside, toHemisphere(inside.geometricNormal, inward), glass), 1 - opacity)
      : NO_LIGHT;
  };
  if (glass.branches) return plus(times(mirror(), F), refract(), 1 - F);
  return lighting.random() < F ? mirror() : refract();
}

/** Radiance from a direction inside the body: of what is hit there, or through the body's sides. */
function insideRadiance(
  lighting: LightingContext,
  from: SurfaceOrigin,
  direction: Vec3,
  glass: GlassBody,
  sides = MAX_INTERNAL_REFLECTIONS,
): SampledRadiance {
  const { scene, random } = lighting;
  const { frame, point } = glass;
  const ray = rayBackInside(lighting, from, direction, frame, point.ior);
  const beam: RaySegment = { ray, begin: from.clearance / length(ray.dx), from: from.hit };
  const hit = nearestHit(scene, ray, {
    begin: beam.begin,
    accepts: (found) => isElsewhere(scene, beam, found) && (coverage(scene, found) > 0 || isGlass(lighting, found)),
  });
  if (!hit) return glass.outside(from, direction);
  if (hit.object !== from.hit.object || hit.front) return glass.along(beam);
  const N = surfaceAt(scene, hit).normal;
  const F = dielectricFresnel(-dot(direction, N), 1 / point.ior);
  const out = refracted(direction, N, point.ior);
  if (!out || random() < F) {
    if (sides === 0) return NO_LIGHT;
    const back = {
      ...transmissionOrigin(scene, hit),
      geometricNormal: scale(transmissionOrigin(scene, hit).geometricNormal, -1),
    };
    return insideRadiance(lighting, back, toHemisphere(back.geometricNormal, reflect(direction, N)), glass, sides - 1);
  }
  return glass.outside(transmissionOrigin(scene, hit), out);
}

/**
 * The direction behind a surface with the normal N (on the side that d comes from): t = ηd + (η cos − √(1 − η²(1 − cos²))) N,
 * cos = −d·N, η = n₁/n₂ of the sides. Returns undefined at total internal reflection. Source: Snell's law as a vector.
 */
export function refracted(d: Vec3, N: Vec3, eta: number): Vec3 | undefined {
  const cos = -dot(d, N);
  const rest = 1 - eta * eta * (1 - cos * cos);
  if (rest < 0) return undefined;
  return addScaled(scale(d, eta), N, eta * cos - Math.sqrt(rest));
}

/** Fresnel reflectance of unpolarised light at the incidence cosine `cos`, into a medium of the relative refractive index n. Source: Born & Wolf §1.5. */
export function dielectricFresnel(cos: number, n: number): number {
  const c = Math.min(Math.max(cos, 0), 1);
  const rest = n * n - 1 + c * c;
  if (rest <= 0) return 1;
  const g = Math.sqrt(rest);
  const s = (c - g) / (c + g);
  const p = (n * n * c - g) / (n * n * c + g);
  return (s * s + p * p) / 2;
}
