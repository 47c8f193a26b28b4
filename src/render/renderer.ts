import type { Gauge } from '../scene/gauge.ts';
import { bufferSettings, shapeOf } from '../scene/plan.ts';
import type { Scene } from '../scene/types.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view.ts';
import type { PictureMaker } from './api.ts';
import { type Gpu, openGpu } from './device.ts';
import { paletteOf } from './palette.ts';
import { PictureMachine } from './picture.ts';
import { type Region, readBytes, readData, readFloats, readSurfaceAt } from './readback.ts';
import { rehearse } from './rehearsal.ts';
import { gridPlaces, type SamplePlace, wanderingPlace } from './samplePlaces.ts';
import { SceneUpload } from './sceneUpload.ts';
import type { PickResult, RendererInfo, RendererOptions, Sampling } from './settings.ts';
import type { Sight } from './sight.ts';
import { projectionOf, type Staged, Staging } from './staging.ts';
import { Uploads } from './uploads.ts';

/** Samples in a pixel along each side, where there is time: what pictures at rest come to. */
const FINEST = 8;
const CENTRE: SamplePlace = [0, 0];
/** Of so many samples a picture is better than one that was smoothed otherwise. */
const WORTHWHILE = 8;

/** A picture that can be drawn, sample by sample: its G-buffers, that of the settings first. */
type Made = readonly [Staged, ...Staged[]];

/** Makes pictures of a scene for a page, a command line or a benchmark; see api.ts. */
export class SceneRenderer implements PictureMaker {
  private readonly gpu: Gpu;
  private readonly staging = new Staging();
  private readonly machine: PictureMachine;
  private readonly toCanvas: boolean;
  private readonly uploads: Uploads;
  /** What pictures have been drawn with, or can be at once. */
  private readonly compiled = new Set<string>();
  private preparing: Promise<void> | undefined;
  private taken: Sight | undefined;
  /** Of the last picture, and of the next one: the size changes when that is made, for a canvas of a new size is empty. */
  private size = { width: 1, height: 1 };
  private wanted = this.size;
  private made: Made | undefined;
  /** Samples of the last picture that `refine` has added. */
  private added = 0;
  /** The G-buffer and the light are those of the pixels' centres. */
  private settled = true;
  private pictures = 0;
  private drawn = { objectsDrawn: 0, milliseconds: 0 };

  static async create(options: RendererOptions = {}): Promise<SceneRenderer> {
    return new SceneRenderer(await openGpu(options), options);
  }

  private constructor(gpu: Gpu, options: RendererOptions) {
    this.gpu = gpu;
    this.toCanvas = options.canvas !== undefined;
    const { uniforms } = this.staging;
    this.machine = new PictureMachine(gpu, uniforms);
    this.uploads = new Uploads(
      (scene, speedOfLight) => new SceneUpload(scene, speedOfLight, uniforms, gpu, options),
      (upload) => {
        this.made = undefined;
        this.machine.forget(upload);
      },
    );
  }

  get info(): RendererInfo {
    const { drawn, gpu, uploads } = this;
    const { first } = uploads;
    const triangles = first?.refiner.triangles ?? 0;
    const tolerance = first?.refiner.toleranceReached ?? 0;
    const waiting = !uploads.isComplete;
    return { backend: gpu.backend, objects: first?.bodies.length ?? 0, triangles, tolerance, waiting, ...drawn };
  }
  get width(): number {
    return this.size.width;
  }
  get height(): number {
    return this.size.height;
  }

  async setScene(scene: Scene, others: readonly Scene[] = []): Promise<void> {
    this.uploads.setScenes([scene, ...others]);
  }

  setSize(width: number, height: number): void {
    this.wanted = { width: Math.max(1, Math.round(width)), height: Math.max(1, Math.round(height)) };
    if (!this.taken) this.resize();
  }

  private resize(): void {
    const { width, height } = this.wanted;
    if (width === this.width && height === this.height) return;
    this.size = this.wanted;
    this.gpu.renderer.setSize(width, height, false);
    this.machine.setSize(width, height);
    this.taken = undefined;
  }

  prepare(viewPoint: ViewPoint, settings: RenderSettings): Promise<void> | undefined {
    const { uploads } = this;
    // With another speed of light it may be another upload's turn.
    if (!uploads.first || uploads.wouldReplace(settings)) return undefined;
    const shaders = shadersOf(settings, uploads.of(settings));
    if (this.compiled.has(shaders)) return undefined;
    this.preparing ??= this.compile(viewPoint, settings, shaders).finally(() => {
      this.preparing = undefined;
    });
    return this.preparing;
  }

  private async compile(viewPoint: ViewPoint, settings: RenderSettings, shaders: string): Promise<void> {
    const made = this.stage(viewPoint, settings);
    if (!made) return;
    if (settings.plan) this.machine.compose(settings.plan);
    const draw = (): void => {
      this.machine.look = lookOf(made);
      this.sampleAt(CENTRE, made);
      this.machine.smoothing.smoothEdges(this.machine.look);
      if (this.toCanvas) this.machine.present('canvas');
    };
    // Whatever comes of it: a shader that cannot be compiled is told of when it is to be drawn with.
    await rehearse(this.gpu.renderer, draw).finally(() => this.compiled.add(shaders));
  }

  render(viewPoint: ViewPoint, settings: RenderSettings, sampling: Sampling = 1): void {
    const began = performance.now();
    const made = this.stage(viewPoint, settings, () => this.resize());
    if (!made) return;
    const [first] = made;
    this.made = made;
    this.machine.look = lookOf(made);
    this.added = 0;
    if (settings.falseColors && sampling === 'temporal') this.drawSamples(1);
    else if (sampling === 'temporal') this.follow(first);
    else this.drawSamples(sampling);
    if (this.toCanvas) this.machine.present('canvas');
    this.taken = first.sight;
    this.drawn = { objectsDrawn: first.seen.filter(Boolean).length, milliseconds: performance.now() - began };
    this.compiled.add(shadersOf(settings, this.uploads.of(settings)));
    if (!this.preparing) this.uploads.keep(made.length);
    if (this.toCanvas) first.upload.refiner.countSometimes();
  }

