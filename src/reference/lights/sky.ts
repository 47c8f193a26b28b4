import { addScaled, dot, scale, type Vec3 } from '../../math/vec3.ts';
import { domeAxes, latLongFromDirection } from '../../scene/lights/latLong.ts';
import { hasDomeLight, SUN_DISC, sceneDome, upVector } from '../../scene/lights/sceneLights.ts';
import { gradientAt, smoothstep } from '../../scene/lights/skyGradient.ts';
import { sampleTexture } from '../../scene/materials/sampleTexture.ts';
import type { DomeLight, Scene } from '../../scene/types.ts';
import {
  REDDENED,
  REDDENED_COLORS,
  SCATTERED,
  SCATTERED_COLOR,
  scatteredShare,
  skyParts,
} from '../../spectrum/color/scatteredLight.ts';
import { neutralFilter } from '../../spectrum/reflectance/filterAlgebra.ts';
import { NO_LIGHT, plus, type SampledRadiance } from '../spectral/sampledRadiance.ts';
import { type SourceSpectrum, sourceSpectrumOf } from '../spectral/sourceSpectrum.ts';
import type { SpectralContext } from '../spectral/spectralContext.ts';
import { type SkySampler, skySampler } from './skySampler.ts';

/** A distant light: the unit direction in which it travels, how large it is, and what it shines with. */
export interface Sun {
  readonly direction: Vec3;
  /** Of its disc [rad]. */
  readonly radius: number;
  readonly sourceSpectrum: SourceSpectrum;
}

/** Radiance from world directions n (unit), for the sight of one who is at rest in the world. */
export interface Sky {
  radiance(n: Vec3, sight: SpectralContext): SampledRadiance;
  /** The discs of distant lights and their glow, which are in the sky for the eye alone: as light they have no size. */
  sunDiscs(n: Vec3, sight: SpectralContext): SampledRadiance;
  readonly sampler?: SkySampler;
}

export function skyOf(scene: Scene, suns: readonly Sun[]): Sky {
  const dome = sceneDome(scene);
  const dusky = hasDomeLight(scene);
  const bright = skySampler(dome);
  const color = domeColor(dome, scene.upAxis);
  return {
    radiance: (n, sight) => {
      if (dome.spectrum) return sight.emitted(sourceSpectrumOf(color(n), dome.spectrum));
      return dusky ? reddening(color(n), sight) : scattering(color(n), sight);
    },
    sunDiscs: (n, sight) =>
      suns.reduce((sum, sun) => plus(sum, sight.emitted(sun.sourceSpectrum), discAndGlow(n, sun)), NO_LIGHT),
    ...(bright && { sampler: bright }),
  };
}

/** Daylight of which air scatters the blue part: the rest is a filter that is nearly grey. */
function scattering(color: Vec3, sight: SpectralContext): SampledRadiance {
  const share = scatteredShare(color);
  if (share === 0) return sight.emitted(sourceSpectrumOf(color));
  return plus(
    sight.emitted(sourceSpectrumOf(addScaled(color, SCATTERED_COLOR, -share))),
    sight.emitted(scatteredSource(share)),
  );
}

/** The same, and what comes through much air, as at dusk. */
function reddening(color: Vec3, sight: SpectralContext): SampledRadiance {
  const { scattered, reddened, rest } = skyParts(color);
  let sum = sight.emitted(sourceSpectrumOf(rest));
  if (scattered > 0) sum = plus(sum, sight.emitted(scatteredSource(scattered)));
  reddened.forEach((share, i) => {
    const shine = { spectrum: REDDENED[i], filter: neutralFilter(share), color: scale(REDDENED_COLORS[i], share) };
    if (share > 0) sum = plus(sum, sight.emitted(shine));
  });
  return sum;
}

const scatteredSource = (share: number): SourceSpectrum => ({
  spectrum: SCATTERED,
  filter: neutralFilter(share),
  color: scale(SCATTERED_COLOR, share),
});

function domeColor(dome: DomeLight, upAxis: Scene['upAxis']): (n: Vec3) => Vec3 {
  const { color, texture, gradient } = dome;
  if (texture) return domePicture(texture, dome);
  if (!gradient) return () => color;
  const [up, sky] = [upVector(upAxis), { zenith: color, ...gradient }];
  return (n) => gradientAt(dot(n, up), sky);
}

function domePicture(texture: NonNullable<DomeLight['texture']>, dome: DomeLight): (n: Vec3) => Vec3 {
  const { color } = dome;
  const [x, y, z] = domeAxes(dome);
  return (n) => {
    const [u, v] = latLongFromDirection([dot(n, x), dot(n, y), dot(n, z)]);
    const [r, g, b] = sampleTexture(texture, u, v);
    return [r * color[0], g * color[1], b * color[2]];
  };
}

function discAndGlow(n: Vec3, { direction }: Sun): number {
  const away = 1 + dot(n, direction);
  const disc = SUN_DISC.radiance * (1 - smoothstep(...SUN_DISC.rim, away));
  return SUN_DISC.glows.reduce((sum, [strength, rate]) => sum + strength * Math.exp(-rate * away), disc);
}
