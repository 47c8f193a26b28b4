import { addScaled, dot, scale, type Vec3 } from '../../../math/vec3.ts';
import { domeAxes, latLongFromDirection } from '../../../scene/lights/latLong.ts';
import { hasDomeLight, upVector } from '../../../scene/lights/sceneLights.ts';
import { gradientAt } from '../../../scene/lights/skyGradient.ts';
import { sampleTexture } from '../../../scene/materials/sampleTexture.ts';
import type { DomeLight, Scene } from '../../../scene/types.ts';
import {
  REDDENED,
  REDDENED_COLORS,
  SCATTERED,
  SCATTERED_COLOR,
  scatteredShare,
  skyParts,
} from '../../../spectrum/color/scatteredLight.ts';
import { neutralFilter } from '../../../spectrum/reflectance/filterAlgebra.ts';
import { NO_LIGHT, plus, type SampledRadiance } from '../../spectral/sampledRadiance.ts';
import { type SourceSpectrum, sourceSpectrumOf } from '../../spectral/sourceSpectrum.ts';
import type { SpectralContext } from '../../spectral/spectralContext.ts';
import type { LightTracer } from './lightTracer.ts';
import { skySampler } from './skySampler.ts';

export const DOME_LIGHT: LightTracer<DomeLight> = {
  trace(dome, scene) {
    const color = domeColor(dome, scene.upAxis);
    const isReddened = hasDomeLight(scene);
    const sampler = skySampler(dome);
    return {
      radiance(n, context) {
        if (dome.blackbodies) return blackbodyLight(color(n), dome.blackbodies, context);
        if (dome.spectrum) return context.emitted(sourceSpectrumOf(color(n), dome.spectrum));
        return context.together(isReddened ? reddening(color(n), context) : scattering(color(n), context));
      },
      ...(sampler && { sampler }),
    };
  },
};

function blackbodyLight(
  amounts: Vec3,
  blackbodies: NonNullable<DomeLight['blackbodies']>,
  context: SpectralContext,
): SampledRadiance {
  return blackbodies.reduce(
    (sum, { channel, color, spectrum }) =>
      plus(sum, context.emitted(sourceSpectrumOf(color, spectrum)), amounts[channel]),
    NO_LIGHT,
  );
}

/** Daylight plus its blue part scattered by air, so that the filter of the remainder is nearly grey. */
function scattering(color: Vec3, context: SpectralContext): SampledRadiance {
  const amount = scatteredShare(color);
  if (amount === 0) return context.emitted(sourceSpectrumOf(color));
  return plus(
    context.emitted(sourceSpectrumOf(addScaled(color, SCATTERED_COLOR, -amount))),
    context.emitted(scatteredSource(amount)),
  );
}

/** The same, plus daylight reddened by much air, as at dusk. */
function reddening(color: Vec3, context: SpectralContext): SampledRadiance {
  const { scattered, reddened, rest } = skyParts(color);
  let sum = context.emitted(sourceSpectrumOf(rest));
  if (scattered > 0) sum = plus(sum, context.emitted(scatteredSource(scattered)));
  reddened.forEach((amount, i) => {
    const source = { spectrum: REDDENED[i], filter: neutralFilter(amount), color: scale(REDDENED_COLORS[i], amount) };
    if (amount > 0) sum = plus(sum, context.emitted(source));
  });
  return sum;
}

const scatteredSource = (amount: number): SourceSpectrum => ({
  spectrum: SCATTERED,
  filter: neutralFilter(amount),
  color: scale(SCATTERED_COLOR, amount),
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
