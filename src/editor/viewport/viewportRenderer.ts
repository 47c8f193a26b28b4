import type { PictureSpec } from '../../nodes/defineNode.ts';
import { exposedFrameGraph, renderSettings } from '../../nodes/pictures/renderSettings.ts';
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

/** Longest step of flight in one frame [s]: after a pause of the page the observer does not leap. */
const MAX_FLIGHT_STEP = 0.25;
const MAX_PIXEL_RATIO = 2;
/** Of work under way the next scene is taken up after so many times as long as the one before took. */
const INTERIM_PAUSE_FACTOR = 3;

interface DisplayedView {
  readonly viewPoint: ViewPoint;
  readonly settings: RenderSettings;
}

/** What a picture is to be, and how it is to be drawn. */
interface DisplayedFrame extends DisplayedView {
  readonly sampling: Sampling;
}

/** A picture to be kept: its pixels as it was shown, and of what. */
export interface CapturedPicture extends DisplayedView {
  readonly image: ImageData;
}

/** What there is to make pictures of nodes with, beside that which is shown (graph/useNodePictures.ts). */
export interface PreviewContext {
  readonly renderer: InteractiveRenderer;
  readonly picture: PictureSpec;
  /** Another object for every picture that was drawn. */
  readonly view: DisplayedView;
  /** It stays as it is for now. */
  readonly isStill: boolean;
  /** The processor draws, which then cannot do much else. */
  readonly software: boolean;
  /** Of light that has no tone curve yet [EV]. */
  readonly exposure: number;
  /** A plan as this picture's is exposed. */
  withExposure(plan: FrameGraph): FrameGraph;
}

/** One canvas with its renderer, from start to loss: draws a frame wherever something has changed, and refines what rests. */
export class ViewportRenderer {
  private readonly studio: Editor;
  private readonly pilot: ObserverController;
  private readonly renderer: InteractiveRenderer;
  private readonly canvas: HTMLCanvasElement;
  private readonly observer: ResizeObserver;
  private readonly resolution = new DynamicResolution();
  private readonly eye = new AutoExposure(prefersReducedMotion());
  private readonly reader = new ValuePicker();
  /** Samples along each side of a pixel that resting pictures come to; undefined: where the processor draws they stay as they are. */
  private readonly finest: number | undefined;
  private scale = 1;
  /** In the renderer now. */
  private scenes: readonly Scene[] = [];
  private uploading = false;
  /** When the scene was taken up that is not on the canvas yet [ms], and whether it is the one before with a motion that has grown. */
  private began: number | undefined;
  private grew = false;
  /** When the next is taken up of work that is under way [ms]. */
  private next = 0;
  /** On the canvas; undefined while there is nothing of this scene. */
  private shown: DisplayedFrame | undefined;
  /** What was to be seen at the last tick. */
  private wanted: DisplayedView | undefined;
  /** The same would not look the same any more. */
  private stale = false;
  private frame = 0;
  private before: number | undefined;
  /** Samples of this scene cannot be read any more. */
  private lost = false;
  /** Shaders of the picture that is wanted are being compiled. */
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

  /** The picture as it is now, with all its pixels; undefined where there is none. */
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

  /** Undefined while nothing is shown, or something else is on its way. */
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
    // Without a picture before the next paint the old one would be stretched.
    this.draw(true);
  }

  private tick(now: number): void {
    this.frame = requestAnimationFrame((next) => this.tick(next));
    const interval = now - (this.before ?? now);
    this.before = now;
    this.follow();
    const step = Math.min(MAX_FLIGHT_STEP, interval / 1000);
    if (!this.waits) this.pilot.advance(step);
    // What a lost device cannot measure is measured in the next life.
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

  /** A sample more of what rests, unless something else is on its way; the canvas tells when it has them all, in their own light. */
  private refine(): void {
    if (!this.shown || this.uploading || this.prepares || this.waits) return;
    const goesOn = this.finest !== undefined && this.renderer.accumulate?.(this.finest) === true;
    this.canvas.toggleAttribute('data-finest', !goesOn && this.eye.isSettled);
  }

  /** For the legend, what is pointed at. */
  private read(now: number): void {
    if (!this.shown || this.uploading) return;
    const { width, height } = this.renderer;
    const pick = async (x: number, y: number) => this.renderer.pick?.(x, y);
    this.reader.update({ ...this.shown, width, height, pick }, now)?.catch(() => {});
  }

  /** Takes up a new picture; where its scene is another one, after the upload: until then the last one stays. */
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
    // What a lost device cannot compile the next life does.
    preparing?.catch(() => {});
    return !preparing;
  }

  /** The next tick draws, also where nothing has changed. */
  private again(): void {
    this.stale = true;
  }

  /** For samples that are to come. */
  private get waits(): boolean {
    return this.renderer.info.waiting && !this.lost;
  }

  /** The last picture stays, and time goes on. */
  private lose(error: Error): void {
    this.lost = true;
    this.studio.notify({ kind: 'error', text: error.message });
  }

  /** Whether what is to be seen has changed, and was drawn. */
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
      // The first takes longest, and tells nothing about those that follow.
      this.next = this.grew ? now + INTERIM_PAUSE_FACTOR * (now - this.began) : now;
      this.began = undefined;
    }
    setLegendColors(settings.falseColors);
    const aspect = clientWidth / Math.max(1, clientHeight);
    this.eye.observe({ picture, viewPoint, settings, aspect, measureLight: () => this.renderer.measureLight() });
    return changes;
  }

  /** How what is wanted is drawn where time is short; until that can be drawn at once, as what was shown before. */
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

/** Whether the same is to be seen. Plain data of numbers and short arrays: compared by its text. */
const sameView = (a: DisplayedView, b: DisplayedView): boolean =>
  contentKey([a.viewPoint, a.settings]) === contentKey([b.viewPoint, b.settings]);
