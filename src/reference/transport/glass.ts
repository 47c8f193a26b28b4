import { addScaled, dot, length, negate, scale, type Vec3 } from '../../math/vec3.ts';
import { dispersedIndex } from '../../physics/optics/dispersion.ts';
import type { Hit } from '../acceleration/ray.ts';
import { nearestHit } from '../intersection/tracedScene.ts';
import { type LightingContext, rayBackInside } from '../lights/lightingContext.ts';
import { sampleVisibleNormal } from '../materials/brdf.ts';
import { materialOf } from '../materials/material.ts';
import { type SurfacePoint, surfaceAt } from '../materials/surface.ts';
import { reflect, toHemisphere } from '../sampling/directions.ts';
import type { RestFrame } from '../spectral/restFrame.ts';
import { NO_LIGHT, onlyValue, plus, type SampledRadiance, times } from '../spectral/sampledRadiance.ts';
import type { SpectralContext } from '../spectral/spectralContext.ts';
import { dielectricFresnel, refracted } from './fresnel.ts';
import { type SurfaceOrigin, transmissionOrigin } from './rayOrigin.ts';
import { absorbed, clearShare, isThin, isTransmissive } from './transmissive.ts';
import { coverage, isElsewhere, type RaySegment } from './transmittance.ts';

/** Upper bound of successive reflections inside a body. */
const MAX_INTERNAL_REFLECTIONS = 16;

/** Whether the hit is on something transmissive, or on a transparent body; double-sided sheets, which have no inside, are no bodies. */
export function isGlass({ scene, options }: LightingContext, hit: Hit): boolean {
  if (isTransmissive(scene, hit)) return true;
  if (!options.glass || scene.objects[hit.object].mesh.doubleSided) return false;
  const { opacity, opacityThreshold } = materialOf(scene, hit);
  return opacity < 1 && opacityThreshold === 0;
}

/** The transparent body at a hit, and functions that trace light around it. */
export interface GlassBody {
  /** Its rest frame, constant while light is inside. */
  readonly frame: RestFrame;
  readonly context: SpectralContext;
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
  const { ior, normal, roughness, filter, transmission, specular } = glass.point;
  const H = roughness < 0.05 ? normal : sampleVisibleNormal(normal, V, roughness * roughness, lighting.random);
  const d = negate(V);
  const F = dielectricFresnel(dot(V, H), ior) * (specular?.factor ?? 1);
  const share = clearShare(glass.point);
  const mirror = (): SampledRadiance => glass.outside(at, reflect(d, H));
  const pass = (n: number): SampledRadiance => {
    const inside = transmissionOrigin(lighting.scene, hit);
    if (isThin(lighting.scene, hit) && transmission !== undefined) {
      // What the sheet's mirror image would reflect.
      const across = reflect(d, H);
      return glass.outside(inside, addScaled(across, normal, -2 * dot(across, normal)));
    }
    const inward = refracted(d, H, 1 / n);
    if (!inward) return NO_LIGHT;
    return insideRadiance(lighting, inside, toHemisphere(inside.geometricNormal, inward), glass, n);
  };
  const refract = (): SampledRadiance => {
    const light = times(dispersed(lighting, hit, glass, pass), share);
    return transmission === undefined ? light : glass.context.filtered(light, filter);
  };
  if (glass.branches) return plus(times(mirror(), F), refract(), 1 - F);
  return lighting.random() < F ? mirror() : refract();
}

/** Wavelengths that are followed apart where glass is seen directly, and elsewhere. */
const [SEEN_WAVELENGTHS, OTHER_WAVELENGTHS] = [4, 1];

/** Light that passes glass of the refractive index n; where that depends on the wavelength in the glass's rest frame, of some wavelengths chosen at random. */
function dispersed(
  { scene, random }: LightingContext,
  hit: Hit,
  { context, point: { ior }, branches }: GlassBody,
  pass: (n: number) => SampledRadiance,
): SampledRadiance {
  const { dispersion = 0 } = materialOf(scene, hit);
  const { samples } = context;
  if (dispersion === 0 || samples.length === 0 || isThin(scene, hit)) return pass(ior);
  const count = Math.min(branches ? SEEN_WAVELENGTHS : OTHER_WAVELENGTHS, samples.length);
  let sum = NO_LIGHT;
  for (let k = 0; k < count; k++) {
    const i = Math.min(Math.floor(((k + random()) / count) * samples.length), samples.length - 1);
    const light = pass(dispersedIndex(ior, dispersion, samples[i]));
    sum = plus(sum, onlyValue(light, i, samples.length), 1 / count);
  }
  return sum;
}

/** Radiance from a direction inside the body: of what is hit there, or through the body's sides. */
function insideRadiance(
  lighting: LightingContext,
  from: SurfaceOrigin,
  direction: Vec3,
  glass: GlassBody,
  n: number,
  sides = MAX_INTERNAL_REFLECTIONS,
): SampledRadiance {
  const { scene, random } = lighting;
  const { frame, context } = glass;
  const ray = rayBackInside(lighting, from, direction, frame, n);
  const beam: RaySegment = { ray, begin: from.clearance / length(ray.dx), from: from.hit };
  const hit = nearestHit(scene, ray, {
    begin: beam.begin,
    accepts: (found) => isElsewhere(scene, beam, found) && (coverage(scene, found) > 0 || isGlass(lighting, found)),
  });
  if (!hit) return glass.outside(from, direction);
  // The ray is parametrized by its length in the body's rest frame.
  const left = (light: SampledRadiance): SampledRadiance =>
    absorbed(context, light, materialOf(scene, from.hit).volume, hit.s);
  if (hit.object !== from.hit.object || hit.front) return left(glass.along(beam));
  const N = surfaceAt(scene, hit).normal;
  const F = dielectricFresnel(-dot(direction, N), 1 / n);
  const out = refracted(direction, N, n);
  if (!out || random() < F) {
    if (sides === 0) return NO_LIGHT;
    const back = {
      ...transmissionOrigin(scene, hit),
      geometricNormal: scale(transmissionOrigin(scene, hit).geometricNormal, -1),
    };
    return left(
      insideRadiance(lighting, back, toHemisphere(back.geometricNormal, reflect(direction, N)), glass, n, sides - 1),
    );
  }
  return left(glass.outside(transmissionOrigin(scene, hit), out));
}
