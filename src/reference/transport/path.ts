import type { Random } from '../../math/random.ts';
import { negate, normalize, type Vec3, ZERO } from '../../math/vec3.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { isLuminous, placementIn } from '../../scene/views/views.ts';
import { maxOfFilter, neutralFilter, scaleFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import type { SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import { type Hit, lightOf, type SpacetimeRay } from '../acceleration/ray.ts';
import { nearestHit, type TracedScene } from '../intersection/tracedScene.ts';
import { createLightingContext } from '../lights/createLightingContext.ts';
import { type LightingContext, rayBack, restFrameOf } from '../lights/lightingContext.ts';
import type { LightOptions } from '../lights/lightOptions.ts';
import { type Brdf, brdfOf, diffuseLobe, glossyLobes, type Lobe } from '../materials/brdf.ts';
import { type SurfacePoint, surfaceAt } from '../materials/surface.ts';
import { chooseBranch, toHemisphere } from '../sampling/directions.ts';
import { restFrame, WORLD_FRAME } from '../spectral/restFrame.ts';
import { NO_LIGHT, plus, type SampledRadiance, times } from '../spectral/sampledRadiance.ts';
import { sensorsOf } from '../spectral/sensors.ts';
import { emittedSpectrum } from '../spectral/sourceSpectrum.ts';
import { type LightReceiver, RADIANCE_POWER, receivedLight, type Sensor } from '../spectral/spectralContext.ts';
import { directLight } from './directLight.ts';
import { type GlassBody, glassRadiance, isGlass } from './glass.ts';
import { reflectionOrigin, type SurfaceOrigin } from './rayOrigin.ts';
import { absorbed, clearShare, isTransmissive, straightPass } from './transmissive.ts';
import { coverage, isElsewhere, type RaySegment } from './transmittance.ts';

/** Upper bound of successive specular reflections and refractions. */
const MAX_SPECULAR_DEPTH = 8;
/** Upper bound of alpha-blended layers along a ray. */
const MAX_TRANSPARENT_LAYERS = 64;
/** Diffuse rays at surfaces seen directly, where most of a picture's noise comes from. */
const CAMERA_DIFFUSE_RAYS = 2;
/** A specular ray of weight w is traced with the probability 4w. */
const SPECULAR_PROBABILITY_FACTOR = 4;
/** Rays end where their transmittance falls below this. */
const MIN_TRANSMITTANCE = 1e-4;

/** The receiver of light at the beginning of a ray, and how far the path is continued. */
export interface PathState extends LightReceiver {
  /** Camera paths see front sides and all that these reflect. Other paths gather light from both sides, reflected as far as `bounces` allows. */
  readonly isCameraPath: boolean;
  /** Whether the sky includes the discs of distant lights. */
  readonly includesSunDiscs: boolean;
  readonly bounces: number;
  readonly specularDepth: number;
}

/**
 * One sample of the light that arrives along a ray, from s = 0 on: linear sRGB radiance for a receiver with proper velocity u (world frame, units of c).
 * Scattered light is shifted by the Doppler factor between two rest frames at each step (docs/physics.md §6.2); in views without light D = 1.
 * The mean over many samples is the picture. `random` in 0 … 1.
 */
export function radiance(
  scene: TracedScene,
  ray: SpacetimeRay,
  receiver: { readonly u: Vec3 },
  settings: RenderSettings,
  options: LightOptions,
  random: Random,
  { context, color }: Sensor = sensorsOf(settings)(random),
): Vec3 {
  const lighting = createLightingContext(scene, settings, options, receiver.u, random);
  const frame = restFrame(isLuminous(settings) ? receiver.u : ZERO);
  // In a slice, rays meet the sky in the observer's own directions.
  const toward = placementIn(settings).skyDirection(ray.dx, receiver.u);
  const path = {
    frame,
    context,
    isCameraPath: true,
    includesSunDiscs: true,
    bounces: options.bounces,
    specularDepth: MAX_SPECULAR_DEPTH,
  };
  return color(incidentLight(lighting, { ray, begin: 0, toward: normalize(toward) }, path));
}

/** A ray segment, and the direction of the sky behind it. */
interface ScatteredRay extends RaySegment {
  readonly toward: Vec3;
}

/** Light along a ray, through all transparent layers to the first opaque surface or the sky. */
function incidentLight(lighting: LightingContext, start: ScatteredRay, path: PathState): SampledRadiance {
  const { scene } = lighting;
  let beam: RaySegment = start;
  let sum = NO_LIGHT;
  let throughput = 1;
  for (let layer = 0; layer < MAX_TRANSPARENT_LAYERS; layer++) {
    const hit = nextHit(lighting, beam, path);
    if (!hit) return plus(sum, skyLight(lighting, start.toward, path), throughput);
    const glass = path.isCameraPath && isGlass(lighting, hit);
    const straight = !glass && isTransmissive(scene, hit);
    const opacity = glass || straight ? 1 : coverage(scene, hit);
    const light = straight
      ? veilLight(lighting, { ...start, ...beam }, hit, path)
      : surfaceLight(lighting, start, hit, path, glass);
    sum = plus(sum, light, throughput * opacity);
    throughput *= 1 - opacity;
    if (throughput < MIN_TRANSMITTANCE) break;
    beam = { ray: beam.ray, begin: hit.s, from: hit };
  }
  return sum;
}

function nextHit(lighting: LightingContext, beam: RaySegment, { isCameraPath }: PathState): Hit | undefined {
  const { scene } = lighting;
  return nearestHit(scene, beam.ray, {
    begin: beam.begin,
    accepts: (hit) =>
      isElsewhere(scene, beam, hit) &&
      (!isCameraPath || hit.front || scene.objects[hit.object].mesh.doubleSided) &&
      (coverage(scene, hit) > 0 || (isCameraPath && isGlass(lighting, hit))),
  });
}

function skyLight({ sky }: LightingContext, n: Vec3, path: PathState): SampledRadiance {
  return receivedLight(path, n, WORLD_FRAME, RADIANCE_POWER, ({ context }) => {
    if (!path.includesSunDiscs) return sky.radiance(n, context);
    const discs = sky.sunDiscs(n, context);
    return sky.isSeen ? plus(sky.radiance(n, context), discs) : discs;
  });
}

/** Light that the surface sends to the receiver, as it arrives there. */
function surfaceLight(
  lighting: LightingContext,
  { ray }: ScatteredRay,
  hit: Hit,
  path: PathState,
  glass: boolean,
): SampledRadiance {
  const n = normalize(lightOf(ray, hit).dx);
  const frame = restFrameOf(lighting, hit.velocity);
  const point = surfaceAt(lighting.scene, hit);
  const V = negate(frame.fromWorld(n));
  const sent = glass ? glassLight : solidLight;
  return receivedLight(path, n, frame, RADIANCE_POWER, (here) => sent(lighting, hit, point, V, { ...path, ...here }));
}

/** Light of a transmissive surface that no camera sees: of what lies straight behind it, and its own. */
function veilLight(lighting: LightingContext, beam: ScatteredRay, hit: Hit, path: PathState): SampledRadiance {
  const { scene } = lighting;
  const n = normalize(lightOf(beam.ray, hit).dx);
  const frame = restFrameOf(lighting, hit.velocity);
  const point = surfaceAt(scene, hit);
  return receivedLight(path, n, frame, RADIANCE_POWER, (there) => {
    const here = { ...path, ...there };
    const own = solidLight(lighting, hit, point, negate(frame.fromWorld(n)), here);
    if (path.specularDepth === 0) return own;
    const { filter, volume, way } = straightPass(scene, beam, hit, frame);
    const onward = { ...here, specularDepth: path.specularDepth - 1 };
    const behind = incidentLight(lighting, { ...beam, begin: hit.s, from: hit }, onward);
    const passed = there.context.filtered(absorbed(there.context, behind, volume, way), filter);
    return plus(passed, own, 1 - clearShare(point));
  });
}

/** Radiance of a surface towards V, in its rest frame: emitted, and reflected if the path continues. */
function solidLight(
  lighting: LightingContext,
  hit: Hit,
  point: SurfacePoint,
  V: Vec3,
  here: PathState,
): SampledRadiance {
  const own = here.context.emitted(emittedSpectrum(point));
  const coated = point.clearcoat !== undefined || point.sheen !== undefined;
  if (!coated && !here.isCameraPath && here.bounces === 0) return own;
  const brdf = brdfOf(point, V);
  const emitted = coated ? times(own, brdf.passed) : own;
  if (!here.isCameraPath && here.bounces === 0) return emitted;
  const at = reflectionOrigin(lighting.scene, hit);
  const direct = plus(emitted, directLight(lighting, at, brdf, here));
  return plus(direct, indirectLight(lighting, at, brdf, here), point.occlusion);
}

/**
 * Light of the sky and of other surfaces. For surfaces seen directly both lobes of the BRDF are traced, weak specular ones by Russian roulette unless
 * their direction was sampled from the sky; after that one lobe is chosen at random.
 */
function indirectLight(lighting: LightingContext, at: SurfaceOrigin, brdf: Brdf, here: PathState): SampledRadiance {
  const { options, random } = lighting;
  const continuesCameraPath = here.isCameraPath && options.mirrors && here.specularDepth > 0;
  const scatters = here.bounces > 0;
  const mirrors = continuesCameraPath || scatters;
  const glossy = glossyLobes(brdf).map((lobe) => {
    const sample = sampleDirection(lighting, lobe, here);
    return { sample, weight: mirrors ? maxOfFilter(sample.lobeWeight) : 0 };
  });
  const d = scatters ? maxOfFilter(brdf.diffuse) : 0;
  const diffuse = (): SampledRadiance => diffuseLight(lighting, at, brdf, here);
  const mirror = (sample: DirectionSample): SampledRadiance =>
    weightedLight(lighting, at, sample, specularPath(here, continuesCameraPath), here);
  let sum = NO_LIGHT;
  if (here.isCameraPath && here.specularDepth === MAX_SPECULAR_DEPTH) {
    if (d > 0) for (let k = 0; k < CAMERA_DIFFUSE_RAYS; k++) sum = plus(sum, diffuse(), 1 / CAMERA_DIFFUSE_RAYS);
    for (const { sample, weight } of glossy) {
      const chance = sample.fromSky && weight > 0 ? 1 : Math.min(1, SPECULAR_PROBABILITY_FACTOR * weight);
      if (random() < chance) sum = plus(sum, mirror(sample), 1 / chance);
    }
    return sum;
  }
  const all = glossy.reduce((total, { weight }) => total + weight, d);
  if (all === 0) return NO_LIGHT;
  let left = random() * all - d;
  if (left < 0) return times(diffuse(), all / d);
  for (const { sample, weight } of glossy) {
    if (left < weight) return times(mirror(sample), all / weight);
    left -= weight;
  }
  return NO_LIGHT;
}

const specularPath = (here: PathState, continuesCameraPath: boolean): PathState =>
  continuesCameraPath
    ? { ...here, includesSunDiscs: false, specularDepth: here.specularDepth - 1 }
    : { ...here, includesSunDiscs: false, isCameraPath: false, bounces: here.bounces - 1 };

function diffuseLight(lighting: LightingContext, at: SurfaceOrigin, brdf: Brdf, here: PathState): SampledRadiance {
  const onward = { ...here, isCameraPath: false, includesSunDiscs: false, bounces: here.bounces - 1 };
  return weightedLight(lighting, at, sampleDirection(lighting, diffuseLobe(brdf), here), onward, here);
}

/** A sampled direction in the rest frame. */
interface DirectionSample {
  readonly L: Vec3;
  /** BRDF · cos divided by the lobe's density, and the lobe's density divided by the combined density of lobe and sky. */
  readonly lobeWeight: SpectralFilter;
  readonly misWeight: number;
  /** Sampled from the sky instead of the lobe. */
  readonly fromSky: boolean;
}

/**
 * Samples the lobe or, with the sampler's probability, the sky, and weights by the combined density (one-sample MIS with the balance heuristic,
 * Veach 1997, §9.2.4), so no weight exceeds 2. The sky's density is transformed by dΩ′ = dΩ/D².
 */
function sampleDirection(
  { sky: { sampler }, random }: LightingContext,
  lobe: Lobe,
  { frame }: PathState,
): DirectionSample {
  const { pdf } = lobe;
  if (!sampler || !pdf) {
    const L = lobe.sample(random);
    return { L, lobeWeight: lobe.weight(L), misWeight: 1, fromSky: false };
  }
  const { isFirst: isBright, rest } = chooseBranch(sampler.probability, random);
  const L = isBright ? frame.fromWorld(sampler.sample(rest)) : lobe.sample(rest);
  const own = pdf(L);
  if (own === 0) return { L, lobeWeight: neutralFilter(0), misWeight: 0, fromSky: isBright };
  const n = frame.toWorld(L);
  const all = (1 - sampler.probability) * own + sampler.probability * sampler.pdf(n) * frame.doppler(n) ** 2;
  return { L, lobeWeight: lobe.weight(L), misWeight: own / all, fromSky: isBright };
}

/** Light from a sampled direction, reflected at `here`. */
function weightedLight(
  lighting: LightingContext,
  at: SurfaceOrigin,
  { L, lobeWeight, misWeight }: DirectionSample,
  path: PathState,
  here: PathState,
): SampledRadiance {
  if (misWeight === 0) return NO_LIGHT;
  return here.context.filtered(lightFromDirection(lighting, at, L, path), scaleFilter(lobeWeight, misWeight));
}

/** Radiance from the direction L in the rest frame, as received there. Directions below the triangle are reflected to above it. */
function lightFromDirection(lighting: LightingContext, at: SurfaceOrigin, L: Vec3, path: PathState): SampledRadiance {
  const n = path.frame.toWorld(toHemisphere(at.geometricNormal, L));
  return incidentLight(lighting, { ray: rayBack(lighting, at, n), begin: at.clearance, from: at.hit, toward: n }, path);
}

/** Glass: diffuse and emitted light weighted by opacity, highlights of lights, and reflected and refracted light. */
function glassLight(
  lighting: LightingContext,
  hit: Hit,
  point: SurfacePoint,
  V: Vec3,
  here: PathState,
): SampledRadiance {
  const { opacity, transmission, metallic } = point;
  if (transmission !== undefined && metallic > 0) {
    const clear = glassLight(lighting, hit, { ...point, metallic: 0 }, V, here);
    return plus(times(clear, 1 - metallic), solidLight(lighting, hit, { ...point, metallic: 1 }, V, here), metallic);
  }
  const solid = brdfOf({ ...point, metallic: 0 }, V);
  const opaque = 1 - clearShare(point);
  const brdf = { ...solid, diffuse: scaleFilter(solid.diffuse, opaque) };
  const at = reflectionOrigin(lighting.scene, hit);
  const glow = here.context.emitted(emittedSpectrum(point));
  const own = plus(directLight(lighting, at, brdf, here), glow, transmission === undefined ? opacity : 1);
  const diffuse = opaque > 0 && here.bounces > 0 ? diffuseLight(lighting, at, brdf, here) : NO_LIGHT;
  const onward = { ...here, includesSunDiscs: true, specularDepth: here.specularDepth - 1 };
  const glass: GlassBody = {
    frame: here.frame,
    context: here.context,
    point,
    branches: here.specularDepth === MAX_SPECULAR_DEPTH,
    outside: (from, L) => lightFromDirection(lighting, from, L, onward),
    along: (beam) => incidentLight(lighting, { ...beam, toward: normalize(beam.ray.dx) }, onward),
  };
  const clear = here.specularDepth > 0 ? glassRadiance(lighting, hit, at, V, glass) : NO_LIGHT;
  return plus(plus(own, diffuse, point.occlusion), clear);
}
