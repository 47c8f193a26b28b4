import { assertPictureSize } from '../../nodes/pictures/maxSize.ts';
import type {
  PictureRenderer,
  PictureRequest,
  PictureSize,
  RenderedPicture,
} from '../../nodes/pictures/pictureRenderer.ts';
import { SceneRenderer } from '../../render/renderer.ts';
import type { Backend } from '../../render/settings.ts';
import type { Scene } from '../../scene/types.ts';
import type { LightMeterReadings } from '../../scene/view/metering.ts';
import type { AovName, RenderSettings, ViewPoint } from '../../scene/view/view.ts';

/** Renders pictures of any size on a device of its own, while the viewport goes on. */
export class OffscreenRenderer implements PictureRenderer {
  readonly defaultSamples = 1;
  private readonly renderer: SceneRenderer;
  private readonly troubles: RendererFailure;

  /** `scenes`: the picture's, and those of further G-buffers of its frame graph. */
  static async open(
    backend: Backend | 'auto',
    scenes: readonly Scene[],
    size: PictureSize,
  ): Promise<OffscreenRenderer> {
    const troubles = new RendererFailure();
    const renderer = await SceneRenderer.create({
      canvas: document.createElement('canvas'),
      backend,
      sampleWorker: () => new Worker(new URL('../viewport/samples.worker.ts', import.meta.url), { type: 'module' }),
      onError: (error) => troubles.fail(error),
      onLost: (reason) => troubles.fail(new Error(reason)),
    });
    try {
      assertPictureSize(size, renderer.info.maxTextureSize);
    } catch (error) {
      renderer.dispose();
      throw error;
    }
    renderer.setSize(size.width, size.height);
    await renderer.setScene(scenes[0]!, scenes.slice(1));
    return new OffscreenRenderer(renderer, troubles);
  }

  private constructor(renderer: SceneRenderer, troubles: RendererFailure) {
    this.renderer = renderer;
    this.troubles = troubles;
  }

  async render({ view, settings, samples, pixels: wanted, aovs }: PictureRequest): Promise<RenderedPicture> {
    await this.draw(view, settings, samples);
    const renderer = this.renderer;
    const pixels = wanted ? await this.troubles.race(renderer.readPixels()) : new Uint8Array();
    const data = new Map<AovName, Float32Array>();
    for (const name of aovs) data.set(name, await this.troubles.race(renderer.readAov(name)));
    return { pixels, aovs: data };
  }

  async measureLight(view: ViewPoint, settings: RenderSettings): Promise<LightMeterReadings> {
    await this.draw(view, settings, 1);
    return this.troubles.race(this.renderer.measureLight());
  }

  private async draw(view: ViewPoint, settings: RenderSettings, samples: number): Promise<void> {
    const renderer = this.renderer;
    await nextFrame();
    // Compiles shaders between the viewport's frames.
    for (
      let busy = renderer.precompile(view, settings, samples);
      busy;
      busy = renderer.precompile(view, settings, samples)
    )
      await this.troubles.race(busy);
    renderer.render(view, settings, samples);
    while (renderer.info.waiting) {
      await this.troubles.race(nextFrame());
      renderer.render(view, settings, samples);
    }
  }

  close(): void {
    this.renderer.dispose();
  }
}

/** three.js updates a pass once per frame: a second picture in the same frame would repeat the first. */
const nextFrame = (): Promise<unknown> => new Promise((resolve) => requestAnimationFrame(resolve));

/** Errors that end all work: a lost device, unreadable samples. */
class RendererFailure {
  private meet: (error: Error) => void = () => {};
  private readonly met = new Promise<never>((_, reject) => {
    this.meet = reject;
  });

  constructor() {
    this.met.catch(() => {});
  }

  fail(error: Error): void {
    this.meet(error);
  }

  race<T>(work: Promise<T>): Promise<T> {
    return Promise.race([work, this.met]);
  }
}
