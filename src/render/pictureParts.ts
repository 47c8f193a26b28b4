import type { RenderSettings } from '../scene/view/view.ts';
import type { Capture } from './capture/capture.ts';
import type { FrameGraphRunner } from './frameGraph/frameGraphRunner.ts';
import type { GBuffer } from './gbuffer/gbuffer.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import type { PictureOverlay } from './post/display/overlay.ts';
import type { RendererOptions } from './settings.ts';

type PartSettings = Pick<RenderSettings, 'ghost' | 'pastFuture' | 'frameGraph' | 'outside' | 'capture'>;

const hasOverlay = ({ ghost, pastFuture }: PartSettings): boolean => ghost !== 'none' || pastFuture;

const hasCapture = ({ capture, frameGraph }: PartSettings): boolean =>
  capture !== undefined || (frameGraph?.extraBuffers.some((buffer) => buffer.capture) ?? false);

/** Code that few pictures need, overlays, frame graphs and captures: loaded by the first that does, which is not drawn before. */
export class PictureParts {
  private readonly uniforms: FrameUniforms;
  private readonly callbacks: Pick<RendererOptions, 'onSamples' | 'onError'>;
  private readonly overlay = new LazyPart(async () => (await import('./post/display/makeOverlay.ts')).makeOverlay);
  private readonly runner = new LazyPart(
    async () => (await import('./frameGraph/frameGraphRunner.ts')).FrameGraphRunner,
  );
  private readonly capture = new LazyPart(async () => (await import('./capture/capture.ts')).Capture);

  /** `onSamples` is called when code is there, `onError` if it cannot be loaded. */
  constructor(uniforms: FrameUniforms, callbacks: Pick<RendererOptions, 'onSamples' | 'onError'>) {
    this.uniforms = uniforms;
    this.callbacks = callbacks;
  }

  /** Whether a picture can be drawn; otherwise loads what it needs. Without overlays that cannot be loaded it is drawn. */
  isReady(settings: PartSettings): boolean {
    const missing = this.neededBy(settings).filter((part) => !part.code && !(part === this.overlay && part.error));
    for (const part of missing) if (!part.loading) void this.announced(part);
    return missing.length === 0;
  }

  get isLoading(): boolean {
    return [this.overlay, this.runner, this.capture].some(({ code, loading, error }) => loading && !code && !error);
  }

  /** Loads what a picture needs. Rejects if it cannot be loaded. */
  async load(settings: PartSettings): Promise<void> {
    await Promise.all(this.neededBy(settings).map((part) => part.load()));
  }

  /** Loads what runs frame graphs. */
  loadFrameGraphs(): Promise<void> {
    return this.runner.load();
  }

  /** Loads everything. */
  async loadAll(): Promise<void> {
    await Promise.all([this.overlay.load(), this.runner.load(), this.capture.load()]);
  }

  /** Runs frame graphs; for pictures that are ready. */
  get FrameGraphRunner(): typeof FrameGraphRunner {
    if (!this.runner.code) throw new Error('frame graphs are not loaded yet');
    return this.runner.code;
  }

  /** Captures what surrounds an event; for pictures that are ready. */
  get Capture(): typeof Capture {
    if (!this.capture.code) throw new Error('captures are not loaded yet');
    return this.capture.code;
  }

  /** The overlay of a picture that is ready; undefined if it has none. `ghost`: the G-buffer of its ghost. */
  overlayOf(settings: PartSettings, picture: GBuffer, ghost: () => GBuffer): PictureOverlay | undefined {
    if (!hasOverlay(settings) || !this.overlay.code) return undefined;
    const { pastFuture } = settings;
    const own = { picture, uniforms: this.uniforms, pastFuture, onlyMoving: settings.outside !== undefined };
    return this.overlay.code({ ...own, ...(settings.ghost !== 'none' && { ghost: ghost() }) });
  }

  private neededBy(settings: PartSettings): readonly LazyPart<unknown>[] {
    return [
      ...(hasOverlay(settings) ? [this.overlay] : []),
      ...(settings.frameGraph ? [this.runner] : []),
      ...(hasCapture(settings) ? [this.capture] : []),
    ];
  }

  private async announced(part: LazyPart<unknown>): Promise<void> {
    try {
      await part.load();
      this.callbacks.onSamples?.();
    } catch (error) {
      if (!this.callbacks.onError) throw error;
      this.callbacks.onError(error as Error);
    }
  }
}

/** Code that is loaded once. */
class LazyPart<Code> {
  code: Code | undefined;
  error: unknown;
  loading: Promise<void> | undefined;
  private readonly importCode: () => Promise<Code>;

  constructor(importCode: () => Promise<Code>) {
    this.importCode = importCode;
  }

  load(): Promise<void> {
    this.loading ??= this.importCode().then(
      (code) => {
        this.code = code;
      },
      (error: unknown) => {
        this.error = error;
        throw error;
      },
    );
    return this.loading;
  }
}
