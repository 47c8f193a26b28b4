import { abs, Fn, float, log, max, mix, mrt, pow, select, step, vec3, vec4 } from 'three/tsl';
import type { Node, Texture, TextureNode } from 'three/webgpu';
import type { RenderSettings } from '../../../scene/view/view.ts';
import { toneMaps } from '../../../shaders/color/toneMap.ts';
import type { Float, Vec3, Vec4 } from '../../../shaders/types.ts';
import { UNLIT_RANGE } from '../../../spectrum/display/toneMap.ts';
import type { GBuffer } from '../../gbuffer/gbuffer.ts';
import { unpackSpecular } from '../../gbuffer/surfacePacking.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { texelHere } from '../../gpu/fullScreenPass.ts';
import { interleavedGradientNoise } from '../../gpu/gradientNoise.ts';
import { pixelDirection, shownHere } from '../../lenses/pixelDirection.ts';
import { depthHere } from '../../shading/passes.ts';
import { fxaa } from '../resolve/fxaa.ts';
import { gridOver } from './grid.ts';
import type { PictureOverlay } from './overlay.ts';
import { fromYCoCg, toYCoCg } from './yCoCg.ts';

/** The settings that change the compiled passes of this file, rather than only their uniforms. */
export type DisplaySettings = Pick<RenderSettings, 'tone' | 'grid'> & {
  /** Whether there are points of light in the sky, which are no edges to be smoothed. */
  readonly hasStars: boolean;
  /** Whether there are surfaces that emit their own colour, which are shown without the tone curve while they are seen unshifted. */
  readonly hasUnlit: boolean;
  /** Absent: none. */
  readonly overlay?: PictureOverlay;
};

/** Identifies the shaders of display settings. */
export const displayKey = ({ tone, grid, hasStars, hasUnlit, overlay }: DisplaySettings): string =>
  `${tone} ${grid} ${hasStars} ${hasUnlit} ${overlay?.key}`;

/** Tone-maps linear light to 0 … 1, and draws the overlay and the grid over it if enabled. */
function toneMapped(
  hdr: Vec3,
  buffer: GBuffer,
  uniforms: FrameUniforms,
  { tone, grid, hasUnlit, overlay }: DisplaySettings,
): Vec3 {
  const picture = toneMaps[tone](hdr, uniforms.exposure).toVar();
  if (hasUnlit && tone !== 'linear')
    picture.assign(mix(picture, toneMaps.linear(hdr, uniforms.exposure), unlitShareHere(buffer, uniforms)));
  for (const layer of overlay?.layers() ?? []) picture.assign(mix(picture, layer.xyz, layer.w));
  if (grid) {
    const lines = gridOver(pixelDirection(uniforms), depthHere(buffer), uniforms).toVar();
    picture.assign(mix(picture, lines.xyz, lines.w));
  }
  picture.mulAssign(shownHere(uniforms));
  return picture;
}

/** `unlitShare` of what is seen here: 0 but on surfaces that reflect nothing and do not glow by their temperature. */
function unlitShareHere(buffer: GBuffer, { dopplerMix, beaming }: FrameUniforms): Float {
  const [base, emissive, object, motion] = (['base', 'emissive', 'object', 'motion'] as const).map((name) =>
    texelHere(buffer.texture(name)).toVar(),
  );
  const { metallic, F0 } = unpackSpecular(emissive.w);
  const reflected = base.x.add(base.y).add(base.z).add(metallic).add(F0);
  const isUnlit = reflected.lessThanEqual(0).and(emissive.z.greaterThanEqual(0)).and(object.x.greaterThan(0.5));
  const shift = abs(log(max(motion.w, 1e-20))).mul(max(dopplerMix, beaming));
  return select(isUnlit, max(shift.div(UNLIT_RANGE).oneMinus(), 0), 0);
}

/** A single sample: encoded in 8 bits, because FXAA needs perceived contrast; alpha is 0 where pixels are already smooth. */
export const singleSample = (hdr: Texture, buffer: GBuffer, uniforms: FrameUniforms, settings: DisplaySettings): Vec4 =>
  Fn(() => {
    const isSurface = settings.hasStars ? step(0.5, texelHere(buffer.texture('object')).x) : float(1);
    return vec4(dithered(encodeSrgb(toneMapped(texelHere(hdr).rgb, buffer, uniforms, settings))), isSurface);
  })();

/**
 * Adds one of several samples to those before: the picture after tone mapping, so that edges of very bright objects are smooth too and fireflies do not
 * outshine their neighbours; and the light itself for the beauty AOV. Alpha is the sum of weights.
 */
export function accumulatedSample(
  hdr: Texture,
  previous: { readonly picture: TextureNode; readonly light: TextureNode },
  buffer: GBuffer,
  uniforms: FrameUniforms,
  settings: DisplaySettings,
): Node {
  const sum = (current: Vec3, previousTexture: TextureNode): Vec4 =>
    select(uniforms.firstSample.greaterThan(0.5), vec4(0), texelHere(previousTexture)).add(
      vec4(current, 1).mul(uniforms.weight),
    );
  const light = texelHere(hdr).rgb;
  return mrt({
    picture: Fn(() => sum(toneMapped(light, buffer, uniforms, settings), previous.picture))(),
    light: sum(light, previous.light),
  });
}

export const unfiltered = (picture: Texture): Vec4 => vec4(texelHere(picture).rgb, 1);
export const antialiased = (picture: Texture): Vec4 => vec4(fxaa(picture), 1);
/** The mean of the samples so far. */
export const sampleMean = (picture: TextureNode): Vec4 =>
  Fn(() => {
    const sum = texelHere(picture).toVar();
    return vec4(dithered(encodeSrgb(sum.rgb.div(sum.w))), 1);
  })();

/** A sample as temporalAntialiasing.ts reads it: the tone-mapped colour, and 1/|Δx′| of the surface [1/m], or 0. */
export const temporalSample = (
  hdr: Texture,
  buffer: GBuffer,
  uniforms: FrameUniforms,
  settings: DisplaySettings,
): Vec4 =>
  Fn(() => {
    const inverseDistance = max(depthHere(buffer), 1e-4).reciprocal();
    return vec4(toYCoCg(toneMapped(texelHere(hdr).rgb, buffer, uniforms, settings)), inverseDistance);
  })();
export const temporalResult = (history: TextureNode): Vec4 =>
  vec4(dithered(encodeSrgb(fromYCoCg(texelHere(history).xyz).clamp(0, 1))), 1);

/** sRGB encoding, IEC 61966-2-1. */
export function encodeSrgb(linear: Vec3): Vec3 {
  const low = linear.mul(12.92);
  const high = pow(linear.clamp(0, 1), vec3(1 / 2.4))
    .mul(1.055)
    .sub(0.055);
  return mix(low, high, step(vec3(0.0031308), linear));
}

/** The inverse of `encodeSrgb`. */
export const decodeSrgb = (encoded: Vec3): Vec3 =>
  mix(encoded.div(12.92), pow(encoded.add(0.055).div(1.055), vec3(2.4)), step(vec3(0.04045), encoded));

/** Adds ordered noise of ± half an 8-bit step, so that skies show no bands. */
const dithered = (encoded: Vec3): Vec3 => encoded.add(interleavedGradientNoise().sub(0.5).div(255));
