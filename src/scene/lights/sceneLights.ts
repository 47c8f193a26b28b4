import { radians } from '../../math/angle.ts';
import { normalize, type Vec3 } from '../../math/vec3.ts';
import { spectrumOfColor } from '../../spectrum/color/spectrumOfColor.ts';
import type { Scene } from '../types.ts';
import type { DistantLight, DomeLight, Light, LocalLight, NightSky } from './light.ts';
import { isDistantLight, isDomeLight, isLocalLight, isNightSky } from './lightKinds.ts';

// What shines on a scene, and what it is seen against: its own lights, or a clear day's.

/** A clear afternoon, for scenes that bring no light: irradiance of the sun and radiance of the sky. Linear sRGB. */
const DAY_SUN_COLOR: Vec3 = [2.7, 2.45, 2.1];
export const DAY_SKY = {
  kind: 'dome',
  path: '',
  color: [0.14, 0.31, 0.68],
  gradient: { horizon: [0.62, 0.74, 0.88], ground: [0.19, 0.18, 0.165] },
} as const satisfies DomeLight;

/** What is seen of a distant light, a little larger and far dimmer than a real sun, by a = 1 − cos(angle): a disc with a soft rim, and two glows s·exp(−a·rate). */
export const SUN_DISC = {
  rim: [3.4e-5, 4.2e-5],
  radiance: 20,
  glows: [
    [0.25, 900],
    [0.05, 40],
  ],
} as const;

/** Diameter of the sun as it is seen from the earth, and UsdLux's default: 0.53° [rad]. */
const DEFAULT_SUN_ANGLE = radians(0.53);

/** Radius of the disc that a distant light is [rad]. */
export const distantLightRadius = ({ angle }: Pick<DistantLight, 'angle'>): number => (angle ?? DEFAULT_SUN_ANGLE) / 2;

export type DirectLight = DistantLight | LocalLight;

/** Lights that come from somewhere, with their spectra; the day's sun where the scene brings no light at all. */
export const directLights = ({ lights, upAxis }: Pick<Scene, 'lights' | 'upAxis'>): readonly DirectLight[] =>
  (lights.length > 0 ? lights.filter(isDirect) : [DAY_SUNS[upAxis]]).map(withSpectrum);

/** What is found out about a spectrum is kept with it: so each light has always the same one. */
const known = new WeakMap<DirectLight, DirectLight>();

/** Of a light that does not tell its spectrum: what its colour tells (spectrum/color/spectrumOfColor.ts). */
function withSpectrum(light: DirectLight): DirectLight {
  if (light.spectrum) return light;
  const made = known.get(light) ?? { ...light, spectrum: spectrumOfColor(light.color) };
  known.set(light, made);
  return made;
}

/** The light all round; a clear day's sky where there is none. */
export const sceneDome = ({ lights }: Pick<Scene, 'lights'>): DomeLight =>
  lights.find(isDomeLight) ?? (sceneNightSky({ lights }) ? DARKNESS : DAY_SKY);

/** Whether the sky may be red: a scene's own may be one of dusk. */
export const hasDomeLight = ({ lights }: Pick<Scene, 'lights'>): boolean => lights.some(isDomeLight);

/** Between the stars. */
const DARKNESS: DomeLight = { kind: 'dome', path: '', color: [0, 0, 0] };

/** The stars, where the scene is under them. */
export const sceneNightSky = ({ lights }: Pick<Scene, 'lights'>): NightSky | undefined => lights.find(isNightSky);

const isDirect = (light: Light): light is DirectLight => isDistantLight(light) || isLocalLight(light);

const sunAlong = (direction: Vec3): DistantLight => ({
  kind: 'distant',
  path: '',
  direction: normalize(direction),
  color: DAY_SUN_COLOR,
});
const DAY_SUNS = { Y: sunAlong([-0.55, -0.75, -0.45]), Z: sunAlong([-0.55, 0.45, -0.75]) };

/** Towards the zenith. */
export const upVector = (upAxis: Scene['upAxis']): Vec3 => (upAxis === 'Y' ? [0, 1, 0] : [0, 0, 1]);