  /** Puts everything in its place for a picture; undefined where samples of it are still to come. */
  private stage(viewPoint: ViewPoint, settings: RenderSettings, ready?: () => void): Made | undefined {
    const staged: Staged[] = [];
    for (const [i, upload] of this.uploads.of(settings).entries()) {
      const of = this.staging.stage(upload, viewPoint, bufferSettings(settings, i), this.wanted, ready);
      if (!of) return undefined;
      staged.push(of);
    }
    const [first, ...others] = staged;
    return first && [first, ...others];
  }

  refine(): boolean {
    const { made, machine, added } = this;
    const count = FINEST * FINEST;
    if (!made || made[0].settings.falseColors || !isComplete(made) || machine.samples > 1) return false;
    if (added === count) return false;
    this.sampleAt(gridPlaces(FINEST)[added]);
    this.added = added + 1;
    machine.smoothing.add(added, count, machine.look, this.added >= WORTHWHILE);
    if (this.toCanvas) machine.present('canvas');
    return this.added < count;
  }

  /** n × n samples per pixel. */
  private drawSamples(n: number): void {
    const { machine } = this;
    machine.samples = n * n;
    for (const [i, place] of gridPlaces(n).entries()) {
      this.sampleAt(place);
      if (n === 1) machine.smoothing.smoothEdges(machine.look);
      else machine.smoothing.add(i, n * n, machine.look, true);
    }
    if (machine.look.falseColors) this.settle();
  }

  /** One sample, and what is left of the pictures before. */
  private follow({ view, sight, projection }: Staged): void {
    const { machine } = this;
    machine.samples = 1;
    this.sampleAt(wanderingPlace(this.pictures++));
    machine.smoothing.follow(machine.look, { sight, view, projection, aspect: this.width / this.height });
  }

  /** Draws the last picture with its samples at one place of their pixels. */
  private sampleAt(place: SamplePlace, made = this.made): void {
    if (!made) return;
    const { staging, size } = this;
    staging.jitter(place, size);
    const [first, ...others] = made;
    const sitting = (staged: Staged) => ({ subject: staged, look: () => staging.look(staged, size) });
    this.machine.draw([sitting(first), ...others.map(sitting)], staging.camera, first.view.t);
    this.settled = place[0] === 0 && place[1] === 0;
  }

  /** Numbers are of the pixels' centres, and never a mean. */
  private settle(): void {
    if (!this.settled && this.made && isComplete(this.made)) this.sampleAt(CENTRE);
  }

  async readPixels(): Promise<Uint8Array> {
    await this.uploads.first?.refiner.count();
    return readBytes(this.gpu, this.machine.present('screen'), this.whole());
  }

  async readAov(name: AovName): Promise<Float32Array> {
    this.settle();
    if (name !== 'beauty') return readData(this.gpu, this.machine, name, this.picture(), this.whole());
    const { target, index } = this.machine.beauty();
    return withoutAlpha(await readFloats(this.gpu, target, index, this.whole()));
  }

  async pick(x: number, y: number): Promise<PickResult | undefined> {
    const inside = x >= 0 && y >= 0 && x < this.width && y < this.height;
    const { taken } = this;
    const upload = this.uploads.first;
    if (!inside || !upload || !taken) return undefined;
    this.settle();
    const pathOf = (id: number) => upload.bodies[id - 1].object.path;
    const [column, row] = [Math.floor(x), Math.floor(y)];
    const { target, index } = this.machine.beauty();
    const [light, surface] = await Promise.all([
      readFloats(this.gpu, target, index, { x: column, y: row, width: 1, height: 1 }),
      readSurfaceAt(this.gpu, this.machine, taken, pathOf, column, row),
    ]);
    return { light: [light[0], light[1], light[2]], ...(surface && { surface }) };
  }

  async gauge(): Promise<Gauge> {
    this.settle();
    return this.machine.measure(this.picture().c);
  }

  dispose(): void {
    this.uploads.keep(0);
    this.machine.dispose();
    this.gpu.renderer.dispose();
  }

  private picture(): Sight {
    if (!this.taken) throw new Error('nothing has been rendered yet');
    return this.taken;
  }

  private whole(): Region {
    return { x: 0, y: 0, width: this.width, height: this.height };
  }
}

const isComplete = (made: Made): boolean => made.every(({ upload }) => upload.frame.isComplete);

const lookOf = ([{ settings, upload }]: Made) => ({ ...settings, starry: upload.stars !== undefined });

/** Names all the shaders that a picture takes. */
function shadersOf(settings: RenderSettings, uploads: readonly SceneUpload[]): string {
  const { tone, grid, falseColors, shadows, occlusionRadius, plan } = settings;
  const buffers = uploads.map(({ serial, scene }, i) => {
    const own = bufferSettings(settings, i);
    const { event, place } = projectionOf(own);
    return [serial, event, place, paletteOf(own, scene)].join(' ');
  });
  const shape = plan && shapeOf(plan);
  return [...buffers, shadows, occlusionRadius !== 0, tone, grid, falseColors?.kind, shape].join(' ');
}

function withoutAlpha(rgba: Float32Array): Float32Array {
  const out = new Float32Array((rgba.length / 4) * 3);
  for (let i = 0; i < rgba.length / 4; i++) for (let k = 0; k < 3; k++) out[3 * i + k] = rgba[4 * i + k];
  return out;
}
