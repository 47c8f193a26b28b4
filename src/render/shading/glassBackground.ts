import { Fn, vec4 } from 'three/tsl';
import { HalfFloatType, LinearFilter, LinearMipmapLinearFilter, type RenderTarget, type Texture } from 'three/webgpu';
import type { Vec4 } from '../../shaders/types.ts';
import { dataTarget } from '../gbuffer/gbuffer.ts';
import { texelHere } from '../gpu/fullScreenPass.ts';
import { limitLight } from '../gpu/lightRange.ts';

/** The target of the light behind glass, with mipmaps by which rough glass blurs it; halves, because 32-bit floats cannot be filtered everywhere. */
export function glassBackground({ width, height }: { readonly width: number; readonly height: number }): RenderTarget {
  const target = dataTarget(1, HalfFloatType);
  Object.assign(target.texture, {
    generateMipmaps: true,
    minFilter: LinearMipmapLinearFilter,
    magFilter: LinearFilter,
  });
  target.setSize(width, height);
  return target;
}

/** The largest light in it: half of the largest half, of which mipmaps are means. */
const MAX_BACKGROUND = 32_752;

/** Copies light into the target. */
export const backgroundPass = (light: Texture): Vec4 =>
  Fn(() => vec4(limitLight(texelHere(light).rgb, MAX_BACKGROUND), 1))();
