import { messageOf } from '../../messages/messageError.ts';
import { exposedFrameGraph, renderSettings } from '../../nodes/pictures/renderSettings.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import type { InteractiveRenderer } from '../../pipelines/interactiveRenderer.ts';
import { interactivePipeline } from '../../pipelines/registry.ts';
import type { Backend, Sampling, ShadingChoice } from '../../render/settings.ts';
import { filmedDome } from '../../scene/film/seenFilm.ts';
import { contentKey, type FrameGraph } from '../../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../../scene/types.ts';
import type { MeteredQuantities } from '../../scene/view/metering.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import type { ViewportFilms } from '../films/viewportFilms.ts';
import type { ObserverController } from '../flight/observerController.ts';
import { sceneName } from '../loading/localFiles.ts';
import type { Editor, PictureSource } from '../state/editor.ts';
import { prefersReducedMotion } from '../state/preferences.ts';
import { computedUntil } from '../state/simulationRuns.ts';
import { updateTelemetry } from '../state/telemetry.ts';
import { AutoExposure } from './autoExposure.ts';
import { isSoftwareRenderer } from './chooseBackend.ts';
import { DynamicResolution } from './dynamicResolution.ts';
import { FrameCap } from './frameCap.ts';
import { setLegendColors } from './legend/legendState.ts';
import type { ValuePicker } from './legend/valuePicker.ts';
import { sampleWorker, tessellationWorker } from './rendererWorkers.ts';

/** Maximum flight step of a frame [s], so that the observer does not jump after the page was suspended. */
const MAX_FLIGHT_STEP = 0.25;
const MAX_PIXEL_RATIO = 2;
/** Pause between uploads of interim scenes, as a multiple of the previous upload's duration. */
const INTERIM_PAUSE_FACTOR = 3;

interface DisplayedView {
  readonly viewPoint: ViewPoint;
  readonly settings: RenderSettings;
}

/** A view with its resolution and quality. */
interface DisplayedFrame extends DisplayedView {
  readonly sampling: Sampling;
  readonly shading: ShadingChoice;
}

/** A captured picture: its pixels as displayed, with its view. */
export interface CapturedPicture extends DisplayedView {
  readonly image: ImageData;
}

/** What node pictures need from the viewport (graph/pictures/useNodePictures.ts). */
export interface PreviewContext {
  readonly renderer: InteractiveRenderer;
  readonly picture: PictureSpec;
  /** Identity changes with every drawn picture. */
  readonly view: DisplayedView;
  /** Whether the picture is still. */
  readonly isStill: boolean;
  /** Whether rendering runs on the CPU, which then has little time for anything else. */
  readonly software: boolean;
  /** Shows what the viewport shows of films in a renderer beside. */
  showFilms(renderer: Pick<InteractiveRenderer, 'showDome'>): void;
  /** Exposure for images without a tone curve [EV]. */
  readonly exposure: number;
  /** A frame graph with the exposure of this picture. */
  withExposure(frameGraph: FrameGraph): FrameGraph;
}

/**
 * Renderer of one canvas, from creation to loss: draws a frame when something has changed, and accumulates samples at
 * rest.
 */
export class ViewportRenderer {
  private readonly editor: Editor;
  private readonly observerController: ObserverController;
  private readonly renderer: InteractiveRenderer;
  private readonly canvas: HTMLCanvasElement;
  private readonly observer: ResizeObserver;
  private readonly resolution = new DynamicResolution();
  private readonly autoExposure = new AutoExposure(prefersReducedMotion());
  /** Loaded with the first false colours. */
  private valuePicker: ValuePicker | undefined;
  /** Loaded with the first film. */
  private films: ViewportFilms | undefined;
  private loadingPicker: Promise<void> | undefined;
  /**
   * Samples per pixel side that still pictures accumulate; undefined on software renderers, which do not accumulate.
   */
  private readonly maxSamplesPerSide: number | undefined;
  private scale = 1;
  /** Scenes that are uploaded. */
  private scenes: readonly Scene[] = [];
  private uploading = false;
  /** Start of the current upload [ms], and whether it is the previous scene with a longer motion. */
  private uploadStart: number | undefined;
  private isGrowing = false;
  /** Earliest time for the next upload of an interim scene [ms]. */
  private nextUpload = 0;
  /** The displayed frame; undefined while nothing of this scene is displayed. */
  private displayed: DisplayedFrame | undefined;
  /** Whether that has all that was asked for. */
  private isWhole = false;
  private isOver = false;
  /** The requested view at the last tick. */
  private requestedView: DisplayedView | undefined;
  /** Whether the same view must be drawn again. */
  private stale = false;
  private frame = 0;
  private lastTick: number | undefined;
  private readonly frameCap = new FrameCap();
  /** From the last tick to the next frame of the screen [ms]; undefined until that comes. */
  private frameTime: number | undefined;
  /** Whether samples of this scene can no longer be read. */
  private samplesLost = false;
  /** Whether shaders of the requested view are being compiled. */
  private compiling = false;

