import {
  dot,
  Fn,
  float,
  floor,
  fract,
  max,
  mix,
  mrt,
  pow,
  screenCoordinate,
  select,
  step,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import type { Node, Texture, TextureNode } from 'three/webgpu';
import type { RenderSettings } from '../../../scene/view/view.ts';
import { toneMaps } from '../../../shaders/color/toneMap.ts';
import type { Vec3, Vec4 } from '../../../shaders/types.ts';
import type { GBuffer } from '../../gbuffer/gbuffer.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { pixelDirection, texelHere } from '../../gpu/fullScreenPass.ts';
import { depthHere } from '../../shading/passes.ts';
import { fxaa } from '../resolve/fxaa.ts';
import { fromYCoCg, toYCoCg } from '../resolve/temporalAntialiasing.ts';
import { gridOver } from './grid.ts';

/** What of the settings changes the passes of this file, and not their uniforms alone. */
export type DisplaySettings = Pick<RenderSettings, 'tone' | 'grid'> & {
  /** There are points of light in the sky, which are no edges to be smoothed. */
  readonly hasStars: boolean;
};

/** Linear light to display, 0 … 1, with the grid over it where that is wanted. */
function toneMapped(hdr: Vec3, buffer: GBuffer, uniforms: FrameUniforms, { tone, grid }: DisplaySettings): Vec3 {
  const picture = toneMaps[tone](hdr, uniforms.exposure).toVar();
  if (!grid) return picture;
  const lines = gridOver(pixelDirection(uniforms), depthHere(buffer), uniforms).toVar();
  return mix(picture, lines.xyz, lines.w).toVar();
}

/** One sample: encoded in 8 bits, for FXAA needs what the eye sees; 0 in the fourth, where only what has been smoothed already is. */
export const singleSample = (hdr: Texture, buffer: GBuffer, uniforms: FrameUniforms, look: DisplaySettings): Vec4 =>
  Fn(() => {
    const edged = look.hasStars ? step(0.5, texelHere(buffer.texture('object')).x) : float(1);
    return vec4(dithered(encodeSrgb(toneMapped(texelHere(hdr).rgb, buffer, uniforms, look))), edged);
  })();

/**
 * One of several samples, added to those before: the picture after tone mapping, so that edges of very bright things are smooth too and no
 * spark outshines its neighbours, and the light itself for the beauty AOV. The fourth: the sum of their weights.
 */
export function accumulatedSample(
  hdr: Texture,
  before: { readonly picture: TextureNode; readonly light: TextureNode },
  buffer: GBuffer,
  uniforms: FrameUniforms,
  look: DisplaySettings,
): Node {
  const sum = (now: Vec3, of: TextureNode): Vec4 =>
    select(uniforms.firstSample.greaterThan(0.5), vec4(0), texelHere(of)).add(vec4(now, 1).mul(uniforms.weight));
  const light = texelHere(hdr).rgb;
  return mrt({
    picture: Fn(() => sum(toneMapped(light, buffer, uniforms, look), before.picture))(),
    light: sum(light, before.light),
  });
}

export const unfiltered = (picture: Texture): Vec4 => vec4(texelHere(picture).rgb, 1);
export const antialiased = (picture: Texture): Vec4 => vec4(fxaa(picture), 1);
/** The mean of the samples that there are. */
export const sampleMean = (picture: TextureNode): Vec4 =>
  Fn(() => {
    const sum = texelHere(picture).toVar();
    return vec4(dithered(encodeSrgb(sum.rgb.div(sum.w))), 1);
  })();

/** One sample as temporalAntialiasing.ts takes it: what is shown, and 1/|Δx′| of the surface there [1/m], or 0. */
export const temporalSample = (hdr: Texture, buffer: GBuffer, uniforms: FrameUniforms, look: DisplaySettings): Vec4 =>
  Fn(() => {
    const near = max(depthHere(buffer), 1e-4).reciprocal();
    return vec4(toYCoCg(toneMapped(texelHere(hdr).rgb, buffer, uniforms, look)), near);
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

/** And back. */
export const decodeSrgb = (encoded: Vec3): Vec3 =>
  mix(encoded.div(12.92), pow(encoded.add(0.055).div(1.055), vec3(2.4)), step(vec3(0.04045), encoded));

/** Half a step of 8 bits of ordered noise, so that skies have no bands. Source: Jimenez 2014, interleaved gradient noise. */
function dithered(encoded: Vec3): Vec3 {
  const pixel = floor(screenCoordinate);
  const noise = fract(fract(dot(pixel, vec2(0.06711056, 0.00583715))).mul(52.9829189));
  return encoded.add(noise.sub(0.5).div(255));
}
