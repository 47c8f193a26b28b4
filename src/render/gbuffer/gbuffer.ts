import {
  DepthTexture,
  FloatType,
  HalfFloatType,
  NearestFilter,
  NoColorSpace,
  RenderTarget,
  RGBAFormat,
  RGFormat,
  type TextureDataType,
} from 'three/webgpu';
import { GBUFFER_TARGETS, type TargetName } from './surface.ts';

const FLOATS: ReadonlySet<TargetName> = new Set(['object', 'event', 'motion']);

/**
 * The G-buffer: one pass that writes all targets, or two that draw the scene twice if the device allows fewer bytes per sample (WebGPU guarantees 32) or
 * fewer attachments.
 */
export class GBuffer {
  readonly passes: readonly { readonly names: readonly TargetName[]; readonly target: RenderTarget }[];
  /** Depth of the opaque scene, for passes that draw only where there is a surface, or none. */
  readonly depth = surfaceDepth();

  constructor(bytesPerSample: number, attachments: number) {
    const names = Object.keys(GBUFFER_TARGETS) as TargetName[];
    const fitsOnePass =
      names.reduce((sum, name) => sum + GBUFFER_TARGETS[name], 0) <= bytesPerSample && names.length <= attachments;
    const groups = fitsOnePass
      ? [names]
      : [names.filter((n) => GBUFFER_TARGETS[n] <= 8), names.filter((n) => GBUFFER_TARGETS[n] > 8)];
    this.passes = groups.map((group) => ({ names: group, target: makeTarget(group, this.depth) }));
  }

  texture(name: TargetName) {
    const { target, index } = this.find(name);
    return target.textures[index];
  }

  find(name: TargetName): { readonly target: RenderTarget; readonly index: number } {
    for (const { names, target } of this.passes)
      if (names.includes(name)) return { target, index: names.indexOf(name) };
    throw new Error(`no target ${name}`);
  }

  setSize(width: number, height: number): void {
    for (const { target } of this.passes) target.setSize(width, height);
  }

  dispose(): void {
    for (const { target } of this.passes) target.dispose();
  }
}

function makeTarget(names: readonly TargetName[], depth: DepthTexture): RenderTarget {
  const target = dataTarget(names.length, HalfFloatType, depth);
  names.forEach((name, i) => {
    target.textures[i].name = name;
    if (FLOATS.has(name)) target.textures[i].type = FloatType;
    if (name === 'object') target.textures[i].format = RGFormat;
  });
  return target;
}

/** A depth texture for surfaces. */
export const surfaceDepth = (): DepthTexture => new DepthTexture(1, 1, FloatType);

/**
 * A render target of data, not colours, read texel by texel without filtering. `depth`: depth texture to share with another target; without it there is no
 * depth buffer.
 */
export function dataTarget(count: number, type: TextureDataType, depth?: DepthTexture): RenderTarget {
  const target = new RenderTarget(1, 1, {
    count,
    type,
    format: RGBAFormat,
    depthBuffer: depth !== undefined,
    ...(depth && { depthTexture: depth }),
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    colorSpace: NoColorSpace,
  });
  return target;
}
