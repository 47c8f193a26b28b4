import { refuseLarger } from '../../nodes/drawing/largest.ts';
import type { Painted, PicturePainter, PictureRequest, Size } from '../../nodes/drawing/painter.ts';
import { SceneRenderer } from '../../render/renderer.ts';
import type { Backend } from '../../render/settings.ts';
import type { Gauge } from '../../scene/gauge.ts';
import type { Scene } from '../../scene/types.ts';
import type { AovName, RenderSettings, ViewPoint } from '../../scene/view.ts';

/** Draws pictures of any size beside the one on show, with a device of its own: what is shown goes on. */
export class PagePainter implements PicturePainter {
  readonly usualSamples = 1;
  readonly #renderer: SceneRenderer;
  readonly #troubles: Troubles;

  /** `scenes`: a picture's, and those of its plan's other G-buffers. */
  static async open(backend: Backend | 'auto', scenes: readonly Scene[], size: Size): Promise<PagePainter> {
    const troubles = new Troubles();
    const renderer = await SceneRenderer.create({
      canvas: document.createElement('canvas'),
      backend,
      sampleWorker: () => new Worker(new URL('../viewport/samples.worker.ts', import.meta.url), { type: 'module' }),
      onProblem: (error) => troubles.meet(error),
      onLost: (reason) => troubles.meet(new Error(reason)),
    });
    try {
      refuseLarger(size, renderer.info.largest);
    } catch (error) {
      renderer.dispose();
      throw error;
    }
    renderer.setSize(size.width, size.height);
    await renderer.setScene(scenes[0]!, scenes.slice(1));
    return new PagePainter(renderer, troubles);
  }

  private constructor(renderer: SceneRenderer, troubles: Troubles) {
    this.#renderer = renderer;
    this.#troubles = troubles;
  }

  async paint({ view, settings, samples, pixels: wanted, aovs }: PictureRequest): Promise<Painted> {
    await this.#draw(view, settings, samples);
    const renderer = this.#renderer;
    const pixels = wanted ? await this.#troubles.orElse(renderer.readPixels()) : new Uint8Array();
    const data = new Map<AovName, Float32Array>();
    for (const name of aovs) data.set(name, await this.#troubles.orElse(renderer.readAov(name)));
    return { pixels, aovs: data };
  }

  async measure(view: ViewPoint, settings: RenderSettings): Promise<Gauge> {
    await this.#draw(view, settings, 1);
    return this.#troubles.orElse(this.#renderer.gauge());
  }

  async #draw(view: ViewPoint, settings: RenderSettings, samples: number): Promise<void> {
    const renderer = this.#renderer;
    await nextFrame();
    // Shaders are compiled between the frames of the picture on show.
    for (let busy = renderer.prepare(view, settings, samples); busy; busy = renderer.prepare(view, settings, samples))
      await this.#troubles.orElse(busy);
    renderer.render(view, settings, samples);
    while (renderer.info.waiting) {
      await this.#troubles.orElse(nextFrame());
      renderer.render(view, settings, samples);
    }
  }

  close(): void {
    this.#renderer.dispose();
  }
}

/** three's passes are made once a frame of the page: in the same one, the second picture would be the first. */
const nextFrame = (): Promise<unknown> => new Promise((resolve) => requestAnimationFrame(resolve));

/** What ends all work: a device that is lost, samples that cannot be read. */
class Troubles {
  #meet: (error: Error) => void = () => {};
  readonly #met = new Promise<never>((_, reject) => {
    this.#meet = reject;
  });

  constructor() {
    this.#met.catch(() => {});
  }

  meet(error: Error): void {
    this.#meet(error);
  }

  orElse<T>(work: Promise<T>): Promise<T> {
    return Promise.race([work, this.#met]);
  }
}
