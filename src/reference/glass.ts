import { addScaled, dot, length, negate, scale, type Vec3 } from '../math/vec3.ts';
import { type Departure, passageAt } from './departure.ts';
import { mirrored, turnedTo } from './directions.ts';
import { DARK, type Light, plus, times } from './light.ts';
import { type Lighting, rayBackInside } from './lighting.ts';
import { materialOf } from './material.ts';
import { type Beam, coverage, isElsewhere } from './passage.ts';
import { visibleFacet } from './reflectance.ts';
import type { RestFrame } from './restFrame.ts';
import { type SurfacePoint, surfaceAt } from './surface.ts';
import { nearestHit } from './trace.ts';
import type { Hit } from './types.ts';

/** Sides of one body that light is followed to, from its inside. */
const MOST_SIDES = 16;

/** A transparent body that is not a thin sheet, which would have no inside. */
export function isGlass({ scene, options }: Lighting, hit: Hit): boolean {
  if (!options.glass || scene.objects[hit.object].mesh.doubleSided) return false;
  const { opacity, opacityThreshold } = materialOf(scene, hit);
  return opacity < 1 && opacityThreshold === 0;
}

/** The body that is looked into, and how what is around it is seen. */
export interface Glass {
  /** It is at rest here, as long as the light is in it. */
  readonly frame: RestFrame;
  readonly point: SurfacePoint;
  /** Both the mirrored and the refracted ray are followed; else one of them by chance. */
  readonly branches: boolean;
  /** Radiance from a direction of the rest frame, outside. */
  outside(from: Departure, direction: Vec3): Light;
  /** Radiance along a beam, where it does not come from the body itself. */
  along(beam: Beam): Light;
}

/** What a body shows towards V by mirroring and refraction, in its rest frame. */
export function throughGlass(lighting: Lighting, hit: Hit, at: Departure, V: Vec3, glass: Glass): Light {
  const { ior, normal, opacity, roughness } = glass.point;
  const H = roughness < 0.05 ? normal : visibleFacet(normal, V, roughness * roughness, lighting.random);
  const d = negate(V);
  const F = dielectricFresnel(dot(V, H), ior);
  const mirror = (): Light => glass.outside(at, mirrored(d, H));
  const refract = (): Light => {
    const passage = passageAt(lighting.scene, hit);
    const inward = refracted(d, H, 1 / ior);
    return inward ? times(inside(lighting, passage, turnedTo(passage.side, inward), glass), 1 - opacity) : DARK;
  };
  if (glass.branches) return plus(times(mirror(), F), refract(), 1 - F);
  return lighting.random() < F ? mirror() : refract();
}

/** Light from a direction inside the body: what it meets there, or through its sides. */
function inside(lighting: Lighting, from: Departure, direction: Vec3, glass: Glass, sides = MOST_SIDES): Light {
  const { scene, random } = lighting;
  const { frame, point } = glass;
  const ray = rayBackInside(lighting, from, direction, frame, point.ior);
  const beam: Beam = { ray, begin: from.clear / length(ray.dx), from: from.hit };
  const hit = nearestHit(scene, ray, {
    begin: beam.begin,
    accepts: (found) => isElsewhere(beam, found) && (coverage(scene, found) > 0 || isGlass(lighting, found)),
  });
  if (!hit) return glass.outside(from, direction);
  if (hit.object !== from.hit.object || hit.front) return glass.along(beam);
  const N = surfaceAt(scene, hit).normal;
  const F = dielectricFresnel(-dot(direction, N), 1 / point.ior);
  const out = refracted(direction, N, point.ior);
  if (!out || random() < F) {
    if (sides === 0) return DARK;
    const back = { ...passageAt(scene, hit), side: scale(passageAt(scene, hit).side, -1) };
    return inside(lighting, back, turnedTo(back.side, mirrored(direction, N)), glass, sides - 1);
  }
  return glass.outside(passageAt(scene, hit), out);
}

/**
 * The direction behind a surface with the normal N (on the side that d comes from): t = ηd + (η cos − √(1 − η²(1 − cos²))) N,
 * cos = −d·N, η = n₁/n₂ of the sides. undefined where all is mirrored. Source: Snell's law as a vector.
 */
export function refracted(d: Vec3, N: Vec3, eta: number): Vec3 | undefined {
  const cos = -dot(d, N);
  const rest = 1 - eta * eta * (1 - cos * cos);
  if (rest < 0) return undefined;
  return addScaled(scale(d, eta), N, eta * cos - Math.sqrt(rest));
}

/** The mirrored share of unpolarised light at incidence `cos`, into a body n times as dense. Source: Born & Wolf §1.5. */
export function dielectricFresnel(cos: number, n: number): number {
  const c = Math.min(Math.max(cos, 0), 1);
  const rest = n * n - 1 + c * c;
  if (rest <= 0) return 1;
  const g = Math.sqrt(rest);
  const s = (c - g) / (c + g);
  const p = (n * n * c - g) / (n * n * c + g);
  return (s * s + p * p) / 2;
}
