import { DataUtils, type RenderTarget } from 'three/webgpu';
import type { Vec3 } from '../../math/vec3.ts';
import type { PixelRect } from '../../scene/view/pictureViews.ts';
import type { DataAov } from '../../scene/view/view.ts';
import type { Observation } from '../geometry/observation.ts';
import type { Gpu } from '../gpu/device.ts';
import { unpackGBufferNormal } from '../gpu/packNormal.ts';
import { type RawPixels, readWebGl } from '../gpu/webglReadback.ts';
import type { PickedSurface, PickResult } from '../settings.ts';
import type { GBuffer } from './gbuffer.ts';
import type { TargetName } from './surface.ts';
import { unpackFine } from './surfacePacking.ts';

/** Four floats (or one) per pixel of a float target, rows from the top. */
export async function readFloats(
  gpu: Gpu,
  target: RenderTarget,
  index: number,
  region: PixelRect,
): Promise<Float32Array> {
  const raw = await readRaw(gpu, target, index, region);
  if (raw instanceof Float32Array) return raw;
  const out = new Float32Array(raw.length);
  for (let i = 0; i < raw.length; i++) out[i] = DataUtils.fromHalfFloat(raw[i]);
  return out;
}

export async function readBytes(gpu: Gpu, target: RenderTarget, region: PixelRect): Promise<Uint8Array> {
  const raw = await readRaw(gpu, target, 0, region);
  return new Uint8Array(raw.buffer, raw.byteOffset, raw.byteLength);
}

async function readRaw(gpu: Gpu, target: RenderTarget, index: number, region: PixelRect): Promise<RawPixels> {
  const { x, y, width, height } = region;
  if (gpu.backend !== 'webgl')
    return (await gpu.renderer.readRenderTargetPixelsAsync(target, x, y, width, height, index)) as RawPixels;
  const fromBottom = { ...region, y: target.height - y - height };
  const raw = await readWebGl(gpu.renderer, target.textures[index]!, fromBottom);
  flipRows(raw, height);
  return raw;
}

function flipRows(pixels: RawPixels, rows: number): void {
  const row = pixels.length / rows;
  for (let top = 0, bottom = rows - 1; top < bottom; top++, bottom--) {
    const topRow = pixels.slice(top * row, (top + 1) * row);
    pixels.copyWithin(top * row, bottom * row, (bottom + 1) * row);
    pixels.set(topRow, bottom * row);
  }
}

/** The targets that AOVs are read from: the G-buffer, and the openness computed from it. */
export interface DataTargets {
  readonly buffer: GBuffer;
  openness(): RenderTarget;
}

/** The target of each AOV, and its values from the four floats of a pixel; times and places are converted to the world's in f64, then to f32. */
const AOV_SOURCES: Record<
  DataAov,
  { target: TargetName | 'openness'; values: (texel: Float32Array, observation: Observation) => readonly number[] }
> = {
  albedo: { target: 'base', values: ([r, g, b]) => [r, g, b] },
  depth: { target: 'object', values: ([, distance]) => [distance] },
  emission_time: { target: 'event', values: ([, , , w], observation) => [observation.t + w / observation.c] },
  emission_time_relative: { target: 'event', values: ([, , , w], { c }) => [w / c] },
  position: { target: 'event', values: ([x, y, z], { position: p }) => [p[0] + x, p[1] + y, p[2] + z] },
  doppler: { target: 'motion', values: ([, , , w]) => [w] },
  roughness: { target: 'base', values: ([, , , code]) => [unpackFine(code)] },
  metallic: { target: 'emissive', values: ([, , , code]) => [unpackFine(code)] },
  occlusion: { target: 'openness', values: ([openness]) => [openness] },
  velocity: { target: 'motion', values: ([x, y, z]) => [x, y, z] },
  normal: { target: 'normal', values: unpackGBufferNormal },
  object: { target: 'object', values: ([x]) => [x] },
};

/** A data AOV of a region; 0 where there is no surface. */
export async function readData(
  gpu: Gpu,
  targets: DataTargets,
  name: DataAov,
  observation: Observation,
  region: PixelRect,
): Promise<Float32Array> {
  const { target, values } = AOV_SOURCES[name];
  const read = (from: TargetName | 'openness') => {
    if (from === 'openness') return readFloats(gpu, targets.openness(), 0, region);
    const { target: renderTarget, index } = targets.buffer.find(from);
    return readFloats(gpu, renderTarget, index, region);
  };
  const [ids, texels] = await Promise.all([read('object'), read(target)]);
  const pixels = region.width * region.height;
  const [idSize, size] = [ids.length / pixels, texels.length / pixels];
  const channels = values(new Float32Array(4), observation).length;
  const out = new Float32Array(pixels * channels);
  for (let i = 0; i < pixels; i++) {
    if (ids[i * idSize] < 0.5) continue;
    out.set(values(texels.subarray(i * size, (i + 1) * size), observation), i * channels);
  }
  return out;
}

/** What is read of a pixel: the targets of the G-buffer that say which surface it is and at which event, and the light. */
export const PIXEL_SOURCES = ['object', 'event', 'motion', 'light'] as const;
export type PixelSource = (typeof PIXEL_SOURCES)[number];
/** Four floats of each. */
export type PixelTexels = Readonly<Record<PixelSource, Float32Array>>;

/** What one pixel shows, from the texels of `PIXEL_SOURCES`. `pathOf`: object number → path. */
export function pickedPixel(
  texels: PixelTexels,
  observation: Observation,
  pathOf: (objectId: number) => string,
): PickResult {
  const value = (name: DataAov) =>
    AOV_SOURCES[name].values(texels[AOV_SOURCES[name].target as PixelSource], observation);
  const [r, g, b] = texels.light;
  const light: Vec3 = [r, g, b];
  const [objectId] = value('object');
  if (objectId < 0.5) return { light };
  const surface: PickedSurface = {
    objectId,
    path: pathOf(objectId),
    emissionTime: value('emission_time')[0],
    position: value('position') as unknown as Vec3,
    velocity: value('velocity') as unknown as Vec3,
    doppler: value('doppler')[0],
    depth: value('depth')[0],
  };
  return { light, surface };
}
