import { negate, normalize, type Vec3, ZERO } from '../math/vec3.ts';
import { simultaneousPosition } from '../physics/simultaneity.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { Bands } from '../spectrum/bands.ts';
import { type Departure, departureAt } from './departure.ts';
import { either, type Random, turnedTo } from './directions.ts';
import { eyesOf } from './eye.ts';
import { dimmed, largest, neutral } from './filters.ts';
import { type Glass, isGlass, throughGlass } from './glass.ts';
import { DARK, type Light, plus, times } from './light.ts';
import { frameOf, type Lighting, lightingOf, rayBack } from './lighting.ts';
import type { LightOptions } from './lightOptions.ts';
import { directLight } from './lights.ts';
import { type Beam, coverage, isElsewhere } from './passage.ts';
import { diffuseLobe, type Lobe, type Look, lookOf, mirrorLobe } from './reflectance.ts';
import { restFrame, WORLD } from './restFrame.ts';
import { emissionOf } from './shine.ts';
import { type Eye, RADIANCE, type Receiver, received } from './sight.ts';
import { type SurfacePoint, surfaceAt } from './surface.ts';
import { nearestHit, type TracedScene } from './trace.ts';
import type { Hit, SpacetimeRay } from './types.ts';

/** Mirrors in mirrors, and sides of glass, are followed so deep. */
const MOST_MIRRORS = 8;
/** Transparent layers, one behind the other. */
const MOST_LAYERS = 64;
/** So many directions are asked for the diffuse light of what is seen directly: there most of a picture's noise is. */
const FIRST_RAYS = 2;
/** What mirrors a share s of the light is followed with the probability 4s. */
const MIRROR_CHANCE = 4;
/** What less than this part of is left of is not followed further. */
const FAINT = 1e-4;

/** Who looks along a ray, and how far what is met there is followed. */
export interface Path extends Receiver {
  /** Whether it is a picture that forms: of front sides, by what they reflect. Else light is gathered: from both sides, and what is left of `bounces` counts. */
  readonly eye: boolean;
  /** The sky has its suns in it. */
  readonly suns: boolean;
  readonly bounces: number;
  readonly mirrors: number;
}

/**
 * The light that arrives along a ray, from s = 0 on: linear sRGB radiance for a receiver with proper velocity u (world frame, units of c). Between two rest
 * frames there is one Doppler factor, so light that is scattered on its way is shifted at each step (physics.md, "Shading"). In the
 * views that show no light, D = 1. One sample of an integral: the mean of many is the picture. `random` in 0 … 1.
 */
export function radiance(
  scene: TracedScene,
  ray: SpacetimeRay,
  receiver: { readonly u: Vec3 },
  settings: RenderSettings,
  options: LightOptions,
  random: Random,
  { sight, color }: Eye = eyesOf(settings)(random),
): Vec3 {
  const lighting = lightingOf(scene, settings, options, receiver.u, random);
  const luminous = settings.view === 'light-cone';
  const frame = restFrame(luminous ? receiver.u : ZERO);
  // A slice has the sky of the observer's own directions.
  const toward = settings.view === 'simultaneity' ? simultaneousPosition(ray.dx, receiver.u) : ray.dx;
  const path = { frame, sight, eye: true, suns: true, bounces: options.bounces, mirrors: MOST_MIRRORS };
  return color(gather(lighting, { ray, begin: 0, toward: normalize(toward) }, path));
}

/** A beam, and the direction in which the sky is behind it. */
interface Gaze extends Beam {
  readonly toward: Vec3;
}

/** Through all that is transparent, to the first solid surface or the sky. */
function gather(lighting: Lighting, gaze: Gaze, path: Path): Light {
  const { scene } = lighting;
  let beam: Beam = gaze;
  let sum = DARK;
  let share = 1;
  for (let layer = 0; layer < MOST_LAYERS; layer++) {
    const hit = met(lighting, beam, path);
    if (!hit) return plus(sum, skyLight(lighting, gaze.toward, path), share);
    const glass = path.eye && isGlass(lighting, hit);
    const held = glass ? 1 : coverage(scene, hit);
    sum = plus(sum, surfaceLight(lighting, gaze, hit, path, glass), share * held);
    share *= 1 - held;
    if (share < FAINT) break;
    beam = { ray: beam.ray, begin: hit.s, from: hit };
  }
  return sum;
}

function met(lighting: Lighting, beam: Beam, { eye }: Path): Hit | undefined {
  const { scene } = lighting;
  return nearestHit(scene, beam.ray, {
    begin: beam.begin,
    accepts: (hit) =>
      isElsewhere(beam, hit) &&
      (!eye || hit.front || scene.objects[hit.object].mesh.doubleSided) &&
      (coverage(scene, hit) > 0 || (eye && isGlass(lighting, hit))),
  });
}

function skyLight({ sky }: Lighting, n: Vec3, path: Path): Light {
  return received(path, n, WORLD, RADIANCE, ({ sight }) => {
    const light = sky.light(n, sight);
    return path.suns ? plus(light, sky.suns(n, sight)) : light;
  });
}

/** What the surface sends towards the receiver, as it arrives there. */
function surfaceLight(lighting: Lighting, { ray }: Gaze, hit: Hit, path: Path, glass: boolean): Light {
  const n = normalize(ray.dx);
  const frame = frameOf(lighting, hit.velocity);
  const point = surfaceAt(lighting.scene, hit);
  const V = negate(frame.into(n));
  const sent = glass ? glassLight : solidLight;
  return received(path, n, frame, RADIANCE, (here) => sent(lighting, hit, point, V, { ...path, ...here }));
}

