import type { Quat } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { LightSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import type { RadianceTexture, Texture } from '../materials/texture.ts';
import type { Lifetime, RigidMotion } from '../motion/motionTypes.ts';
import type { Stars } from '../stars/brightStars.ts';

export type Light = SpectrumLight | NightSky;

/** What shines with one colour and one spectrum. */
export type SpectrumLight = DistantLight | LocalLight | DomeLight;

/** What shines from somewhere, and may move. */
export type LocalLight = SphereLight | AreaLight;
export type AreaLight = RectLight | DiskLight | CylinderLight;

export interface DistantLight {
  readonly kind: 'distant';
  readonly path: string;
  /** Unit, the way the light travels. */
  readonly direction: Vec3;
  /** Linear sRGB times intensity and exposure: irradiance on a facing surface. */
  readonly color: Vec3;
  /** Diameter of its disc [rad], as wide as which edges of shadows are blurred; the sun's where absent. */
  readonly angle?: number;
  /** What its light is made of, in its own frame; daylight where absent. */
  readonly spectrum?: LightSpectrum;
}
export interface LocalLightBase {
  readonly path: string;
  /** Of its middle; its axes are the axes of its frame. */
  readonly motion: RigidMotion;
  /** World times between which it shines [s]. */
  readonly lifetime: Lifetime;
  /** Linear sRGB in its own frame: the radiance L of its surface, the same in all directions of its front. */
  readonly color: Vec3;
  /** What its light is made of, in its own frame; daylight where absent. */
  readonly spectrum?: LightSpectrum;
  /** Absent where it shines alike to all sides. */
  readonly shaping?: LightShaping;
}
export interface SphereLight extends LocalLightBase {
  readonly kind: 'sphere';
  /** In its own frame [m]. E = πL(radius/distance)²; of a point (radius 0) `color` is the intensity I, E = I/distance². */
  readonly radius: number;
}
/** A face in the XY plane of its frame, dark behind: it shines towards −Z. */
export interface RectLight extends LocalLightBase {
  readonly kind: 'rect';
  /** Along X and Y of its own frame [m]. */
  readonly width: number;
  readonly height: number;
}
/** The same, round. */
export interface DiskLight extends LocalLightBase {
  readonly kind: 'disk';
  /** In its own frame [m]. */
  readonly radius: number;
}
/** The side of a tube along X of its frame; its caps are dark. */
export interface CylinderLight extends LocalLightBase {
  readonly kind: 'cylinder';
  /** In its own frame [m]. Of a line (radius 0) `color` is 2·radius·L: the intensity of a metre of it, seen from the side. */
  readonly radius: number;
  readonly length: number;
}
/**
 * What of its light goes out at an angle θ from −Z of its frame, 0 … 1: cos(θ)^focus, and all of it within `inner`, none
 * beyond `outer` [rad], between them 1 − smoothstep.
 */
export interface LightShaping {
  readonly inner: number;
  readonly outer: number;
  readonly focus: number;
}
export interface DomeLight {
  readonly kind: 'dome';
  readonly path: string;
  readonly color: Vec3;
  /** What its light is made of, in its own frame; daylight where absent. */
  readonly spectrum?: LightSpectrum;
  /** It is brighter or darker at the horizon and below, `color` is that of the zenith; without this and a picture all directions are alike. */
  readonly gradient?: SkyGradient;
  /** Of all directions, by latitude and longitude (latLong.ts). */
  readonly texture?: Texture | RadianceTexture;
  /** The picture's axes → world axes; the same where absent. */
  readonly orientation?: Quat;
}
/** Linear sRGB radiance at the horizon, and of the ground well below it. The zenith is where the scene's up axis points. */
export interface SkyGradient {
  readonly horizon: Vec3;
  readonly ground: Vec3;
}
/** The fixed stars before the cosmic background. They are seen; on things they shine too faintly to tell. */
export interface NightSky {
  readonly kind: 'stars';
  readonly path: string;
  readonly stars: Stars;
  /** Equatorial axes → world axes. */
  readonly orientation: Quat;
  /** Radiance for each cd/m², and irradiance for each lx. */
  readonly gain: number;
}
