import { exposedFrameGraph, renderSettings } from '../../nodes/pictures/renderSettings.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import type { InteractiveRenderer } from '../../pipelines/interactiveRenderer.ts';
import { interactivePipeline } from '../../pipelines/registry.ts';
import type { Backend, Sampling } from '../../render/settings.ts';
import { contentKey, type FrameGraph } from '../../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../../scene/types.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import type { ObserverController } from '../flight/observerController.ts';
import { sceneName } from '../loading/localFiles.ts';
import type { Editor, PictureSource } from '../state/editor.ts';
import { prefersReducedMotion } from '../state/preferences.ts';
import { computedUntil } from '../state/simulationRuns.ts';
import { updateTelemetry } from '../state/telemetry.ts';
import { AutoExposure } from './autoExposure.ts';
import { isSoftwareRenderer } from './chooseBackend.ts';
import { DynamicResolution } from './dynamicResolution.ts';
import { setLegendColors } from './legend/legendState.ts';
import { ValuePicker } from './legend/valuePicker.ts';

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
  /** Exposure for images without a tone curve [EV]. */
  readonly exposure: number;
  /** A frame graph with the exposure of this picture. */
  withExposure(plan: FrameGraph): FrameGraph;
}

/**
 * Renderer of one canvas, from creation to loss: draws a frame when something has changed, and accumulates samples at
 * rest.
 */
export class ViewportRenderer {
  private readonly studio: Editor;
  private readonly pilot: ObserverController;
  private readonly renderer: InteractiveRenderer;
  private readonly canvas: HTMLCanvasElement;
  private readonly observer: ResizeObserver;
  private readonly resolution = new DynamicResolution();
  private readonly eye = new AutoExposure(prefersReducedMotion());
  private readonly reader = new ValuePicker();
  /**
   * Samples per pixel side that still pictures accumulate; undefined on software renderers, which do not accumulate.
   */
  private readonly finest: number | undefined;
  private scale = 1;
  /** Scenes that are uploaded. */
  private scenes: readonly Scene[] = [];
  private uploading = false;
  /** Start of the current upload [ms], and whether it is the previous scene with a longer motion. */
  private began: number | undefined;
  private grew = false;
  /** Earliest time for the next upload of an interim scene [ms]. */
  private next = 0;
  /** The displayed frame; undefined while nothing of this scene is displayed. */
  private shown: DisplayedFrame | undefined;
  /** The requested view at the last tick. */
  private wanted: DisplayedView | undefined;
  /** Whether the same view must be drawn again. */
  private stale = false;
  private frame = 0;
  private before: number | undefined;
  /** Whether samples of this scene can no longer be read. */
  private lost = false;
  /** Whether shaders of the requested view are being compiled. */
  private prepares = false;

  static async start(
    canvas: HTMLCanvasElement,
    studio: Editor,
    pilot: ObserverController,
    backend: Backend | 'auto',
    onLost: (reason: string) => void,
  ): Promise<ViewportRenderer> {
    let stage: ViewportRenderer | undefined;
    const again = (): void => {
      if (stage) stage.again();
    };
    const software = isSoftwareRenderer();
    const renderer = await interactivePipeline().openInteractive({
      canvas,
      backend,
      onLost,
      shadowDetail: software ? 'coarse' : 'fine',
      tessellationWorker: () => new Worker(new URL('./tessellation.worker.ts', import.meta.url), { type: 'module' }),
      sampleWorker: () => new Worker(new URL('./samples.worker.ts', import.meta.url), { type: 'module' }),
      onBetterTessellation: again,
      onSamples: again,
      onError: (error) => {
        if (stage) stage.lose(error);
      },
    });
    stage = new ViewportRenderer(canvas, renderer, studio, pilot, software ? undefined : 8);
    return stage;
  }

