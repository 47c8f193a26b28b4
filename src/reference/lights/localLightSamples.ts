import { conjugate, type Quat, rotate } from '../../math/quat.ts';
import { dot, length, negate, normalize, scale, sub, type Vec3 } from '../../math/vec3.ts';
import { shapingFactor } from '../../scene/lights/localLights.ts';
import type { CylinderLight, DiskLight, LocalLight, RectLight, SphereLight } from '../../scene/types.ts';
import { coneDirection, type Random } from '../sampling/directions.ts';
import { sphericalRect } from './sphericalRect.ts';

/** A point of a lamp, chosen by chance, as it is seen from a surface; all in the lamp's frame. */
export interface LightSample {
  /** From the surface to the point [m]. */
  readonly toward: Vec3;
  /** What the lamp's colour is multiplied with: its mean is the solid angle in which it shines, or of a point 1/d². */
  readonly weight: number;
}

/** `centre`: from the surface to the lamp's middle [m]; `orientation`: of the lamp's axes. undefined: nothing of it shines there. */
export function sampleLocalLight(
  light: LocalLight,
  center: Vec3,
  orientation: Quat,
  random: Random,
): LightSample | undefined {
  const sample = sampleShape(light, center, orientation, random);
  if (!sample || !light.shaping) return sample;
  const front = rotate(orientation, [0, 0, -1]);
  const share = shapingFactor(light.shaping, front, negate(normalize(sample.toward)));
  return share > 0 ? { ...sample, weight: share * sample.weight } : undefined;
}

function sampleShape(lamp: LocalLight, center: Vec3, orientation: Quat, random: Random): LightSample | undefined {
  if (lamp.kind === 'sphere') return lamp.radius === 0 ? pointSample(center) : sphereSample(center, lamp, random);
  const at = rotate(conjugate(orientation), negate(center));
  const local = lamp.kind === 'cylinder' ? cylinderSample(at, lamp, random) : planarSample(at, lamp, random);
  return local && { ...local, toward: rotate(orientation, local.toward) };
}

const pointSample = (center: Vec3): LightSample => ({
  toward: center,
  weight: 1 / Math.max(dot(center, center), 1e-12),
});

/** A direction of the cone in which the sphere is seen; all directions from its inside. */
function sphereSample(center: Vec3, { radius }: SphereLight, random: Random): LightSample {
  const d = length(center);
  const sin2 = Math.min((radius / d) ** 2, 1);
  const open = d > radius ? sin2 / (1 + Math.sqrt(1 - sin2)) : 2;
  const direction = coneDirection(normalize(center, [0, 0, 1]), open, random);
  const along = dot(direction, center);
  const chord = Math.sqrt(Math.max(0, radius * radius - (d * d - along * along)));
  const reach = d > radius ? along - chord : along + chord;
  return { toward: scale(direction, reach), weight: 2 * Math.PI * open };
}

/** A point of the face. `at`: the surface, on the lamp's axes [m]. Behind the face it is dark. */
function planarSample(at: Vec3, lamp: RectLight | DiskLight, random: Random): LightSample | undefined {
  if (at[2] >= 0) return undefined;
  const [p, q] = [random(), random()];
  if (lamp.kind === 'disk') return areaSample(at, onDisk(lamp.radius, p, q), Math.PI * lamp.radius ** 2);
  const { width, height } = lamp;
  const across = [-width / 2 - at[0], width / 2 - at[0]] as const;
  const up = [-height / 2 - at[1], height / 2 - at[1]] as const;
  const { x, y, solidAngle } = sphericalRect(across, up, at[2], p, q);
  // Smaller ones are differences of angles that rounding eats.
  if (solidAngle > 1e-6) return { toward: [x, y, -at[2]], weight: solidAngle };
  return areaSample(at, [(p - 0.5) * width, (q - 0.5) * height, 0], width * height);
}

/** A point that was chosen evenly from a face: dΩ = cos θ dA/d². */
function areaSample(at: Vec3, spot: Vec3, area: number): LightSample {
  const toward = sub(spot, at);
  return { toward, weight: (area * -at[2]) / length(toward) ** 3 };
}

function onDisk(radius: number, p: number, q: number): Vec3 {
  const r = radius * Math.sqrt(p);
  return [r * Math.cos(2 * Math.PI * q), r * Math.sin(2 * Math.PI * q), 0];
}

/** A point of that part of the side which is seen; of a line, 2r dφ cos becomes 1. */
function cylinderSample(at: Vec3, lamp: CylinderLight, random: Random): LightSample | undefined {
  const away = Math.hypot(at[1], at[2]);
  if (away <= lamp.radius) return undefined;
  const x = (random() - 0.5) * lamp.length;
  const open = Math.acos(lamp.radius / away);
  const phi = Math.atan2(at[2], at[1]) + open * (2 * random() - 1);
  const out: Vec3 = [0, Math.cos(phi), Math.sin(phi)];
  const toward = sub([x, lamp.radius * out[1], lamp.radius * out[2]], at);
  const d = length(toward);
  const width = lamp.radius === 0 ? away / d : (2 * open * lamp.radius * -dot(out, toward)) / d;
  return { toward, weight: (lamp.length * width) / d ** 2 };
}
