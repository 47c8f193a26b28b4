import type { Node, RenderTarget, WebGPURenderer } from 'three/webgpu';
import type { PixelRect } from '../../scene/view/pictureViews.ts';
import { FullScreenPass, type PassRegion } from './fullScreenPass.ts';

interface PassOptions {
  /** Serial number of the scene upload that the pass reads. */
  readonly owner?: number;
  readonly region?: PassRegion;
  /** The pixels that the pass draws; absent: all. */
  readonly rect?: PixelRect;
  /** Whether what the target holds is kept, except where the pass draws. */
  readonly over?: boolean;
}

/** Full-screen passes by name, created on first use and cached. */
export class PassCache {
  private readonly renderer: WebGPURenderer;
  private readonly passes = new Map<string, FullScreenPass>();

  constructor(renderer: WebGPURenderer) {
    this.renderer = renderer;
  }

  run(
    name: string,
    output: () => Node,
    target: RenderTarget | null,
    { owner, region, rect, over = region === 'surfaces' }: PassOptions = {},
  ): void {
    const key = owner === undefined ? name : `${owner}/${name}`;
    const pass = this.passes.get(key) ?? new FullScreenPass(output(), name, region);
    this.passes.set(key, pass);
    if (!target || !rect) {
      pass.render(this.renderer, target, over);
      return;
    }
    target.scissor.set(rect.x, rect.y, rect.width, rect.height);
    target.scissorTest = true;
    pass.render(this.renderer, target, over);
    target.scissorTest = false;
  }

  /** Disposes of the passes that read a scene. */
  releaseOwner(owner: number): void {
    for (const [key, pass] of this.passes) {
      if (!key.startsWith(`${owner}/`)) continue;
      pass.dispose();
      this.passes.delete(key);
    }
  }

  dispose(): void {
    for (const pass of this.passes.values()) pass.dispose();
  }
}