/** Radiance of a surface towards V, in its rest frame: what it emits, and what it reflects where that is looked at. */
function solidLight(lighting: Lighting, hit: Hit, point: SurfacePoint, V: Vec3, here: Path): Light {
  const emitted = here.sight.shining(emissionOf(point));
  if (!here.eye && here.bounces === 0) return emitted;
  const look = lookOf(point, V);
  const at = departureAt(lighting.scene, hit);
  const direct = plus(emitted, directLight(lighting, at, look, here));
  return plus(direct, scattered(lighting, at, look, point.roughness, here), point.occlusion);
}

/**
 * Light of the sky and of other surfaces. Of what is seen directly both parts of the reflectance are followed, the faint mirroring
 * of a plastic now and then and all the more, where the sky is not bright; further on one of the parts, by chance, stands for both.
 */
function scattered(lighting: Lighting, at: Departure, look: Look, roughness: number, here: Path): Light {
  const { options, random } = lighting;
  const eye = here.eye && options.mirrors && here.mirrors > 0;
  const scatters = here.bounces > 0;
  const lead = leadOf(lighting, mirrorLobe(look, roughness), here);
  const d = scatters ? largest(look.diffuse) : 0;
  const m = eye || scatters ? largest(lead.share) : 0;
  const diffuse = (): Light => diffuselyFrom(lighting, at, look, here);
  const mirror = (): Light => lightAlong(lighting, at, lead, mirrorPath(here, eye), here);
  if (here.eye && here.mirrors === MOST_MIRRORS) {
    let sum = DARK;
    if (d > 0) for (let k = 0; k < FIRST_RAYS; k++) sum = plus(sum, diffuse(), 1 / FIRST_RAYS);
    const chance = lead.isBright && m > 0 ? 1 : Math.min(1, MIRROR_CHANCE * m);
    return random() < chance ? plus(sum, mirror(), 1 / chance) : sum;
  }
  if (d + m === 0) return DARK;
  return random() * (d + m) < d ? times(diffuse(), (d + m) / d) : times(mirror(), (d + m) / m);
}

const mirrorPath = (here: Path, eye: boolean): Path =>
  eye
    ? { ...here, suns: false, mirrors: here.mirrors - 1 }
    : { ...here, suns: false, eye: false, bounces: here.bounces - 1 };

function diffuselyFrom(lighting: Lighting, at: Departure, look: Look, here: Path): Light {
  const onward = { ...here, eye: false, suns: false, bounces: here.bounces - 1 };
  return lightAlong(lighting, at, leadOf(lighting, diffuseLobe(look), here), onward, here);
}

/** A direction of the rest frame from which light is looked for. */
interface Lead {
  readonly L: Vec3;
  /** What the surface sends of light from there towards V, over the density with which it looks there; and that density over the one with which it is looked for. */
  readonly share: Bands;
  readonly weight: number;
  /** It was chosen because the sky is bright there. */
  readonly isBright: boolean;
}

/**
 * Where the surface itself looks, or now and then where the sky is bright, as if both were one density (Veach 1997, §9.2.4): so no weight is more than 2.
 * dΩ′ = dΩ/D² of the sky's directions.
 */
function leadOf({ sky: { bright }, random }: Lighting, lobe: Lobe, { frame }: Path): Lead {
  const { density } = lobe;
  if (!bright || !density) {
    const L = lobe.direction(random);
    return { L, share: lobe.share(L), weight: 1, isBright: false };
  }
  const { isFirst: isBright, rest } = either(bright.chance, random);
  const L = isBright ? frame.into(bright.direction(rest)) : lobe.direction(rest);
  const own = density(L);
  if (own === 0) return { L, share: neutral(0), weight: 0, isBright };
  const n = frame.out(L);
  const all = (1 - bright.chance) * own + bright.chance * bright.density(n) * frame.doppler(n) ** 2;
  return { L, share: lobe.share(L), weight: own / all, isBright };
}

/** What is sent on `here` of the light along a lead. */
function lightAlong(lighting: Lighting, at: Departure, { L, share, weight }: Lead, path: Path, here: Path): Light {
  if (weight === 0) return DARK;
  return here.sight.filtered(lightFrom(lighting, at, L, path), dimmed(share, weight));
}

/** Radiance from the direction L of the rest frame, as it arrives there. Directions below the triangle count as their mirror images above it. */
function lightFrom(lighting: Lighting, at: Departure, L: Vec3, path: Path): Light {
  const n = path.frame.out(turnedTo(at.side, L));
  return gather(lighting, { ray: rayBack(lighting, at, n), begin: at.clear, from: at.hit, toward: n }, path);
}

/** The body's own colour as much as it is opaque, the lamps' highlights, and what comes through and from its sides. */
function glassLight(lighting: Lighting, hit: Hit, point: SurfacePoint, V: Vec3, here: Path): Light {
  const { opacity } = point;
  const solid = lookOf({ ...point, metallic: 0 }, V);
  const look = { ...solid, diffuse: dimmed(solid.diffuse, opacity) };
  const at = departureAt(lighting.scene, hit);
  const own = plus(directLight(lighting, at, look, here), here.sight.shining(emissionOf(point)), opacity);
  const diffuse = opacity > 0 && here.bounces > 0 ? diffuselyFrom(lighting, at, look, here) : DARK;
  const onward = { ...here, suns: true, mirrors: here.mirrors - 1 };
  const glass: Glass = {
    frame: here.frame,
    point,
    branches: here.mirrors === MOST_MIRRORS,
    outside: (from, L) => lightFrom(lighting, from, L, onward),
    along: (beam) => gather(lighting, { ...beam, toward: normalize(beam.ray.dx) }, onward),
  };
  const clear = here.mirrors > 0 ? throughGlass(lighting, hit, at, V, glass) : DARK;
  return plus(plus(own, diffuse, point.occlusion), clear);
}