  static async start(
    canvas: HTMLCanvasElement,
    editor: Editor,
    observerController: ObserverController,
    backend: Backend | 'auto',
    onLost: (reason: string) => void,
  ): Promise<ViewportRenderer> {
    let viewportRenderer: ViewportRenderer | undefined;
    const requestDraw = (): void => {
      if (viewportRenderer) viewportRenderer.requestDraw();
    };
    const software = isSoftwareRenderer();
    const renderer = await interactivePipeline().openInteractive({
      canvas,
      backend,
      onLost,
      shadowDetail: software ? 'coarse' : 'fine',
      tessellationWorker,
      sampleWorker,
      onBetterTessellation: requestDraw,
      onSamples: requestDraw,
      onError: (error) => {
        if (viewportRenderer) viewportRenderer.handleSampleError(error);
      },
    });
    viewportRenderer = new ViewportRenderer(canvas, renderer, editor, observerController, software ? undefined : 8);
    return viewportRenderer;
  }

  private constructor(
    canvas: HTMLCanvasElement,
    renderer: InteractiveRenderer,
    editor: Editor,
    observerController: ObserverController,
    maxSamplesPerSide: number | undefined,
  ) {
    this.maxSamplesPerSide = maxSamplesPerSide;
    this.editor = editor;
    this.observerController = observerController;
    this.renderer = renderer;
    this.canvas = canvas;
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(canvas);
    this.resize();
    editor.update({ graphics: renderer.info.backend });
    this.frame = requestAnimationFrame((now) => this.tick(now));
  }

  stop(): void {
    this.isOver = true;
    cancelAnimationFrame(this.frame);
    this.observer.disconnect();
    this.films?.close();
    this.renderer.dispose();
  }

  /** The current picture at full resolution; undefined if there is none. */
  async capture(): Promise<CapturedPicture | undefined> {
    // The first picture has less.
    while (this.displayed && !this.isWhole && this.resolution.isStill && !this.isOver)
      await new Promise((frame) => requestAnimationFrame(frame));
    if (this.scale !== 1 || !this.displayed) {
      this.scale = 1;
      this.resize();
    }
    if (!this.displayed) return undefined;
    const shown = this.displayed;
    const { width, height } = this.renderer;
    const pixels = new Uint8ClampedArray(await this.renderer.readPixels());
    return { ...shown, image: new ImageData(pixels, width, height) };
  }

  /** Undefined while nothing is displayed or an upload is running. */
  previewContext(): PreviewContext | undefined {
    const { picture } = this.observerController;
    if (!picture || !this.displayed || this.uploading || this.compiling || this.isWaiting) return undefined;
    const metered = this.autoExposure.exposure(picture);
    return {
      renderer: this.renderer,
      picture,
      view: this.displayed,
      isStill: this.resolution.isStill,
      software: this.maxSamplesPerSide === undefined,
      showFilms: (renderer) => this.films?.showIn(renderer),
      exposure: picture.exposure + metered,
      withExposure: (frameGraph) => exposedFrameGraph(frameGraph, metered, (kind) => this.autoExposure.scale(kind)),
    };
  }

  private resize(): void {
    const ratio = Math.min(devicePixelRatio, MAX_PIXEL_RATIO) * this.scale;
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(Math.round(clientWidth * ratio), Math.round(clientHeight * ratio));
    // Draw before the next paint, or the browser stretches the old picture.
    this.draw(true);
  }

  private tick(now: number): void {
    this.frame = requestAnimationFrame((next) => this.tick(next));
    const { frameRate } = this.editor.store.getState();
    // How long the last frame took does not depend on how many are left out.
    this.frameTime ??= now - (this.lastTick ?? now);
    if (this.isMetering || (frameRate && !this.frameCap.passes(now, frameRate))) return;
    const interval = now - (this.lastTick ?? now);
    this.lastTick = now;
    this.followPicture();
    const step = Math.min(MAX_FLIGHT_STEP, interval / 1000);
    if (!this.isWaiting) this.observerController.advance(step);
    // If the device was lost, the next generation measures.
    this.autoExposure.advance(step, now)?.catch(() => {});
    if (this.isMetering) return;
    this.resolution.recordFrame(this.draw(false), now, this.frameTime);
    this.frameTime = undefined;
    if (this.resolution.scale !== this.scale) {
      this.scale = this.resolution.scale;
      this.resize();
    } else if (this.resolution.isStill) this.accumulate();
    this.pickValue(now);
    const { isOutside: outside } = this.observerController;
    const drawn = this.displayed !== undefined && !this.isWaiting;
    const { triangles, tolerance, shading } = this.renderer.info;
    const picture = { triangles: this.displayed ? triangles : 0, tolerance, drawn, shading };
    const waits = { waiting: this.isWaiting, preparing: this.compiling, outside };
    updateTelemetry(this.observerController.observer, { ...picture, ...waits }, now);
  }

