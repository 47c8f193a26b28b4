import { DataTexture, FloatType, RGBAFormat, RGFormat } from 'three/webgpu';
import { toMatrix } from '../../../src/math/quat.ts';
import { gamma } from '../../../src/physics/lorentz/boost.ts';
import type { EffectInput, FloatImage } from '../../../src/reference/post/effects/effectInput.ts';
import { setSkyColors } from '../../../src/render/frameSetup.ts';
import { dataTarget } from '../../../src/render/gbuffer/gbuffer.ts';
import { readFloats } from '../../../src/render/gbuffer/readback.ts';
import type { Gpu } from '../../../src/render/gpu/device.ts';
import { makeFrameUniforms } from '../../../src/render/gpu/frameUniforms.ts';
import {
  CODE_OFFSET,
  encodeOctahedral,
  GBUFFER_NORMAL_STEPS,
  NORMAL_LOW_STEPS,
} from '../../../src/render/gpu/packNormal.ts';
import { setLensUniforms } from '../../../src/render/lenses/lensUniforms.ts';
import type { GBufferTextures } from '../../../src/render/post/effectContext.ts';
import { EffectPasses } from '../../../src/render/post/effectPasses.ts';
import { EFFECTS } from '../../../src/scene/frameGraph/effects.ts';
import { readShaderText } from '../../../src/scene/shaderText/shaderText.ts';
import { isPanoramic } from '../../../src/scene/view/lenses/lenses.ts';
import { frustumOf } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { AovName } from '../../../src/scene/view/view.ts';
import { type EffectCase, maskOf, overOf, pictureOf } from './effectCases.ts';

/** The result of a case on this GPU: three numbers per pixel. */
export async function runEffect(gpu: Gpu, of: EffectCase): Promise<Float32Array> {
  const picture = pictureOf(of);
  const { width, height } = picture.image;
  const passes = passesOf(of, picture);
  const target = dataTarget(1, FloatType);
  passes.setSize(width, height);
  target.setSize(width, height);
  passes.render(gpu.renderer, target, of, picture.view.t);
  const values = await readFloats(gpu, target, 0, { x: 0, y: 0, width, height });
  passes.dispose();
  target.dispose();
  return values.filter((_, i) => i % 4 < 3);
}

/** The part of the G-buffer that is read. */
function readsOf({ of }: EffectCase): number {
  if (typeof of === 'string') return EFFECTS[of].reads.length;
  return 'text' in of ? readShaderText(of.text).reads.length : 0;
}

function passesOf(of: EffectCase, picture: EffectInput): EffectPasses {
  const inputs = {
    image: textureOf(picture.image),
    mask: of.masked ? textureOf(maskOf(picture)) : undefined,
    buffer: readsOf(of) > 0 ? bufferOf(picture) : undefined,
    uniforms: uniformsOf(picture),
    type: FloatType,
  };
  if (typeof of.of === 'string') return EffectPasses.forEffect(of.of, inputs);
  if ('text' in of.of)
    return EffectPasses.forEffect(readShaderText(of.of.text), { ...inputs, second: textureOf(overOf(picture)) });
  return EffectPasses.forMix(of.of.mode, textureOf(overOf(picture)), inputs);
}

/** The uniforms that the renderer sets per picture. */
export function uniformsOf({ view, image, zenith, sky, settings, observer }: EffectInput) {
  const uniforms = makeFrameUniforms();
  uniforms.u.value.set(...view.u);
  uniforms.secondsPerMetre.value = 1 / settings.speedOfLight;
  uniforms.gamma.value = gamma(view.u);
  setLensUniforms(uniforms.lens, view.lens, image);
  if (!isPanoramic(view.lens)) {
    const { tanX, tanY, center } = frustumOf(view.lens, image.width, image.height);
    uniforms.halfTangents.value.set(tanX, tanY);
    uniforms.frustumCenter.value.set(...center);
  }
  uniforms.orientation.value.fromArray([...toMatrix(view.orientation)]).transpose();
  uniforms.zenith.value.set(...zenith);
  if (observer) uniforms.toObserver.value.set(...observer);
  if (sky) setSkyColors(uniforms, sky);
  return uniforms;
}

export const textureOf = ({ width, height, values, channels }: FloatImage): DataTexture =>
  dataTexture(width, height, (i) => [...values.subarray(channels * i, channels * (i + 1)), 1]);

/** A G-buffer filled with the data of a picture. */
export function bufferOf({ aovs, view, settings, image: { width, height } }: EffectInput): GBufferTextures {
  const at = (name: AovName, i: number, k: number): number => {
    const values = aovs.get(name) ?? [];
    return values[(values.length / (width * height)) * i + k] ?? 0;
  };
  const textures = {
    base: dataTexture(width, height, (i) => [
      ...[0, 1, 2].map((k) => at('albedo', i, k)),
      packedFine(at('roughness', i, 0)),
    ]),
    emissive: dataTexture(width, height, (i) => [0, 0, 0, packedFine(at('metallic', i, 0))]),
    object: dataTexture(width, height, (i) => [at('object', i, 0), at('depth', i, 0)], RGFormat),
    normal: dataTexture(width, height, (i) => packed(at('normal', i, 0), at('normal', i, 1), at('normal', i, 2))),
    event: dataTexture(width, height, (i) => [
      ...view.position.map((p, k) => at('position', i, k) - p),
      (at('emission_time', i, 0) - view.t) * settings.speedOfLight,
    ]),
    motion: dataTexture(width, height, (i) => [...[0, 1, 2].map((k) => at('velocity', i, k)), at('doppler', i, 0)]),
  };
  return {
    texture: (name) => {
      if (!(name in textures)) throw new Error(`no effect was to read ${name}`);
      return textures[name as keyof typeof textures];
    },
  };
}

/** As written by `packTwo` of surfacePacking.ts, with the other number in its first step: 2⁻¹⁴ (1 + (2 + 1020 x)/1024). */
const packedFine = (x: number): number => 2 ** -14 * (1 + (2 + 1020 * x) / 1024);

/** As written by `packNormals`, without reflectance. */
function packed(x: number, y: number, z: number): readonly number[] {
  const fine = encodeOctahedral(x, y, z).map((place) => Math.round((place * 0.5 + 0.5) * GBUFFER_NORMAL_STEPS));
  const coarse = fine.map((step) => Math.floor(step / NORMAL_LOW_STEPS));
  return [...coarse, ...fine.map((step, k) => step - NORMAL_LOW_STEPS * coarse[k])].map((code) => code - CODE_OFFSET);
}

function dataTexture(
  width: number,
  height: number,
  texel: (i: number) => readonly number[],
  format: typeof RGBAFormat | typeof RGFormat = RGBAFormat,
): DataTexture {
  const data = Float32Array.from(Array.from({ length: width * height }, (_, i) => texel(i)).flat());
  const texture = new DataTexture(data, width, height, format, FloatType);
  texture.needsUpdate = true;
  return texture;
}
