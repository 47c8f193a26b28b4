import type { InteractiveRenderer } from '../../pipelines/interactiveRenderer.ts';
import { contentKey } from '../../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../../scene/types.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import { sceneUpVector } from '../state/observer.ts';
import { sampleWorker, tessellationWorker } from '../viewport/rendererWorkers.ts';
import type { PreviewContext } from '../viewport/viewportRenderer.ts';
import { type OutsideLook, outsideExposure, outsideSettings } from './outsidePicture.ts';

type RendererBeside = ReturnType<NonNullable<InteractiveRenderer['beside']>>;

/** Pause after a picture, as a multiple of the time that it took: on the processor the picture of the viewport comes first. */
const PAUSE = { device: 0.5, software: 6 } as const;

/** Draws the outside view on a canvas of its own, when something has changed; one picture at a time. */
export class OutsideDrawer {
  private readonly canvas: HTMLCanvasElement;
  private readonly onError: (error: unknown) => void;
  private renderer: { readonly of: InteractiveRenderer; readonly beside: RendererBeside } | undefined;
  private scene: Scene | undefined;
  private exposure = 0;
  private drawn = '';
  private stale = false;
  private busy = false;
  private nextDraw = 0;
  private stopped = false;

  /** `onError` is told of a scene that cannot be drawn, and of shaders that do not compile. */
  constructor(canvas: HTMLCanvasElement, onError: (error: unknown) => void) {
    this.canvas = canvas;
    this.onError = onError;
  }

  /** Call it before every paint. */
  tick(context: PreviewContext, look: OutsideLook, now: number): void {
    if (this.busy || this.stopped || now < this.nextDraw || document.hidden) return;
    const ratio = context.software ? 1 : devicePixelRatio;
    const { clientWidth, clientHeight } = this.canvas;
    const size = { width: Math.round(clientWidth * ratio), height: Math.round(clientHeight * ratio) };
    if (size.width < 1 || size.height < 1) return;
    const { view, picture, software } = context;
    const up = sceneUpVector(picture.scene);
    const settings = outsideSettings({ ...view.settings, shadows: !software }, look, up, this.exposure);
    const { viewPoint } = view;
    const key = contentKey([viewPoint, settings, size]);
    if (key === this.drawn && !this.stale && this.scene === picture.scene) return;
    this.busy = true;
    this.stale = false;
    const start = performance.now();
    this.draw(context, viewPoint, settings, size)
      .then((complete) => {
        this.drawn = complete ? key : '';
      })
      .catch((error: unknown) => {
        // If the device was lost, another renderer comes.
        if (this.renderer?.of === context.renderer) this.onError(error);
        this.drawn = key;
      })
      .finally(() => {
        this.busy = false;
        const took = performance.now() - start;
        this.nextDraw = performance.now() + took * (software ? PAUSE.software : PAUSE.device);
        if (this.stopped) this.release();
      });
  }

  stop(): void {
    this.stopped = true;
    if (!this.busy) this.release();
  }

  /** Returns false if parts of the picture are still being loaded. */
  private async draw(
    { renderer: of, picture, showFilms }: PreviewContext,
    viewPoint: ViewPoint,
    settings: RenderSettings,
    size: PictureSize,
  ): Promise<boolean> {
    const beside = this.rendererBeside(of);
    if (!beside) return true;
    if (this.scene !== picture.scene) {
      await beside.setScene(picture.scene);
      this.scene = picture.scene;
    }
    showFilms(beside);
    beside.setSize(size.width, size.height);
    for (let busy = beside.precompile([viewPoint], settings); busy; busy = beside.precompile([viewPoint], settings))
      await busy;
    if (this.stopped) return true;
    beside.render([viewPoint], settings, 1);
    if (beside.info.waiting) return false;
    const pixels = new Uint8ClampedArray(await beside.readPixels());
    const { width, height } = beside;
    if (this.stopped || pixels.length !== 4 * width * height) return false;
    this.canvas.width = width;
    this.canvas.height = height;
    this.canvas.getContext('2d')?.putImageData(new ImageData(pixels, width, height), 0, 0);
    const exposure = outsideExposure(await beside.measureLight(), viewPoint, settings, size);
    // Smaller changes are not seen, and would each be a picture.
    if (Math.abs(exposure - this.exposure) > 0.1) this.exposure = exposure;
    this.canvas.toggleAttribute('data-drawn', true);
    return true;
  }

  private rendererBeside(of: InteractiveRenderer): RendererBeside | undefined {
    if (this.renderer?.of === of) return this.renderer.beside;
    this.scene = undefined;
    const requestDraw = () => {
      this.stale = true;
    };
    const beside = of.beside?.({
      shadowDetail: 'coarse',
      tessellationWorker,
      sampleWorker,
      onBetterTessellation: requestDraw,
      onSamples: requestDraw,
      onError: this.onError,
    });
    this.renderer = beside && { of, beside };
    return beside;
  }

  private release(): void {
    this.renderer?.beside.dispose();
    this.renderer = undefined;
  }
}
