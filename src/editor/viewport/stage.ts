import type { Picture } from '../../nodes/define.ts';
import { exposedPlan, renderSettings } from '../../nodes/picture.ts';
import { SceneRenderer } from '../../render/renderer.ts';
import type { Backend, Sampling } from '../../render/settings.ts';
import { type Plan, textOf } from '../../scene/plan.ts';
import type { Scene } from '../../scene/types.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view.ts';
import { sceneName } from '../loading/localFiles.ts';
import { showColors } from '../state/legend.ts';
import { prefersReducedMotion } from '../state/preferences.ts';
import { computedUntil } from '../state/runs.ts';
import type { Opened, Studio } from '../state/studio.ts';
import { report } from '../state/telemetry.ts';
import { Eye } from './eye.ts';
import { drawsInSoftware } from './graphics.ts';
import type { Pilot } from './pilot.ts';
import { Reader } from './reader.ts';
import { Resolution } from './resolution.ts';

/** Longest step of flight in one frame [s]: after a pause of the page the observer does not leap. */
const LONGEST_STEP = 0.25;
const MOST_PIXELS_PER_POINT = 2;
/** Of work under way the next scene is taken up after so many times as long as the one before took. */
const PAUSE = 3;

interface Shown {
  readonly viewPoint: ViewPoint;
  readonly settings: RenderSettings;
}

/** What a picture is to be, and how it is to be drawn. */
interface Drawing extends Shown {
  readonly sampling: Sampling;
}

/** A picture to be kept: its pixels as it was shown, and of what. */
export interface Captured extends Shown {
  readonly image: ImageData;
}

/** What there is to make pictures of nodes with, beside that which is shown (graph/useNodePictures.ts). */
export interface Besides {
  readonly renderer: SceneRenderer;
  readonly picture: Picture;
  /** Another object for every picture that was drawn. */
  readonly shown: Shown;
  /** It stays as it is for now. */
  readonly rests: boolean;
  /** The processor draws, which then cannot do much else. */
  readonly software: boolean;
  /** Of light that has no tone curve yet [EV]. */
  readonly exposure: number;
  /** A plan as this picture's is exposed. */
  exposed(plan: Plan): Plan;
}

/** One canvas with its renderer, from start to loss: draws a frame wherever something has changed, and refines what rests. */
export class Stage {
  readonly #studio: Studio;
  readonly #pilot: Pilot;
  readonly #renderer: SceneRenderer;
  readonly #canvas: HTMLCanvasElement;
  readonly #observer: ResizeObserver;
  readonly #resolution = new Resolution();
  readonly #eye = new Eye(prefersReducedMotion());
  readonly #reader = new Reader();
  /** Samples along each side of a pixel that resting pictures come to; undefined: where the processor draws they stay as they are. */
  readonly #finest: number | undefined;
  #scale = 1;
  /** In the renderer now. */
  #scenes: readonly Scene[] = [];
  #uploading = false;
  /** When the scene was taken up that is not on the canvas yet [ms], and whether it is the one before with a motion that has grown. */
  #began: number | undefined;
  #grew = false;
  /** When the next is taken up of work that is under way [ms]. */
  #next = 0;
  /** On the canvas; undefined while there is nothing of this scene. */
  #shown: Drawing | undefined;
  /** What was to be seen at the last tick. */
  #wanted: Shown | undefined;
  /** The same would not look the same any more. */
  #stale = false;
  #frame = 0;
  #before: number | undefined;
  /** Samples of this scene cannot be read any more. */
  #lost = false;
  /** Shaders of the picture that is wanted are being compiled. */
  #prepares = false;

  static async start(
    canvas: HTMLCanvasElement,
    studio: Studio,
    pilot: Pilot,
    backend: Backend | 'auto',
    onLost: (reason: string) => void,
  ): Promise<Stage> {
    let stage: Stage | undefined;
    const again = (): void => {
      if (stage) stage.#again();
    };
    const software = drawsInSoftware();
    const renderer = await SceneRenderer.create({
      canvas,
      backend,
      onLost,
      shadowDetail: software ? 'coarse' : 'fine',
      planWorker: () => new Worker(new URL('./plan.worker.ts', import.meta.url), { type: 'module' }),
      sampleWorker: () => new Worker(new URL('./samples.worker.ts', import.meta.url), { type: 'module' }),
      onBetterPlan: again,
      onSamples: again,
      onProblem: (error) => {
        if (stage) stage.#lose(error);
      },
    });
    stage = new Stage(canvas, renderer, studio, pilot, software ? undefined : 8);
    return stage;
  }

