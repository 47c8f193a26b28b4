import { addScaled, dot, lerp, scale, type Vec3 } from '../math/vec3.ts';
import { DAY, domeOf, SKY_SHAPE, SUN_DISC, upOf } from '../scene/daylight.ts';
import { domeAxes, placeOnPanorama } from '../scene/panorama.ts';
import { sampleTexture } from '../scene/sampleTexture.ts';
import type { DomeLight, Scene } from '../scene/types.ts';
import { SCATTERED, SCATTERED_COLOR, scatteredShare } from '../spectrum/scatteredLight.ts';
import { type BrightParts, brightParts } from './brightParts.ts';
import { neutral } from './filters.ts';
import { DARK, type Light, plus } from './light.ts';
import { type Shine, shineOf } from './shine.ts';
import type { Sight } from './sight.ts';

/** A distant light: the unit direction in which it travels, how large it is, and what it shines with. */
export interface Sun {
  readonly direction: Vec3;
  /** Of its disc [rad]. */
  readonly radius: number;
  readonly shine: Shine;
}

/** Radiance from world directions n (unit), for the sight of one who is at rest in the world. */
export interface Sky {
  light(n: Vec3, sight: Sight): Light;
  /** The discs of distant lights and their glow, which are in the sky for the eye alone: as light they have no size. */
  suns(n: Vec3, sight: Sight): Light;
  readonly bright?: BrightParts;
}

export function skyOf(scene: Scene, suns: readonly Sun[]): Sky {
  const up = upOf(scene.upAxis);
  const dome = domeOf(scene);
  const bright = dome && brightParts(dome);
  const color = dome
    ? domeColor(dome, scene.upAxis)
    : (n: Vec3) => gradient(dot(n, up), DAY.zenith, DAY.horizon, DAY.ground);
  return {
    light: (n, sight) =>
      dome?.spectrum ? sight.shining(shineOf(color(n), dome.spectrum)) : scattering(color(n), sight),
    suns: (n, sight) => suns.reduce((sum, sun) => plus(sum, sight.shining(sun.shine), discAndGlow(n, sun)), DARK),
    ...(bright && { bright }),
  };
}

/** Daylight of which air scatters the blue part: the rest is a filter that is nearly grey. */
function scattering(color: Vec3, sight: Sight): Light {
  const share = scatteredShare(color);
  if (share === 0) return sight.shining(shineOf(color));
  const blue = { spectrum: SCATTERED, filter: neutral(share), color: scale(SCATTERED_COLOR, share) };
  return plus(sight.shining(shineOf(addScaled(color, SCATTERED_COLOR, -share))), sight.shining(blue));
}

function domeColor(dome: DomeLight, upAxis: Scene['upAxis']): (n: Vec3) => Vec3 {
  const { color, texture } = dome;
  if (texture) return domePicture(texture, dome);
  const up = upOf(upAxis);
  return (n) => gradient(dot(n, up), color, color, color);
}

/** From the horizon to the zenith, and a ground that only closes the sphere. */
function gradient(height: number, zenith: Vec3, horizon: Vec3, ground: Vec3): Vec3 {
  const { curve, dim, haze, seam } = SKY_SHAPE;
  const above = lerp(horizon, zenith, Math.max(height, 0) ** curve);
  const below = lerp(scale(horizon, dim), ground, smoothstep(0, haze, -height));
  return lerp(below, above, smoothstep(-seam, seam, height));
}

function domePicture(texture: NonNullable<DomeLight['texture']>, dome: DomeLight): (n: Vec3) => Vec3 {
  const { color } = dome;
  const [x, y, z] = domeAxes(dome);
  return (n) => {
    const [u, v] = placeOnPanorama([dot(n, x), dot(n, y), dot(n, z)]);
    const [r, g, b] = sampleTexture(texture, u, v);
    return [r * color[0], g * color[1], b * color[2]];
  };
}

function discAndGlow(n: Vec3, { direction }: Sun): number {
  const away = 1 + dot(n, direction);
  const disc = SUN_DISC.radiance * (1 - smoothstep(...SUN_DISC.rim, away));
  return SUN_DISC.glows.reduce((sum, [strength, rate]) => sum + strength * Math.exp(-rate * away), disc);
}

function smoothstep(from: number, to: number, x: number): number {
  const s = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return s * s * (3 - 2 * s);
}
