import type { Quat } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { LightSpectrum, ThermalSpectrum } from '../../spectrum/sources/lightSpectrum.ts';
import type { DomeFilm } from '../film/film.ts';
import type { RadianceTexture, Texture } from '../materials/texture.ts';
import type { Lifetime, RigidMotion } from '../motion/motionTypes.ts';
import type { Stars } from '../stars/brightStars.ts';

/** What shines: sources with a spectrum, or the stars. */
export type Light = SpectrumLight | NightSky;

/** A light with one colour and one spectrum. */
export type SpectrumLight = DistantLight | LocalLight | DomeLight;

/** A light with a place, which may move. */
export type LocalLight = SphereLight | AreaLight;
/** A light with a shape that is not a sphere. */
export type AreaLight = RectLight | DiskLight | CylinderLight;

/** Parallel light, as the sun's. */
export interface DistantLight {
  readonly kind: 'distant';
  /** Prim path, unique. */
  readonly path: string;
  /** Unit vector in which the light travels. */
  readonly direction: Vec3;
  /** Linear sRGB times intensity and exposure: irradiance on a facing surface. */
  readonly color: Vec3;
  /** Angular diameter [rad], which sets the width of penumbrae; the sun's if absent. */
  readonly angle?: number;
  /** Its spectrum in its own frame; daylight if absent. */
  readonly spectrum?: LightSpectrum;
}
/** What lights with a place have in common. */
export interface LocalLightBase {
  /** Prim path, unique. */
  readonly path: string;
  /** The motion of its centre and axes. */
  readonly motion: RigidMotion;
  /** World times between which it emits [s]. */
  readonly lifetime: Lifetime;
  /** Path of the light that shines several times, of which this is one; absent of a whole. */
  readonly pieceOf?: string;
  /** Linear sRGB in its own frame: the radiance L of its surface, the same in all directions in which it shines. */
  readonly color: Vec3;
  /** Its spectrum in its own frame; daylight if absent. */
  readonly spectrum?: LightSpectrum;
  /** Absent if it shines equally in all directions. */
  readonly shaping?: LightShaping;
}
/** A sphere that shines in all directions, or a point. */
export interface SphereLight extends LocalLightBase {
  readonly kind: 'sphere';
  /** In its own frame [m]. E = πL(radius/distance)²; of a point (radius 0) `color` is the intensity I, E = I/distance². */
  readonly radius: number;
}
/** A rectangle in the XY plane of its frame that shines to one side, towards −Z. */
export interface RectLight extends LocalLightBase {
  readonly kind: 'rect';
  /** Along X of its own frame [m]. */
  readonly width: number;
  /** Along Y of its own frame [m]. */
  readonly height: number;
}
/** The same for a disk. */
export interface DiskLight extends LocalLightBase {
  readonly kind: 'disk';
  /** In its own frame [m]. */
  readonly radius: number;
}
/** The lateral surface of a cylinder along X of its frame; its caps are dark. */
export interface CylinderLight extends LocalLightBase {
  readonly kind: 'cylinder';
  /** In its own frame [m]. Of a line (radius 0) `color` is 2·radius·L: the intensity of a metre of it, seen from the side. */
  readonly radius: number;
  /** In its own frame [m]. */
  readonly length: number;
}
/**
 * Factor 0 … 1 of the radiance emitted at an angle θ from −Z of its frame: cos(θ)^focus, times 1 within `inner`, 0
 * beyond `outer` [rad], and 1 − smoothstep between them.
 */
export interface LightShaping {
  /** Where it begins to fade [rad]. */
  readonly inner: number;
  /** Where it ends [rad]. */
  readonly outer: number;
  /** Exponent of cos θ. */
  readonly focus: number;
}
/** A picture of a dome. */
export type DomePicture = Texture | RadianceTexture;

/** The light of the sky, from all directions. */
export interface DomeLight {
  readonly kind: 'dome';
  /** Prim path, unique. */
  readonly path: string;
  /** Linear sRGB radiance; with a texture its factor. */
  readonly color: Vec3;
  /** Its spectrum in its own frame; daylight if absent. */
  readonly spectrum?: LightSpectrum;
  /**
   * Instead of that, blackbodies whose light it is together, as starlight is. The channels of `color` and of the texture are then not red, green and blue,
   * but the amounts of three groups of blackbodies; their own colours are factors.
   */
  readonly blackbodies?: readonly DomeBlackbody[];
  /** Colours at the horizon and below; `color` is that of the zenith. Without gradient and texture the dome is uniform. */
  readonly gradient?: SkyGradient;
  /** Latitude–longitude map of all directions (latLong.ts). */
  readonly texture?: DomePicture;
  /** A film of which `texture` is a frame. */
  readonly film?: DomeFilm;
  /** Texture axes → world axes; identity if absent. */
  readonly orientation?: Quat;
}
/** A part of a dome's light. */
export interface DomeBlackbody {
  /** Of the dome's colour, the one that is its amount: 0, 1 or 2. */
  readonly channel: number;
  /** Linear sRGB factor. */
  readonly color: Vec3;
  /** Its temperature. */
  readonly spectrum: ThermalSpectrum;
}

/** Linear sRGB radiance at the horizon, and of the ground well below it. The zenith is where the scene's up axis points. */
export interface SkyGradient {
  /** Linear sRGB radiance. */
  readonly horizon: Vec3;
  /** Linear sRGB radiance. */
  readonly ground: Vec3;
}
/** The fixed stars before the cosmic background. Where the scene has no dome light, their light shines on surfaces. */
export interface NightSky {
  readonly kind: 'stars';
  /** Prim path, unique. */
  readonly path: string;
  /** Directions, magnitudes and temperatures. */
  readonly stars: Stars;
  /** Equatorial axes → world axes. */
  readonly orientation: Quat;
  /** Radiance for each cd/m², and irradiance for each lx. */
  readonly gain: number;
}