  /**
   * Whether light is being read where pictures take long. The next one waits: what is read would be blocked by it, and
   * the page too.
   */
  private get isMetering(): boolean {
    return this.autoExposure.isMeasuring && !this.resolution.fullQuality;
  }

  /**
   * Accumulates a sample of a still view, unless other work is pending; an attribute of the canvas tells when it is
   * complete and exposure has settled.
   */
  private accumulate(): void {
    if (!this.displayed || !this.isWhole || this.uploading || this.compiling || this.isWaiting) return;
    const goesOn = this.maxSamplesPerSide !== undefined && this.renderer.accumulate?.(this.maxSamplesPerSide) === true;
    const isSettled = this.autoExposure.isSettled && (this.films?.isSettled ?? true);
    this.canvas.toggleAttribute('data-finest', !goesOn && isSettled);
  }

  /** Picks the value for the legend. */
  private pickValue(now: number): void {
    if (!this.displayed || this.uploading) return;
    const { valuePicker } = this;
    if (!valuePicker) {
      if (this.displayed.settings.falseColors) this.loadingPicker ??= this.loadPicker();
      return;
    }
    const { width, height } = this.renderer;
    const pick = async (x: number, y: number) => this.renderer.pick?.(x, y);
    valuePicker.update({ ...this.displayed, width, height, pick }, now)?.catch(() => {});
  }

  private async loadPicker(): Promise<void> {
    this.valuePicker = new (await import('./legend/valuePicker.ts')).ValuePicker();
  }

  /** Takes over a new picture; another scene is uploaded first, and the last picture stays until then. */
  private followPicture(): void {
    const { picture, pictureSource, interim, results } = this.editor.store.getState();
    if (!picture || this.uploading) return;
    const until = interim === 'running' ? computedUntil(results) : undefined;
    if (sameScenes(picture.scenes, this.scenes)) {
      if (picture !== this.observerController.picture || until !== this.observerController.computedUntil)
        this.observerController.setPicture(picture, pictureSource, until);
      return;
    }
    const busy = this.uploadStart !== undefined || performance.now() < this.nextUpload;
    if (until === undefined || !this.observerController.isShowing(pictureSource) || !busy)
      void this.upload(picture, pictureSource, until);
  }

  private async upload(picture: PictureSpec, opened: PictureSource, until: number | undefined): Promise<void> {
    this.uploading = true;
    this.uploadStart = performance.now();
    this.scenes = picture.scenes;
    this.samplesLost = false;
    try {
      await this.renderer.setScene(picture.scene, picture.scenes.slice(1));
      await this.openFilms(picture.scenes);
      this.displayed = undefined;
      this.requestedView = undefined;
      this.isGrowing = this.observerController.computedUntil !== undefined && this.observerController.isShowing(opened);
      if (!this.isGrowing) this.autoExposure.reset();
      this.observerController.setPicture(picture, opened, until);
    } catch (error) {
      this.uploadStart = undefined;
      this.editor.notify({ kind: 'error', text: messageOf(error), place: sceneName(opened.source || opened.origin) });
    } finally {
      this.uploading = false;
    }
  }

  private async openFilms(scenes: readonly Scene[]): Promise<void> {
    if (!this.films && !scenes.some(filmedDome)) return;
    this.films ??= new (await import('../films/viewportFilms.ts')).ViewportFilms(this.renderer, {
      onPicture: () => this.requestDraw(),
      onError: (error) => this.editor.notify({ kind: 'error', text: messageOf(error) }),
    });
    this.films.setScenes(scenes);
  }

  private isPrepared({ viewPoint, settings, sampling, shading }: DisplayedFrame): boolean {
    this.renderer.shading = shading;
    const preparing = this.renderer.precompile?.([viewPoint], settings, sampling);
    this.compiling = preparing !== undefined;
    // If the device was lost, the next generation compiles.
    preparing?.catch(() => {});
    return !preparing;
  }

