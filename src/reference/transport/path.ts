import type { Random } from '../../math/random.ts';
import { negate, normalize, type Vec3, ZERO } from '../../math/vec3.ts';
import { PLACEMENTS } from '../../physics/optics/placement.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import { maxOfFilter, neutralFilter, scaleFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import type { SpectralFilter } from '../../spectrum/reflectance/spectralFilter.ts';
import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import { nearestHit, type TracedScene } from '../intersection/tracedScene.ts';
import { createLightingContext } from '../lights/createLightingContext.ts';
import { type LightingContext, rayBack, restFrameOf } from '../lights/lightingContext.ts';
import type { LightOptions } from '../lights/lightOptions.ts';
import { type Brdf, brdfOf, diffuseLobe, type Lobe, specularLobe } from '../materials/brdf.ts';
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
import { coverage, isOtherTriangle, type RaySegment } from './transmittance.ts';

/** Mirrors in mirrors, and sides of glass, are followed so deep. */
const MAX_SPECULAR_DEPTH = 8;
/** Transparent layers, one behind the other. */
const MAX_TRANSPARENT_LAYERS = 64;
/** So many directions are asked for the diffuse light of what is seen directly: there most of a picture's noise is. */
const CAMERA_DIFFUSE_RAYS = 2;
/** What mirrors a share s of the light is followed with the probability 4s. */
const SPECULAR_PROBABILITY_FACTOR = 4;
/** What less than this part of is left of is not followed further. */
const MIN_TRANSMITTANCE = 1e-4;

/** Who looks along a ray, and how far what is met there is followed. */
export interface PathState extends LightReceiver {
  /** Whether it is a picture that forms: of front sides, by what they reflect. Else light is gathered: from both sides, and what is left of `bounces` counts. */
  readonly isCameraPath: boolean;
  /** The sky has its suns in it. */
  readonly includesSunDiscs: boolean;
  readonly bounces: number;
  readonly specularDepth: number;
}

/**
 * The light that arrives along a ray, from s = 0 on: linear sRGB radiance for a receiver with proper velocity u (world frame, units of c). Between two rest
 * frames there is one Doppler factor, so light that is scattered on its way is shifted at each step (docs/physics.md §6.2). In the
 * views that show no light, D = 1. One sample of an integral: the mean of many is the picture. `random` in 0 … 1.
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
  const view = VIEWS[settings.view];
  const frame = restFrame(view.luminous ? receiver.u : ZERO);
  // A slice has the sky of the observer's own directions.
  const toward = PLACEMENTS[view.placement(settings)].skyDirection(ray.dx, receiver.u);
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

/** A beam, and the direction in which the sky is behind it. */
interface ScatteredRay extends RaySegment {
  readonly toward: Vec3;
}

/** Through all that is transparent, to the first solid surface or the sky. */
function incidentLight(lighting: LightingContext, gaze: ScatteredRay, path: PathState): SampledRadiance {
  const { scene } = lighting;
  let beam: RaySegment = gaze;
  let sum = NO_LIGHT;
  let share = 1;
  for (let layer = 0; layer < MAX_TRANSPARENT_LAYERS; layer++) {
    const hit = nextHit(lighting, beam, path);
    if (!hit) return plus(sum, skyLight(lighting, gaze.toward, path), share);
    const glass = path.isCameraPath && isGlass(lighting, hit);
    const held = glass ? 1 : coverage(scene, hit);
    sum = plus(sum, surfaceLight(lighting, gaze, hit, path, glass), share * held);
    share *= 1 - held;
    if (share < MIN_TRANSMITTANCE) break;
    beam = { ray: beam.ray, begin: hit.s, from: hit };
  }
  return sum;
}

function nextHit(lighting: LightingContext, beam: RaySegment, { isCameraPath: eye }: PathState): Hit | undefined {
  const { scene } = lighting;
  return nearestHit(scene, beam.ray, {
    begin: beam.begin,
    accepts: (hit) =>
      isOtherTriangle(beam, hit) &&
      (!eye || hit.front || scene.objects[hit.object].mesh.doubleSided) &&
      (coverage(scene, hit) > 0 || (eye && isGlass(lighting, hit))),
  });
}

function skyLight({ sky }: LightingContext, n: Vec3, path: PathState): SampledRadiance {
  return receivedLight(path, n, WORLD_FRAME, RADIANCE_POWER, ({ context: sight }) => {
    const light = sky.radiance(n, sight);
    return path.includesSunDiscs ? plus(light, sky.sunDiscs(n, sight)) : light;
  });
}

/** What the surface sends towards the receiver, as it arrives there. */
function surfaceLight(
  lighting: LightingContext,
  { ray }: ScatteredRay,
  hit: Hit,
  path: PathState,
  glass: boolean,
): SampledRadiance {
  const n = normalize(ray.dx);
  const frame = restFrameOf(lighting, hit.velocity);
  const point = surfaceAt(lighting.scene, hit);
  const V = negate(frame.fromWorld(n));
  const sent = glass ? glassLight : solidLight;
  return receivedLight(path, n, frame, RADIANCE_POWER, (here) => sent(lighting, hit, point, V, { ...path, ...here }));
}

/** Radiance of a surface towards V, in its rest frame: what it emits, and what it reflects where that is looked at. */
function solidLight(
  lighting: LightingContext,
  hit: Hit,
  point: SurfacePoint,
  V: Vec3,
  here: PathState,
): SampledRadiance {
  const emitted = here.context.emitted(emittedSpectrum(point));
  if (!here.isCameraPath && here.bounces === 0) return emitted;
  const look = brdfOf(point, V);
  const at = reflectionOrigin(lighting.scene, hit);
  const direct = plus(emitted, directLight(lighting, at, look, here));
  return plus(direct, indirectLight(lighting, at, look, point.roughness, here), point.occlusion);
}