  private constructor(
    canvas: HTMLCanvasElement,
    renderer: SceneRenderer,
    studio: Studio,
    pilot: Pilot,
    finest: number | undefined,
  ) {
    this.#finest = finest;
    this.#studio = studio;
    this.#pilot = pilot;
    this.#renderer = renderer;
    this.#canvas = canvas;
    this.#observer = new ResizeObserver(() => this.#resize());
    this.#observer.observe(canvas);
    this.#resize();
    studio.change({ graphics: renderer.info.backend });
    this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  stop(): void {
    cancelAnimationFrame(this.#frame);
    this.#observer.disconnect();
    this.#renderer.dispose();
  }

  /** The picture as it is now, with all its pixels; undefined where there is none. */
  async capture(): Promise<Captured | undefined> {
    if (this.#scale !== 1 || !this.#shown) {
      this.#scale = 1;
      this.#resize();
    }
    if (!this.#shown) return undefined;
    const shown = this.#shown;
    const { width, height } = this.#renderer;
    const pixels = new Uint8ClampedArray(await this.#renderer.readPixels());
    return { ...shown, image: new ImageData(pixels, width, height) };
  }

  /** Undefined while nothing is shown, or something else is on its way. */
  besides(): Besides | undefined {
    const { picture } = this.#pilot;
    if (!picture || !this.#shown || this.#uploading || this.#prepares || this.#waits) return undefined;
    const metered = this.#eye.exposure(picture);
    return {
      renderer: this.#renderer,
      picture,
      shown: this.#shown,
      rests: this.#resolution.resting,
      software: this.#finest === undefined,
      exposure: picture.exposure + metered,
      exposed: (plan) => exposedPlan(plan, metered, (kind) => this.#eye.scale(kind)),
    };
  }

  #resize(): void {
    const ratio = Math.min(devicePixelRatio, MOST_PIXELS_PER_POINT) * this.#scale;
    const { clientWidth, clientHeight } = this.#canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.#renderer.setSize(Math.round(clientWidth * ratio), Math.round(clientHeight * ratio));
    // Without a picture before the next paint the old one would be stretched.
    this.#draw(true);
  }

  #tick(now: number): void {
    this.#frame = requestAnimationFrame((next) => this.#tick(next));
    const interval = now - (this.#before ?? now);
    this.#before = now;
    this.#follow();
    const step = Math.min(LONGEST_STEP, interval / 1000);
    if (!this.#waits) this.#pilot.advance(step);
    // What a lost device cannot measure is measured in the next life.
    this.#eye.advance(step, now)?.catch(() => {});
    this.#resolution.note(this.#draw(false), now, interval);
    if (this.#resolution.scale !== this.#scale) {
      this.#scale = this.#resolution.scale;
      this.#resize();
    } else if (this.#resolution.resting) this.#refine();
    this.#read(now);
    const drawn = { ...this.#renderer.info, waiting: this.#waits, preparing: this.#prepares };
    report(this.#pilot.observer, this.#shown ? drawn : { ...drawn, triangles: 0 }, now);
  }

  /** A sample more of what rests, unless something else is on its way; the canvas tells when it has them all, in their own light. */
  #refine(): void {
    if (!this.#shown || this.#uploading || this.#prepares || this.#waits) return;
    const goesOn = this.#finest !== undefined && this.#renderer.refine(this.#finest);
    this.#canvas.toggleAttribute('data-finest', !goesOn && this.#eye.rests);
  }

  /** For the legend, what is pointed at. */
  #read(now: number): void {
    if (!this.#shown || this.#uploading) return;
    const { width, height } = this.#renderer;
    const pick = (x: number, y: number) => this.#renderer.pick(x, y);
    this.#reader.follow({ ...this.#shown, width, height, pick }, now)?.catch(() => {});
  }

  /** Takes up a new picture; where its scene is another one, after the upload: until then the last one stays. */
  #follow(): void {
    const { picture, opened, interim, results } = this.#studio.store.getState();
    if (!picture || this.#uploading) return;
    const until = interim === 'running' ? computedUntil(results) : undefined;
    if (isSame(picture.scenes, this.#scenes)) {
      if (picture !== this.#pilot.picture || until !== this.#pilot.until) this.#pilot.show(picture, opened, until);
      return;
    }
    const busy = this.#began !== undefined || performance.now() < this.#next;
    if (until === undefined || !this.#pilot.isOf(opened) || !busy) void this.#upload(picture, opened, until);
  }

  async #upload(picture: Picture, opened: Opened, until: number | undefined): Promise<void> {
    this.#uploading = true;
    this.#began = performance.now();
    this.#scenes = picture.scenes;
    this.#lost = false;
    try {
      await this.#renderer.setScene(picture.scene, picture.scenes.slice(1));
      this.#shown = undefined;
      this.#wanted = undefined;
      this.#grew = this.#pilot.until !== undefined && this.#pilot.isOf(opened);
      if (!this.#grew) this.#eye.blink();
      this.#pilot.show(picture, opened, until);
    } catch (error) {
      this.#began = undefined;
      const text = error instanceof Error ? error.message : String(error);
      this.#studio.notify({ kind: 'error', text, place: sceneName(opened.source || opened.origin) });
    } finally {
      this.#uploading = false;
    }
  }

  #isPrepared({ viewPoint, settings, sampling }: Drawing): boolean {
    const preparing = this.#renderer.prepare(viewPoint, settings, sampling);
    this.#prepares = preparing !== undefined;
    // What a lost device cannot compile the next life does.
    preparing?.catch(() => {});
    return !preparing;
  }

  /** The next tick draws, also where nothing has changed. */
  #again(): void {
    this.#stale = true;
  }

  /** For samples that are to come. */
  get #waits(): boolean {
    return this.#renderer.info.waiting && !this.#lost;
  }

  /** The last picture stays, and time goes on. */
  #lose(error: Error): void {
    this.#lost = true;
    this.#studio.notify({ kind: 'error', text: error.message });
  }

  /** Whether what is to be seen has changed, and was drawn. */
  #draw(always: boolean): boolean {
    const viewPoint = this.#pilot.viewPoint();
    const { picture } = this.#pilot;
    if (!viewPoint || !picture || this.#uploading || !isSame(picture.scenes, this.#scenes)) return false;
    const { clientWidth, clientHeight } = this.#canvas;
    const wanted = renderSettings(picture, this.#eye.exposure(picture), (kind) => this.#eye.scale(kind));
    const before = this.#wanted;
    this.#wanted = { viewPoint, settings: wanted };
    const changes = before !== undefined && !same(before, this.#wanted);
    const moves = changes && !same({ ...before, settings: wanted }, this.#wanted);
    const drawing = this.#affordable(viewPoint, wanted, moves);
    if (!drawing) return false;
    if (!always && !this.#stale && this.#shown && same(this.#shown, drawing)) return false;
    this.#shown = drawing;
    this.#stale = false;
    this.#canvas.removeAttribute('data-finest');
    const { settings, sampling } = drawing;
    this.#renderer.render(viewPoint, settings, sampling);
    if (this.#renderer.info.waiting) return false;
    if (this.#began !== undefined) {
      const now = performance.now();
      // The first takes longest, and tells nothing about those that follow.
      this.#next = this.#grew ? now + PAUSE * (now - this.#began) : now;
      this.#began = undefined;
    }
    showColors(settings.falseColors);
    const aspect = clientWidth / Math.max(1, clientHeight);
    this.#eye.see({ picture, viewPoint, settings, aspect, gauge: () => this.#renderer.gauge() });
    return changes;
  }

  /** How what is wanted is drawn where time is short; until that can be drawn at once, as what was shown before. */
  #affordable(viewPoint: ViewPoint, wanted: RenderSettings, moves: boolean): Drawing | undefined {
    const { fine } = this.#resolution;
    const settings = fine ? wanted : { ...wanted, occlusionRadius: 0 };
    const plain: Drawing = { viewPoint, settings, sampling: 1 };
    const best: Drawing = moves && fine ? { ...plain, sampling: 'temporal' } : plain;
    return [best, plain].find((drawing) => this.#isPrepared(drawing)) ?? (this.#shown && { ...this.#shown, viewPoint });
  }
}

const isSame = (a: readonly Scene[], b: readonly Scene[]): boolean =>
  a.length === b.length && a.every((scene, i) => scene === b[i]);

/** Whether the same is to be seen. Plain data of numbers and short arrays: compared by its text. */
const same = (a: Shown, b: Shown): boolean => textOf([a.viewPoint, a.settings]) === textOf([b.viewPoint, b.settings]);