  /** Makes the next tick draw even if nothing has changed. */
  private requestDraw(): void {
    this.stale = true;
  }

  /** Whether samples are pending. */
  private get isWaiting(): boolean {
    return this.renderer.info.waiting && !this.samplesLost;
  }

  /** The last picture stays, and time goes on. */
  private handleSampleError(error: Error): void {
    this.samplesLost = true;
    this.editor.notify({ kind: 'error', text: messageOf(error) });
  }

  /** Draws if the view changed; returns whether it did. */
  private draw(always: boolean): boolean {
    const viewPoint = this.observerController.viewPoint();
    const { picture } = this.observerController;
    if (!viewPoint || !picture || this.uploading || !sameScenes(picture.scenes, this.scenes)) return false;
    const { clientWidth, clientHeight } = this.canvas;
    const wanted = renderSettings(picture, this.autoExposure.exposure(picture), (kind) =>
      this.autoExposure.scale(kind),
    );
    this.films?.follow(viewPoint, wanted);
    const before = this.requestedView;
    // Metering follows the picture: that it adapts is no change of what is asked for.
    const asked = { viewPoint, settings: renderSettings(picture, 0) };
    this.requestedView = asked;
    const changes = before !== undefined && !sameView(before, asked);
    const moves = changes && !sameView({ ...before, settings: asked.settings }, asked);
    const drawing = this.preparedFrame(viewPoint, wanted, moves);
    if (!drawing) return false;
    if (!always && !this.stale && this.displayed && sameFrame(this.displayed, drawing)) return false;
    const isBetter = this.stale;
    this.displayed = drawing;
    this.stale = false;
    this.canvas.removeAttribute('data-finest');
    const { settings, sampling, shading } = drawing;
    this.isWhole = settings.occlusionRadius === wanted.occlusionRadius;
    this.renderer.shading = shading;
    this.renderer.render([viewPoint], settings, sampling);
    if (this.renderer.info.waiting) return false;
    markFirstPicture();
    if (this.uploadStart !== undefined) {
      const now = performance.now();
      // The first upload takes longest and does not predict the next.
      this.nextUpload = this.isGrowing ? now + INTERIM_PAUSE_FACTOR * (now - this.uploadStart) : now;
      this.uploadStart = undefined;
    }
    setLegendColors(settings.falseColors);
    const { width, height } = this.renderer;
    const metered = {
      picture,
      views: [viewPoint],
      settings,
      wanted,
      detail: width * height + (this.isWhole ? 0.5 : 0),
      size: { width: clientWidth, height: Math.max(1, clientHeight) },
      measureLight: (quantities: MeteredQuantities) => this.renderer.measureLight(quantities),
    } as const;
    this.autoExposure.observe(metered, isBetter);
    return changes;
  }

  /** Settings for the available time; until these can be drawn at once, those displayed before. */
  private preparedFrame(viewPoint: ViewPoint, wanted: RenderSettings, moves: boolean): DisplayedFrame | undefined {
    const { fullQuality } = this.resolution;
    const settings = fullQuality ? wanted : { ...wanted, occlusionRadius: 0 };
    const shading = fullQuality ? 'deferred' : this.editor.store.getState().shading;
    const plain: DisplayedFrame = { viewPoint, settings, sampling: 1, shading };
    const best: DisplayedFrame = moves && fullQuality ? { ...plain, sampling: 'temporal' } : plain;
    // Without occlusion fewer shaders are compiled before the first picture.
    const first: DisplayedFrame = { ...plain, settings: { ...wanted, occlusionRadius: 0 } };
    return (
      (this.displayed ? [best, plain] : [first]).find((drawing) => this.isPrepared(drawing)) ??
      (this.displayed && { ...this.displayed, viewPoint })
    );
  }
}

/** For whoever measures the page: `performance.getEntriesByName('first-picture')`. */
function markFirstPicture(): void {
  if (performance.getEntriesByName(FIRST_PICTURE).length === 0) performance.mark(FIRST_PICTURE);
}
const FIRST_PICTURE = 'first-picture';

const sameScenes = (a: readonly Scene[], b: readonly Scene[]): boolean =>
  a.length === b.length && a.every((scene, i) => scene === b[i]);

const sameFrame = (a: DisplayedFrame, b: DisplayedFrame): boolean => a.shading === b.shading && sameView(a, b);

/** Whether two views are equal. They are plain data, compared as JSON. */
const sameView = (a: DisplayedView, b: DisplayedView): boolean =>
  contentKey([a.viewPoint, a.settings]) === contentKey([b.viewPoint, b.settings]);
