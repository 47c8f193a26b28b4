import { radians } from '../../math/angle.ts';
import { normalize, type Vec3 } from '../../math/vec3.ts';
import { spectrumOfColor } from '../../spectrum/color/spectrumOfColor.ts';
import { starDome } from '../stars/starDome.ts';
import type { Scene } from '../types.ts';
import type { DistantLight, DomeLight, Light, LocalLight, NightSky } from './light.ts';
import { isDistantLight, isDomeLight, isLocalLight, isNightSky } from './lightKinds.ts';
import type { SkyColors } from './skyGradient.ts';

// The lights and the sky of a scene: its own, or those of a clear day.

/** A clear afternoon, for scenes without lights: irradiance of the sun and radiance of the sky. Linear sRGB. */
const DAY_SUN_COLOR: Vec3 = [2.7, 2.45, 2.1];
export const DAY_SKY = {
  kind: 'dome',
  path: '',
  color: [0.14, 0.31, 0.68],
  gradient: { horizon: [0.62, 0.74, 0.88], ground: [0.19, 0.18, 0.165] },
} as const satisfies DomeLight;

/** How a distant light is seen, slightly larger and much dimmer than the real sun, by a = 1 − cos(angle): a disc with a soft rim, and two glows s·exp(−a·rate). */
export const SUN_DISC = {
  rim: [3.4e-5, 4.2e-5],
  radiance: 20,
  glows: [
    [0.25, 900],
    [0.05, 40],
  ],
} as const;

/** Angular diameter of the sun from the earth, and UsdLux's default: 0.53° [rad]. */
const DEFAULT_SUN_ANGLE = radians(0.53);

/** Angular radius of a distant light [rad]. */
export const distantLightRadius = ({ angle }: Pick<DistantLight, 'angle'>): number => (angle ?? DEFAULT_SUN_ANGLE) / 2;

export type DirectLight = DistantLight | LocalLight;

/** Distant and local lights, with their spectra; the default sun if the scene has no lights at all. */
export const directLights = ({ lights, upAxis }: Pick<Scene, 'lights' | 'upAxis'>): readonly DirectLight[] =>
  (lights.length > 0 ? lights.filter(isDirect) : [DAY_SUNS[upAxis]]).map(withSpectrum);

/** Each light always gets the same spectrum object, since results are cached by it. */
const cache = new WeakMap<DirectLight, DirectLight>();

/** A light without a spectrum gets that of its colour (spectrum/color/spectrumOfColor.ts). */
function withSpectrum(light: DirectLight): DirectLight {
  if (light.spectrum) return light;
  const made = cache.get(light) ?? { ...light, spectrum: spectrumOfColor(light.color) };
  cache.set(light, made);
  return made;
}

/** The dome light; without one the light of the stars under a night sky, or else a clear day's sky. */
export function sceneDome({ lights }: Pick<Scene, 'lights'>): DomeLight {
  const night = sceneNightSky({ lights });
  return lights.find(isDomeLight) ?? (night ? starDome(night) : DAY_SKY);
}

/** Whether the dome is seen behind everything. That of a night sky only lights things: its stars are drawn as points. */
export const showsDome = ({ lights }: Pick<Scene, 'lights'>): boolean =>
  lights.some(isDomeLight) || !sceneNightSky({ lights });

/** The colours of a clear day's sky as a backdrop: those of the scene's own gradient, else of the default sky. */
export function backdropColors({ lights }: Pick<Scene, 'lights'>): SkyColors {
  const { color, gradient } = lights.find(isDomeLight) ?? DAY_SKY;
  return gradient ? { zenith: color, ...gradient } : { zenith: DAY_SKY.color, ...DAY_SKY.gradient };
}

/** Whether the scene has a dome of its own, which may be reddened as at dusk. */
export const hasDomeLight = ({ lights }: Pick<Scene, 'lights'>): boolean => lights.some(isDomeLight);

/** The night sky, if the scene has one. */
export const sceneNightSky = ({ lights }: Pick<Scene, 'lights'>): NightSky | undefined => lights.find(isNightSky);

const isDirect = (light: Light): light is DirectLight => isDistantLight(light) || isLocalLight(light);

const sunAlong = (direction: Vec3): DistantLight => ({
  kind: 'distant',
  path: '',
  direction: normalize(direction),
  color: DAY_SUN_COLOR,
});
const DAY_SUNS = { Y: sunAlong([-0.55, -0.75, -0.45]), Z: sunAlong([-0.55, 0.45, -0.75]) };

/** Unit vector towards the zenith. */
export const upVector = (upAxis: Scene['upAxis']): Vec3 => (upAxis === 'Y' ? [0, 1, 0] : [0, 0, 1]);
