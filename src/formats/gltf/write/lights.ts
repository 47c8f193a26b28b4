import { shortestRotation } from '../../../math/quat.ts';
import { scale, type Vec3 } from '../../../math/vec3.ts';
import { type Message, msg } from '../../../messages/message.ts';
import { lightKind, projectedArea } from '../../../scene/lights/lightKinds.ts';
import type { Light, LocalLight, RigidMotion } from '../../../scene/types.ts';
import type { LightSpectrum } from '../../../spectrum/sources/lightSpectrum.ts';

/** A light as KHR_lights_punctual has it. */
export interface PunctualLight {
  readonly type: 'directional' | 'spot' | 'point';
  readonly motion: RigidMotion;
  /** Linear RGB times intensity: irradiance of a directional light, or the intensity of others. */
  readonly intensity: Vec3;
  readonly spectrum: LightSpectrum | undefined;
  readonly cone?: { readonly inner: number; readonly outer: number };
  /** What glTF has no words for: "radius of 1 m". */
  readonly lost?: Message;
}

/** undefined where glTF has no such light. */
type PunctualWriter<L extends Light> = (light: L) => PunctualLight | undefined;

const LIGHTS: { readonly [K in Light['kind']]: PunctualWriter<Extract<Light, { readonly kind: K }>> } = {
  distant: (light) => ({
    type: 'directional',
    spectrum: light.spectrum,
    motion: {
      kind: 'static',
      pose: { position: [0, 0, 0], orientation: shortestRotation([0, 0, -1], light.direction) },
    },
    intensity: light.color,
  }),
  sphere: (light) => localLight(light, light.radius === 0 ? undefined : msg`radius of ${light.radius} m`),
  rect: (light) => localLight(light, lostShape(light)),
  disk: (light) => localLight(light, lostShape(light)),
  cylinder: (light) => localLight(light, lostShape(light)),
  dome: () => undefined,
  stars: () => undefined,
};

export const punctualLight = (light: Light): PunctualLight | undefined =>
  (LIGHTS[light.kind] as PunctualWriter<Light>)(light);

const lostShape = ({ kind }: LocalLight): Message => msg`shape, a ${kind},`;

function localLight(light: LocalLight, lost: Message | undefined): PunctualLight {
  const cone = spotCone(light);
  return {
    spectrum: light.spectrum,
    type: cone ? 'spot' : 'point',
    motion: light.motion,
    intensity: scale(light.color, projectedArea(light)),
    ...(cone && { cone }),
    ...(lost !== undefined && { lost }),
  };
}

/** The cone of a spot light [rad]: of what is shaped, and of faces, which are dark behind. glTF wants 0 ≤ inner < outer ≤ π/2. */
function spotCone(light: LocalLight): PunctualLight['cone'] {
  const { isOneSided } = lightKind(light);
  if (!light.shaping) return isOneSided ? { inner: 0, outer: Math.PI / 2 } : undefined;
  const outer = Math.min(Math.max(light.shaping.outer, 1e-3), Math.PI / 2);
  return { inner: Math.min(Math.max(isOneSided && outer > 1.5 ? 0 : light.shaping.inner, 0), outer - 1e-4), outer };
}
