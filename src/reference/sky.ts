import { addScaled, dot, scale, type Vec3 } from '../math/vec3.ts';
import { domeOf, maybeDusky, SUN_DISC, upOf } from '../scene/daylight.ts';
import { domeAxes, placeOnPanorama } from '../scene/panorama.ts';
import { sampleTexture } from '../scene/sampleTexture.ts';
import { gradientAt, smoothstep } from '../scene/skyGradient.ts';
import type { DomeLight, Scene } from '../scene/types.ts';
import {
  REDDENED,
  REDDENED_COLORS,
  SCATTERED,
  SCATTERED_COLOR,
  scatteredShare,
  skyParts,
} from '../spectrum/scatteredLight.ts';
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
  const dome = domeOf(scene);
  const dusky = maybeDusky(scene);
  const bright = brightParts(dome);
  const color = domeColor(dome, scene.upAxis);
  return {
    light: (n, sight) => {
      if (dome.spectrum) return sight.shining(shineOf(color(n), dome.spectrum));
      return dusky ? reddening(color(n), sight) : scattering(color(n), sight);
    },
    suns: (n, sight) => suns.reduce((sum, sun) => plus(sum, sight.shining(sun.shine), discAndGlow(n, sun)), DARK),
    ...(bright && { bright }),
  };
}

/** Daylight of which air scatters the blue part: the rest is a filter that is nearly grey. */
function scattering(color: Vec3, sight: Sight): Light {
  const share = scatteredShare(color);
  if (share === 0) return sight.shining(shineOf(color));
  return plus(sight.shining(shineOf(addScaled(color, SCATTERED_COLOR, -share))), sight.shining(scatteredShine(share)));
}

/** The same, and what comes through much air, as at dusk. */
function reddening(color: Vec3, sight: Sight): Light {
  const { scattered, reddened, rest } = skyParts(color);
  let sum = sight.shining(shineOf(rest));
  if (scattered > 0) sum = plus(sum, sight.shining(scatteredShine(scattered)));
  reddened.forEach((share, i) => {
    const shine = { spectrum: REDDENED[i], filter: neutral(share), color: scale(REDDENED_COLORS[i], share) };
    if (share > 0) sum = plus(sum, sight.shining(shine));
  });
  return sum;
}

const scatteredShine = (share: number): Shine => ({
  spectrum: SCATTERED,
  filter: neutral(share),
  color: scale(SCATTERED_COLOR, share),
});

function domeColor(dome: DomeLight, upAxis: Scene['upAxis']): (n: Vec3) => Vec3 {
  const { color, texture, gradient } = dome;
  if (texture) return domePicture(texture, dome);
  if (!gradient) return () => color;
  const [up, sky] = [upOf(upAxis), { zenith: color, ...gradient }];
  return (n) => gradientAt(dot(n, up), sky);
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
