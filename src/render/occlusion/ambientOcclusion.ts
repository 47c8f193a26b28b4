import { uniform } from 'three/tsl';
import { FloatType, type Node, RedFormat, type RenderTarget, type Texture, Vector2 } from 'three/webgpu';
import { dataTarget, type GBuffer } from '../gbuffer/gbuffer.ts';
import type { SpacetimeProjection } from '../geometry/vertexStage.ts';
import type { Gpu } from '../gpu/device.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { FullScreenPass } from '../gpu/fullScreenPass.ts';
import { DOWNSAMPLING, openness } from './openness.ts';
import { smoothOpenness, upsampleOpenness } from './opennessFilter.ts';

/** How a G-buffer was drawn, and the radius of its ambient occlusion. */
export interface AmbientOcclusionRequest {
  readonly place: SpacetimeProjection['place'];
  /** Whether any object moves. */
  readonly moving: boolean;
  /** Occluders farther from a point than this are ignored [m, rest frame of the point]. */
  readonly radius: number;
}

/**
 * Screen-space ambient occlusion: the unoccluded fraction of each point's sky, weighted by the cosine; one number per pixel, 1 where there is no surface. Depends
 * on the G-buffer only, without randomness, so the same picture always has the same occlusion.
 */
export class AmbientOcclusion {
  /** The result, one channel. */
  readonly target = dataTarget(1, FloatType);
  private readonly gpu: Gpu;
  private readonly buffer: GBuffer;
  private readonly uniforms: FrameUniforms;
  private readonly lowResolution = [dataTarget(1, FloatType), dataTarget(1, FloatType)] as const;
  private readonly size = uniform(new Vector2(1, 1));
  private readonly radius = uniform(1);
  private readonly passes = new Map<string, FullScreenPass>();

  constructor(gpu: Gpu, buffer: GBuffer, uniforms: FrameUniforms) {
    this.gpu = gpu;
    this.buffer = buffer;
    this.uniforms = uniforms;
    this.target.texture.format = RedFormat;
  }

  get texture(): Texture {
    return this.target.texture;
  }

  setSize(width: number, height: number): void {
    this.size.value.set(width, height);
    this.target.setSize(width, height);
    for (const target of this.lowResolution)
      target.setSize(Math.ceil(width / DOWNSAMPLING), Math.ceil(height / DOWNSAMPLING));
  }

  draw({ place, moving, radius }: AmbientOcclusionRequest): void {
    const { buffer, uniforms, size, target } = this;
    const [first, second] = this.lowResolution;
    const view = { uniforms, size, radius: this.radius, place, moving };
    this.radius.value = radius;
    this.run(`visibility ${place} ${moving}`, first, () => openness(buffer, view));
    this.run('smoothed', second, () => smoothOpenness(first.texture, view));
    this.run('spread', target, () => upsampleOpenness(second.texture, buffer, view));
  }

  dispose(): void {
    for (const pass of this.passes.values()) pass.dispose();
    for (const target of [...this.lowResolution, this.target]) target.dispose();
  }

  private run(name: string, target: RenderTarget, output: () => Node): void {
    const pass = this.passes.get(name) ?? new FullScreenPass(output(), `occlusion ${name}`);
    this.passes.set(name, pass);
    pass.render(this.gpu.renderer, target);
  }
}
