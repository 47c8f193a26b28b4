import { Fn, If, ivec2, screenCoordinate, textureLoad, uniform, vec4 } from 'three/tsl';
import { type RenderTarget, Vector4, type WebGPURenderer } from 'three/webgpu';
import type { PixelRect } from '../scene/view/pictureViews.ts';
import { FullScreenPass } from './gpu/fullScreenPass.ts';

/** A view's displayed picture and its viewport. */
export interface ComposedView {
  readonly target: RenderTarget;
  readonly rect: PixelRect;
}

/** Draws the displayed pictures of several views onto the canvas; pixels outside all viewports are black. */
export class ViewCompositor {
  private readonly renderer: WebGPURenderer;
  private pass: FullScreenPass | undefined;
  private targets: readonly RenderTarget[] = [];
  private readonly rects: ReturnType<typeof rectUniform>[] = [];

  constructor(renderer: WebGPURenderer) {
    this.renderer = renderer;
  }

  present(views: readonly ComposedView[]): void {
    this.use(views.map(({ target }) => target));
    views.forEach(({ rect: { x, y, width, height } }, i) => {
      this.rects[i].value.set(x, y, width, height);
    });
    this.pass?.render(this.renderer, null);
  }

  dispose(): void {
    this.pass?.dispose();
  }

  private use(targets: readonly RenderTarget[]): void {
    const { pass, targets: previous } = this;
    if (pass && targets.length === previous.length && targets.every((target, i) => target === previous[i])) return;
    pass?.dispose();
    this.targets = targets;
    while (this.rects.length < targets.length) this.rects.push(rectUniform());
    this.pass = new FullScreenPass(this.output(), 'views');
  }

  private output() {
    const { targets, rects } = this;
    return Fn(() => {
      const pixel = ivec2(screenCoordinate).toVar();
      const color = vec4(0, 0, 0, 1).toVar();
      targets.forEach(({ texture }, i) => {
        const own = pixel.sub(ivec2(rects[i].xy)).toVar();
        const last = ivec2(rects[i].zw).sub(1).toVar();
        const inside = own.x
          .greaterThanEqual(0)
          .and(own.y.greaterThanEqual(0))
          .and(own.x.lessThanEqual(last.x))
          .and(own.y.lessThanEqual(last.y));
        If(inside, () => {
          color.assign(textureLoad(texture, own));
        });
      });
      return color;
    })();
  }
}

const rectUniform = () => uniform(new Vector4());