  private constructor(
    canvas: HTMLCanvasElement,
    renderer: InteractiveRenderer,
    studio: Editor,
    pilot: ObserverController,
    finest: number | undefined,
  ) {
    this.finest = finest;
    this.studio = studio;
    this.pilot = pilot;
    this.renderer = renderer;
    this.canvas = canvas;
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(canvas);
    this.resize();
    studio.update({ graphics: renderer.info.backend });
    this.frame = requestAnimationFrame((now) => this.tick(now));
  }

  stop(): void {
    cancelAnimationFrame(this.frame);
    this.observer.disconnect();
    this.renderer.dispose();
  }

  /** The current picture at full resolution; undefined if there is none. */
  async capture(): Promise<CapturedPicture | undefined> {
    if (this.scale !== 1 || !this.shown) {
      this.scale = 1;
      this.resize();
    }
    if (!this.shown) return undefined;
    const shown = this.shown;
    const { width, height } = this.renderer;
    const pixels = new Uint8ClampedArray(await this.renderer.readPixels());
    return { ...shown, image: new ImageData(pixels, width, height) };
  }

  /** Undefined while nothing is displayed or an upload is running. */
  previewContext(): PreviewContext | undefined {
    const { picture } = this.pilot;
    if (!picture || !this.shown || this.uploading || this.prepares || this.waits) return undefined;
    const metered = this.eye.exposure(picture);
    return {
      renderer: this.renderer,
      picture,
      view: this.shown,
      isStill: this.resolution.isStill,
      software: this.finest === undefined,
      exposure: picture.exposure + metered,
      withExposure: (plan) => exposedFrameGraph(plan, metered, (kind) => this.eye.scale(kind)),
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
    const interval = now - (this.before ?? now);
    this.before = now;
    this.follow();
    const step = Math.min(MAX_FLIGHT_STEP, interval / 1000);
    if (!this.waits) this.pilot.advance(step);
    // If the device was lost, the next generation measures.
    this.eye.advance(step, now)?.catch(() => {});
    this.resolution.recordFrame(this.draw(false), now, interval);
    if (this.resolution.scale !== this.scale) {
      this.scale = this.resolution.scale;
      this.resize();
    } else if (this.resolution.isStill) this.refine();
    this.read(now);
    const drawn = { ...this.renderer.info, waiting: this.waits, preparing: this.prepares };
    updateTelemetry(this.pilot.observer, this.shown ? drawn : { ...drawn, triangles: 0 }, now);
  }

  /**
   * Accumulates a sample of a still view, unless other work is pending; an attribute of the canvas tells when it is
   * complete and exposure has settled.
   */
  private refine(): void {
    if (!this.shown || this.uploading || this.prepares || this.waits) return;
    const goesOn = this.finest !== undefined && this.renderer.accumulate?.(this.finest) === true;
    this.canvas.toggleAttribute('data-finest', !goesOn && this.eye.isSettled);
  }

  /** Picks the value for the legend. */
  private read(now: number): void {
    if (!this.shown || this.uploading) return;
    const { width, height } = this.renderer;
    const pick = async (x: number, y: number) => this.renderer.pick?.(x, y);
    this.reader.update({ ...this.shown, width, height, pick }, now)?.catch(() => {});
  }

  /** Takes over a new picture; another scene is uploaded first, and the last picture stays until then. */
  private follow(): void {
    const { picture, pictureSource, interim, results } = this.studio.store.getState();
    if (!picture || this.uploading) return;
    const until = interim === 'running' ? computedUntil(results) : undefined;
    if (sameScenes(picture.scenes, this.scenes)) {
      if (picture !== this.pilot.picture || until !== this.pilot.computedUntil)
        this.pilot.setPicture(picture, pictureSource, until);
      return;
    }
    const busy = this.began !== undefined || performance.now() < this.next;
    if (until === undefined || !this.pilot.isShowing(pictureSource) || !busy)
      void this.upload(picture, pictureSource, until);
  }

  private async upload(picture: PictureSpec, opened: PictureSource, until: number | undefined): Promise<void> {
    this.uploading = true;
    this.began = performance.now();
    this.scenes = picture.scenes;
    this.lost = false;
    try {
      await this.renderer.setScene(picture.scene, picture.scenes.slice(1));
      this.shown = undefined;
      this.wanted = undefined;
      this.grew = this.pilot.computedUntil !== undefined && this.pilot.isShowing(opened);
      if (!this.grew) this.eye.reset();
      this.pilot.setPicture(picture, opened, until);
    } catch (error) {
      this.began = undefined;
      const text = error instanceof Error ? error.message : String(error);
      this.studio.notify({ kind: 'error', text, place: sceneName(opened.source || opened.origin) });
    } finally {
      this.uploading = false;
    }
  }

  private isPrepared({ viewPoint, settings, sampling }: DisplayedFrame): boolean {
    const preparing = this.renderer.precompile?.(viewPoint, settings, sampling);
    this.prepares = preparing !== undefined;
    // If the device was lost, the next generation compiles.
    preparing?.catch(() => {});
    return !preparing;
  }

  /** Makes the next tick draw even if nothing has changed. */
  private again(): void {
    this.stale = true;
  }

  /** Whether samples are pending. */
  private get waits(): boolean {
    return this.renderer.info.waiting && !this.lost;
  }

  /** The last picture stays, and time goes on. */
  private lose(error: Error): void {
    this.lost = true;
    this.studio.notify({ kind: 'error', text: error.message });
  }

  /** Draws if the view changed; returns whether it did. */
  private draw(always: boolean): boolean {
    const viewPoint = this.pilot.viewPoint();
    const { picture } = this.pilot;
    if (!viewPoint || !picture || this.uploading || !sameScenes(picture.scenes, this.scenes)) return false;
    const { clientWidth, clientHeight } = this.canvas;
    const wanted = renderSettings(picture, this.eye.exposure(picture), (kind) => this.eye.scale(kind));
    const before = this.wanted;
    this.wanted = { viewPoint, settings: wanted };
    const changes = before !== undefined && !sameView(before, this.wanted);
    const moves = changes && !sameView({ ...before, settings: wanted }, this.wanted);
    const drawing = this.affordable(viewPoint, wanted, moves);
    if (!drawing) return false;
    if (!always && !this.stale && this.shown && sameView(this.shown, drawing)) return false;
    this.shown = drawing;
    this.stale = false;
    this.canvas.removeAttribute('data-finest');
    const { settings, sampling } = drawing;
    this.renderer.render(viewPoint, settings, sampling);
    if (this.renderer.info.waiting) return false;
    if (this.began !== undefined) {
      const now = performance.now();
      // The first upload takes longest and does not predict the next.
      this.next = this.grew ? now + INTERIM_PAUSE_FACTOR * (now - this.began) : now;
      this.began = undefined;
    }
    setLegendColors(settings.falseColors);
    const aspect = clientWidth / Math.max(1, clientHeight);
    this.eye.observe({ picture, viewPoint, settings, aspect, measureLight: () => this.renderer.measureLight() });
    return changes;
  }

  /** Settings for the available time; until these can be drawn at once, those displayed before. */
  private affordable(viewPoint: ViewPoint, wanted: RenderSettings, moves: boolean): DisplayedFrame | undefined {
    const { fullQuality } = this.resolution;
    const settings = fullQuality ? wanted : { ...wanted, occlusionRadius: 0 };
    const plain: DisplayedFrame = { viewPoint, settings, sampling: 1 };
    const best: DisplayedFrame = moves && fullQuality ? { ...plain, sampling: 'temporal' } : plain;
    return [best, plain].find((drawing) => this.isPrepared(drawing)) ?? (this.shown && { ...this.shown, viewPoint });
  }
}

const sameScenes = (a: readonly Scene[], b: readonly Scene[]): boolean =>
  a.length === b.length && a.every((scene, i) => scene === b[i]);

/** Whether two views are equal. They are plain data, compared as JSON. */
const sameView = (a: DisplayedView, b: DisplayedView): boolean =>
  contentKey([a.viewPoint, a.settings]) === contentKey([b.viewPoint, b.settings]);
