import type { FrameGraphBuffer } from '../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../scene/types.ts';
import { DEFAULT_SETTINGS, extraBuffers, type RenderSettings } from '../scene/view/view.ts';
import type { DomeMaps } from './lights/sky/domeMaps.ts';
import type { SceneBufferPool, SceneBuffers } from './sceneBuffers.ts';
import type { SceneUpload } from './sceneUpload.ts';

/** What a G-buffer shows, as far as uploads depend on it. */
type BufferScene = Pick<FrameGraphBuffer, 'scene' | 'speedOfLight'>;
type MakeUpload = (buffers: SceneBuffers) => SceneUpload;

/**
 * The scenes of a picture on the GPU, one upload per G-buffer, even if two show the same scene: object tables, tessellation, loaded samples and shadow
 * maps belong to one observation and one set of settings at a time. The views of a picture use them one after another. What depends on none is shared, in a pool.
 */
export class SceneUploads {
  private readonly pool: SceneBufferPool;
  private readonly makeUpload: MakeUpload;
  private readonly released: (upload: SceneUpload) => void;
  private scenes: readonly Scene[] = [];
  /** By scene, those that are shown in place of its own. */
  private readonly domes: (DomeMaps | undefined)[] = [];
  /** By G-buffer. */
  private readonly uploads: SceneUpload[] = [];

  constructor(pool: SceneBufferPool, makeUpload: MakeUpload, released: (upload: SceneUpload) => void) {
    this.pool = pool;
    this.makeUpload = makeUpload;
    this.released = released;
  }

  /** The upload of the first G-buffer. */
  get first(): SceneUpload | undefined {
    return this.uploads[0];
  }

  get isComplete(): boolean {
    return this.uploads.every(({ objectWriter, shadows }) => objectWriter.isComplete && shadows.isComplete);
  }

  /** Whether motion samples are read from files while rendering. */
  get isStreamed(): boolean {
    return this.uploads.some((upload) => upload.isStreamed);
  }

  setScenes(scenes: readonly [Scene, ...Scene[]]): void {
    const [first] = scenes;
    const upload = this.make(first, first.hints.speedOfLight ?? DEFAULT_SETTINGS.speedOfLight);
    this.trim(0);
    this.domes.length = 0;
    this.scenes = scenes;
    this.uploads.push(upload);
  }

  /** Shows another picture of the dome of scene `index`. */
  showDome(index: number, maps: DomeMaps): void {
    this.domes[index] = maps;
    for (const { scene, environment } of this.uploads) if (scene === this.scenes[index]) environment.showDome(maps);
  }

  /** Whether existing uploads must be replaced for a picture, which takes a while. */
  wouldReplace(settings: RenderSettings): boolean {
    return buffersOf(settings).some(
      (buffer, i) => this.uploads[i] !== undefined && !this.fits(this.uploads[i], buffer),
    );
  }

  /** The uploads of a picture's G-buffers, created if they are missing. */
  of(settings: RenderSettings): readonly SceneUpload[] {
    if (!this.first) return [];
    return buffersOf(settings).map((buffer, i) => {
      const existing = this.uploads[i];
      if (existing && this.fits(existing, buffer)) return existing;
      const scene = this.scenes[buffer.scene];
      if (!scene) throw new Error(`G-buffer ${i} is of scene ${buffer.scene}, of ${this.scenes.length}`);
      const upload = this.make(scene, buffer.speedOfLight, this.domes[this.scenes.indexOf(scene)]);
      if (existing) this.release(existing);
      this.uploads[i] = upload;
      return upload;
    });
  }

  /** Releases all but the first `count`. */
  trim(count: number): void {
    for (const upload of this.uploads.splice(count)) this.release(upload);
  }

  /** `maps`: of another picture of its dome. */
  private make(scene: Scene, speedOfLight: number, maps?: DomeMaps): SceneUpload {
    const buffers = this.pool.acquire(scene, speedOfLight);
    try {
      const upload = this.makeUpload(buffers);
      if (maps) upload.environment.showDome(maps);
      return upload;
    } catch (error) {
      this.pool.release(buffers);
      throw error;
    }
  }

  private release(upload: SceneUpload): void {
    this.released(upload);
    upload.dispose();
    this.pool.release(upload.buffers);
  }

  private fits({ buffers }: SceneUpload, { scene, speedOfLight }: BufferScene): boolean {
    return buffers.fits(this.scenes[scene], speedOfLight);
  }
}

const buffersOf = (settings: RenderSettings): readonly BufferScene[] => [
  { scene: 0, speedOfLight: settings.speedOfLight },
  ...extraBuffers(settings),
];
