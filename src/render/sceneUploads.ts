import type { FrameGraphBuffer } from '../scene/frameGraph/frameGraph.ts';
import type { Scene } from '../scene/types.ts';
import { DEFAULT_SETTINGS, type RenderSettings } from '../scene/view/view.ts';
import type { SceneUpload } from './sceneUpload.ts';

/**
 * The scenes of a picture on the GPU, one upload for each G-buffer, also where two are of the same scene: object tables, tessellation, loaded samples and
 * shadow maps are those of one observation and one set of settings at a time. The views of a picture use them one after another.
 */
export class SceneUploads {
  private readonly make: (scene: Scene, speedOfLight: number) => SceneUpload;
  private readonly released: (upload: SceneUpload) => void;
  private scenes: readonly Scene[] = [];
  /** By G-buffer. */
  private readonly uploads: SceneUpload[] = [];

  constructor(make: (scene: Scene, speedOfLight: number) => SceneUpload, released: (upload: SceneUpload) => void) {
    this.make = make;
    this.released = released;
  }

  /** Of the picture's first G-buffer. */
  get first(): SceneUpload | undefined {
    return this.uploads[0];
  }

  get isComplete(): boolean {
    return this.uploads.every(({ objectWriter: frame, shadows }) => frame.isComplete && shadows.isComplete);
  }

  /** Whether samples of motions are read from files while pictures are drawn. */
  get isStreamed(): boolean {
    return this.uploads.some((upload) => upload.isStreamed);
  }

  setScenes(scenes: readonly [Scene, ...Scene[]]): void {
    const [first] = scenes;
    const upload = this.make(first, first.hints.speedOfLight ?? DEFAULT_SETTINGS.speedOfLight);
    this.trim(0);
    this.scenes = scenes;
    this.uploads.push(upload);
  }

  /** Whether a picture needs other uploads than there are, where there were some already: making them takes a while. */
  wouldReplace(settings: RenderSettings): boolean {
    return buffersOf(settings).some(
      (buffer, i) => this.uploads[i] !== undefined && !this.fits(this.uploads[i], buffer),
    );
  }

  /** For each G-buffer of a picture. */
  of(settings: RenderSettings): readonly SceneUpload[] {
    if (!this.first) return [];
    return buffersOf(settings).map((buffer, i) => {
      const known = this.uploads[i];
      if (known && this.fits(known, buffer)) return known;
      const scene = this.scenes[buffer.scene];
      if (!scene) throw new Error(`G-buffer ${i} is of scene ${buffer.scene}, of ${this.scenes.length}`);
      const upload = this.make(scene, buffer.speedOfLight);
      if (known) this.release(known);
      this.uploads[i] = upload;
      return upload;
    });
  }

  /** Lets go of those after the first `count`. */
  trim(count: number): void {
    for (const upload of this.uploads.splice(count)) this.release(upload);
  }

  private release(upload: SceneUpload): void {
    this.released(upload);
    upload.dispose();
  }

  private fits(
    upload: SceneUpload,
    { scene, speedOfLight }: Pick<FrameGraphBuffer, 'scene' | 'speedOfLight'>,
  ): boolean {
    if (upload.scene !== this.scenes[scene]) return false;
    return !upload.dependsOnSpeedOfLight || upload.speedOfLight === speedOfLight;
  }
}

const buffersOf = ({
  speedOfLight,
  frameGraph,
}: RenderSettings): readonly Pick<FrameGraphBuffer, 'scene' | 'speedOfLight'>[] => [
  { scene: 0, speedOfLight },
  ...(frameGraph?.extraBuffers ?? []),
];
