import { isPanoramic } from '../scene/view/lenses/lenses.ts';
import type { PictureViews } from '../scene/view/pictureViews.ts';
import type { RenderSettings } from '../scene/view/view.ts';
import type { Capture } from './capture/capture.ts';
import type { FrameGraphRunner } from './frameGraph/frameGraphRunner.ts';
import type { GBuffer } from './gbuffer/gbuffer.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import type { PictureOverlay } from './post/display/overlay.ts';
import type { AntialiasingMode } from './post/resolve/antialiasing.ts';
import type { TemporalHistory } from './post/resolve/temporalHistory.ts';
import type { RendererOptions } from './settings.ts';

type PartSettings = Pick<RenderSettings, 'ghost' | 'pastFuture' | 'falseColors' | 'frameGraph' | 'outside' | 'capture'>;

const hasOverlay = ({ ghost, pastFuture }: PartSettings): boolean => ghost !== 'none' || pastFuture;

const hasCapture = ({ capture, frameGraph }: PartSettings): boolean =>
  capture !== undefined || (frameGraph?.extraBuffers.some((buffer) => buffer.capture) ?? false);

/** Code that few pictures need: overlays, frame graphs, captures, false colours, faces of panoramas and temporal antialiasing. All renderers share it. */
const PARTS = {
  overlay: lazyPart(async () => (await import('./post/display/makeOverlay.ts')).makeOverlay),
  runner: lazyPart(async () => (await import('./frameGraph/frameGraphRunner.ts')).FrameGraphRunner),
  capture: lazyPart(async () => (await import('./capture/capture.ts')).Capture),
  falseColors: lazyPart(() => import('./post/display/falseColor.ts')),
  faces: lazyPart(() => import('./lenses/faces.ts')),
  temporal: lazyPart(async () => (await import('./post/resolve/temporalHistory.ts')).TemporalHistory),
};

/** What a renderer uses of it: loaded by the first picture that needs it, which is not drawn before. */
export class PictureParts {
  private readonly uniforms: FrameUniforms;
  private readonly callbacks: Pick<RendererOptions, 'onSamples' | 'onError'>;
  /** Those that its pictures have waited for. */
  private readonly wanted = new Set<LazyPart<unknown>>();

  /** `onSamples` is called when code is there, `onError` if it cannot be loaded. */
  constructor(uniforms: FrameUniforms, callbacks: Pick<RendererOptions, 'onSamples' | 'onError'>) {
    this.uniforms = uniforms;
    this.callbacks = callbacks;
  }

  /** Whether a picture can be drawn; otherwise loads what it needs. Without overlays that cannot be loaded it is drawn. */
  isReady(views: PictureViews, settings: PartSettings, mode: AntialiasingMode): boolean {
    const missing = neededBy(views, settings, mode).filter(
      (part) => !part.code && !(part === PARTS.overlay && part.error),
    );
    for (const part of missing)
      if (!this.wanted.has(part)) {
        this.wanted.add(part);
        void this.announced(part);
      }
    return missing.length === 0;
  }

  get isLoading(): boolean {
    return [...this.wanted].some(({ code, error }) => !code && !error);
  }

  /** Loads what a picture needs. Rejects if it cannot be loaded. */
  async load(views: PictureViews, settings: PartSettings, mode: AntialiasingMode): Promise<void> {
    await Promise.all(neededBy(views, settings, mode).map((part) => part.load()));
  }

  /** Loads what runs frame graphs. */
  loadFrameGraphs(): Promise<void> {
    return PARTS.runner.load();
  }

  /** Loads everything. */
  async loadAll(): Promise<void> {
    await Promise.all(Object.values(PARTS).map((part) => part.load()));
  }

  /** Runs frame graphs; for pictures that are ready. */
  get FrameGraphRunner(): typeof FrameGraphRunner {
    return loaded(PARTS.runner, 'frame graphs');
  }

  /** Captures what surrounds an event; for pictures that are ready. */
  get Capture(): typeof Capture {
    return loaded(PARTS.capture, 'captures');
  }

  /** Displays numbers as colours; for pictures that are ready. */
  get falseColors() {
    return loaded(PARTS.falseColors, 'false colours');
  }

  /** What puts panoramic pictures together; for pictures that are ready. */
  get faces() {
    return loaded(PARTS.faces, 'faces');
  }

  /** The history of temporal antialiasing; for pictures that are ready. */
  get TemporalHistory(): typeof TemporalHistory {
    return loaded(PARTS.temporal, 'temporal antialiasing');
  }

  /** The overlay of a picture that is ready; undefined if it has none. `ghost`: the G-buffer of its ghost. */
  overlayOf(settings: PartSettings, picture: GBuffer, ghost: () => GBuffer): PictureOverlay | undefined {
    if (!hasOverlay(settings) || !PARTS.overlay.code) return undefined;
    const { pastFuture } = settings;
    const own = { picture, uniforms: this.uniforms, pastFuture, onlyMoving: settings.outside !== undefined };
    return PARTS.overlay.code({ ...own, ...(settings.ghost !== 'none' && { ghost: ghost() }) });
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

/** Throws if a part is used by a picture that is not ready. */
function loaded<Code>({ code }: LazyPart<Code>, name: string): Code {
  if (!code) throw new Error(`${name} are not loaded yet`);
  return code;
}

function neededBy(views: PictureViews, settings: PartSettings, mode: AntialiasingMode): readonly LazyPart<unknown>[] {
  const { overlay, runner, capture, falseColors, faces, temporal } = PARTS;
  return [
    ...(hasOverlay(settings) ? [overlay] : []),
    ...(settings.frameGraph ? [runner] : []),
    ...(hasCapture(settings) ? [capture] : []),
    ...(settings.falseColors ? [falseColors] : []),
    ...(views.some(({ lens }) => isPanoramic(lens)) ? [faces] : []),
    ...(mode === 'temporal' ? [temporal] : []),
  ];
}

/** Code that is loaded once. */
interface LazyPart<Code> {
  readonly code: Code | undefined;
  readonly error: unknown;
  load(): Promise<void>;
}

function lazyPart<Code>(importCode: () => Promise<Code>): LazyPart<Code> {
  let loading: Promise<void> | undefined;
  const part: { code: Code | undefined; error: unknown; load(): Promise<void> } = {
    code: undefined,
    error: undefined,
    load() {
      loading ??= importCode().then(
        (code) => {
          part.code = code;
        },
        (error: unknown) => {
          part.error = error;
          throw error;
        },
      );
      return loading;
    },
  };
  return part;
}