/**
 * Light of the sky and of other surfaces. Of what is seen directly both parts of the reflectance are followed, the faint mirroring
 * of a plastic now and then and all the more, where the sky is not bright; further on one of the parts, by chance, stands for both.
 */
function indirectLight(
  lighting: LightingContext,
  at: SurfaceOrigin,
  look: Brdf,
  roughness: number,
  here: PathState,
): SampledRadiance {
  const { options, random } = lighting;
  const eye = here.isCameraPath && options.mirrors && here.specularDepth > 0;
  const scatters = here.bounces > 0;
  const lead = sampleDirection(lighting, specularLobe(look, roughness), here);
  const d = scatters ? maxOfFilter(look.diffuse) : 0;
  const m = eye || scatters ? maxOfFilter(lead.lobeWeight) : 0;
  const diffuse = (): SampledRadiance => diffuseLight(lighting, at, look, here);
  const mirror = (): SampledRadiance => weightedLight(lighting, at, lead, specularPath(here, eye), here);
  if (here.isCameraPath && here.specularDepth === MAX_SPECULAR_DEPTH) {
    let sum = NO_LIGHT;
    if (d > 0) for (let k = 0; k < CAMERA_DIFFUSE_RAYS; k++) sum = plus(sum, diffuse(), 1 / CAMERA_DIFFUSE_RAYS);
    const chance = lead.fromSky && m > 0 ? 1 : Math.min(1, SPECULAR_PROBABILITY_FACTOR * m);
    return random() < chance ? plus(sum, mirror(), 1 / chance) : sum;
  }
  if (d + m === 0) return NO_LIGHT;
  return random() * (d + m) < d ? times(diffuse(), (d + m) / d) : times(mirror(), (d + m) / m);
}

const specularPath = (here: PathState, eye: boolean): PathState =>
  eye
    ? { ...here, includesSunDiscs: false, specularDepth: here.specularDepth - 1 }
    : { ...here, includesSunDiscs: false, isCameraPath: false, bounces: here.bounces - 1 };

function diffuseLight(lighting: LightingContext, at: SurfaceOrigin, look: Brdf, here: PathState): SampledRadiance {
  const onward = { ...here, isCameraPath: false, includesSunDiscs: false, bounces: here.bounces - 1 };
  return weightedLight(lighting, at, sampleDirection(lighting, diffuseLobe(look), here), onward, here);
}

/** A direction of the rest frame from which light is looked for. */
interface DirectionSample {
  readonly L: Vec3;
  /** What the surface sends of light from there towards V, over the density with which it looks there; and that density over the one with which it is looked for. */
  readonly lobeWeight: SpectralFilter;
  readonly misWeight: number;
  /** It was chosen because the sky is bright there. */
  readonly fromSky: boolean;
}

/**
 * Where the surface itself looks, or now and then where the sky is bright, as if both were one density (Veach 1997, §9.2.4): so no weight is more than 2.
 * dΩ′ = dΩ/D² of the sky's directions.
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

/** What is sent on `here` of the light along a lead. */
function weightedLight(
  lighting: LightingContext,
  at: SurfaceOrigin,
  { L, lobeWeight: share, misWeight }: DirectionSample,
  path: PathState,
  here: PathState,
): SampledRadiance {
  if (misWeight === 0) return NO_LIGHT;
  return here.context.filtered(lightFromDirection(lighting, at, L, path), scaleFilter(share, misWeight));
}

/** Radiance from the direction L of the rest frame, as it arrives there. Directions below the triangle count as their mirror images above it. */
function lightFromDirection(lighting: LightingContext, at: SurfaceOrigin, L: Vec3, path: PathState): SampledRadiance {
  const n = path.frame.toWorld(toHemisphere(at.geometricNormal, L));
  return incidentLight(lighting, { ray: rayBack(lighting, at, n), begin: at.clearance, from: at.hit, toward: n }, path);
}

/** The body's own colour as much as it is opaque, the lamps' highlights, and what comes through and from its sides. */
function glassLight(
  lighting: LightingContext,
  hit: Hit,
  point: SurfacePoint,
  V: Vec3,
  here: PathState,
): SampledRadiance {
  const { opacity } = point;
  const solid = brdfOf({ ...point, metallic: 0 }, V);
  const look = { ...solid, diffuse: scaleFilter(solid.diffuse, opacity) };
  const at = reflectionOrigin(lighting.scene, hit);
  const own = plus(directLight(lighting, at, look, here), here.context.emitted(emittedSpectrum(point)), opacity);
  const diffuse = opacity > 0 && here.bounces > 0 ? diffuseLight(lighting, at, look, here) : NO_LIGHT;
  const onward = { ...here, includesSunDiscs: true, specularDepth: here.specularDepth - 1 };
  const glass: GlassBody = {
    frame: here.frame,
    point,
    branches: here.specularDepth === MAX_SPECULAR_DEPTH,
    outside: (from, L) => lightFromDirection(lighting, from, L, onward),
    along: (beam) => incidentLight(lighting, { ...beam, toward: normalize(beam.ray.dx) }, onward),
  };
  const clear = here.specularDepth > 0 ? glassRadiance(lighting, hit, at, V, glass) : NO_LIGHT;
  return plus(plus(own, diffuse, point.occlusion), clear);
}
