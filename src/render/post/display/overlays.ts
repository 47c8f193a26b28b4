import type { RenderSettings } from '../../../scene/view/view.ts';
import type { GBuffer } from '../../gbuffer/gbuffer.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import type { RendererOptions } from '../../settings.ts';
import type { PictureOverlay } from './overlay.ts';

type OverlaySettings = Pick<RenderSettings, 'ghost' | 'pastFuture'>;

const isPlain = ({ ghost, pastFuture }: OverlaySettings): boolean => ghost === 'none' && !pastFuture;

/** The overlays of pictures. Their code is loaded by the first picture that has one; until then such pictures are not drawn. If it cannot be loaded, they are drawn without. */
export class Overlays {
  private readonly uniforms: FrameUniforms;
  private readonly callbacks: Pick<RendererOptions, 'onSamples' | 'onError'>;
  private makeOverlay: typeof import('./makeOverlay.ts').makeOverlay | undefined;
  private loading: Promise<void> | undefined;
  private failed = false;

  /** `onSamples` is called when the code is there, `onError` if it cannot be loaded. */
  constructor(uniforms: FrameUniforms, callbacks: Pick<RendererOptions, 'onSamples' | 'onError'>) {
    this.uniforms = uniforms;
    this.callbacks = callbacks;
  }

  /** Whether a picture can be drawn; otherwise loads what it needs. */
  isReady(settings: OverlaySettings): boolean {
    if (isPlain(settings) || this.makeOverlay || this.failed) return true;
    this.loading ??= this.load();
    return false;
  }

  get isLoading(): boolean {
    return this.loading !== undefined && !this.makeOverlay && !this.failed;
  }

  /** Resolves when loading has ended. */
  get loaded(): Promise<void> | undefined {
    return this.loading;
  }

  private async load(): Promise<void> {
    try {
      ({ makeOverlay: this.makeOverlay } = await import('./makeOverlay.ts'));
      this.callbacks.onSamples?.();
    } catch (error) {
      this.failed = true;
      if (!this.callbacks.onError) throw error;
      this.callbacks.onError(error as Error);
    }
  }

  /** The overlay of a picture; undefined if it has none. `ghost`: the G-buffer of its ghost. */
  of(settings: OverlaySettings, picture: GBuffer, ghost: () => GBuffer): PictureOverlay | undefined {
    if (isPlain(settings) || !this.makeOverlay) return undefined;
    const { pastFuture } = settings;
    return this.makeOverlay({
      picture,
      uniforms: this.uniforms,
      pastFuture,
      ...(settings.ghost !== 'none' && { ghost: ghost() }),
    });
  }
}
