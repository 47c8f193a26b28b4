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
import { CENTRE, gridPlaces, type SamplePlace, wanderingPlace } from './samplePlaces.ts';
import { SceneUpload } from './sceneUpload.ts';
import type { PickResult, RendererInfo, RendererOptions, Sampling } from './settings.ts';
import type { Sight } from './sight.ts';
import type { Way } from './smoothing.ts';
import { type Motif, motifOf, projectionOf, Staging } from './staging.ts';
import { Uploads } from './uploads.ts';

/** Of so many samples a picture is better than one that was smoothed otherwise. */
const WORTHWHILE = 8;

/** All that a picture is made of: its G-buffers, that of the settings first. */
type Motifs = readonly [Motif, ...Motif[]];

/** What others may make pictures of, as long as they are lent it. */
export interface Lent {
  readonly gpu: Gpu;
  readonly staging: Staging;
  readonly motifs: Motifs;
}

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
  private made: Motifs | undefined;
  /** What uniforms, tables and shadow maps are of. */
  private staged: Motifs | undefined;
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
        this.staged = undefined;
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
    const { backend, largest } = gpu;
    return { backend, largest, objects: first?.bodies.length ?? 0, triangles, tolerance, waiting, ...drawn };
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

  prepare(viewPoint: ViewPoint, settings: RenderSettings, sampling: Sampling = 1): Promise<void> | undefined {
    const { uploads } = this;
    // With another speed of light it may be another upload's turn.
    if (!uploads.first || uploads.wouldReplace(settings)) return undefined;
    const way = wayOf(settings, sampling);
    if (this.compiled.has(shadersOf(settings, way, uploads.of(settings)))) return undefined;
    this.preparing ??= this.compile(viewPoint, settings, way).finally(() => {
      this.preparing = undefined;
    });
    return this.preparing;
  }

  private async compile(viewPoint: ViewPoint, settings: RenderSettings, way: Way): Promise<void> {
    const motifs = this.motifsOf(viewPoint, settings);
    if (!motifs || !this.stage(motifs)) return;
    const draw = (): void => {
      this.draw(motifs, CENTRE);
      this.machine.rehearse(way, motifs[0].projection, this.toCanvas ? 'canvas' : 'screen');
    };
    const shaders = shadersOf(settings, way, this.uploads.of(settings));
    // Whatever comes of it: a shader that cannot be compiled is told of when it is to be drawn with.
    await rehearse(this.gpu.renderer, draw).finally(() => this.compiled.add(shaders));
  }

  render(viewPoint: ViewPoint, settings: RenderSettings, sampling: Sampling = 1): void {
    const began = performance.now();
    const motifs = this.motifsOf(viewPoint, settings);
    const seen = motifs && this.stage(motifs, () => this.resize());
    if (!motifs || !seen) return;
    const [{ upload, sight }] = motifs;
    this.made = motifs;
    this.added = 0;
    const way = wayOf(settings, sampling);
    if (way === 'followed') this.follow(motifs);
    else this.drawSamples(motifs, way === 'mean' ? Number(sampling) : 1);
    if (this.toCanvas) this.machine.present('canvas');
    this.taken = sight;
    this.drawn = { objectsDrawn: seen.filter(Boolean).length, milliseconds: performance.now() - began };
    this.compiled.add(shadersOf(settings, way, this.uploads.of(settings)));
    // While a picture is being compiled, its G-buffers are.
    if (!this.preparing) this.uploads.keep(motifs.length);
    // What was let go of is not of this picture: that can be drawn again.
    this.made = motifs;
    if (this.toCanvas) upload.refiner.countSometimes();
  }

  private motifsOf(viewPoint: ViewPoint, settings: RenderSettings): Motifs | undefined {
    const [first, ...others] = this.uploads
      .of(settings)
      .map((upload, i) => motifOf(upload, viewPoint, bufferSettings(settings, i)));
    return first && [first, ...others];
  }

  /** Puts everything in its place for a picture; tells which bodies of the first scene may be seen, or undefined where samples are still to come. */
  private stage(motifs: Motifs, ready?: () => void): readonly boolean[] | undefined {
    const [{ settings, upload }] = motifs;
    this.staged = undefined;
    this.machine.look = { ...settings, starry: upload.stars !== undefined };
    let seen: readonly boolean[] | undefined;
    // The first comes last: its uniforms stay.
    for (const motif of [...motifs].reverse()) {
      seen = this.staging.stage(motif, this.wanted, ready);
      if (!seen) return undefined;
    }
    if (settings.plan) this.machine.compose(settings.plan).develop(settings.plan);
    this.staged = motifs;
    return seen;
  }

  /** Puts everything back in its place for the last picture, where another was staged since; tells whether it can be drawn again. */
  private restage(): Motifs | undefined {
    const { made, staged } = this;
    return made && (staged === made || this.stage(made)) ? made : undefined;
  }

  refine(n: number): boolean {
    const { machine, added } = this;
    const count = n * n;
    if (added === count || machine.samples > 1 || !this.made || !isRefined(this.made[0].settings)) return false;
    const made = this.restage();
    if (!made) return true;
    this.sampleAt(made, gridPlaces(n)[added]);
    this.added = added + 1;
    machine.smoothing.add(added, count, machine.look, this.added >= Math.min(WORTHWHILE, count));
    if (this.toCanvas) machine.present('canvas');
    return this.added < count;
  }

  /** n × n samples per pixel. */
  private drawSamples(motifs: Motifs, n: number): void {
    const { machine } = this;
    machine.samples = n * n;
    for (const [i, place] of gridPlaces(n).entries()) {
      this.sampleAt(motifs, place);
      if (n > 1) machine.smoothing.add(i, n * n, machine.look, true);
    }
    if (machine.look.falseColors) this.settle();
    else if (n === 1) machine.smoothing.take(machine.look);
  }

  /** One sample, and what is left of the pictures before. */
  private follow(motifs: Motifs): void {
    const { machine } = this;
    machine.samples = 1;
    this.sampleAt(motifs, wanderingPlace(this.pictures++));
    machine.smoothing.follow(machine.look, { ...motifs[0], aspect: this.width / this.height });
  }

  private sampleAt(motifs: Motifs, place: SamplePlace): void {
    this.draw(motifs, place);
    this.settled = place[0] === 0 && place[1] === 0;
  }

  /** Draws what is staged with its samples at one place of their pixels. */
  private draw([first, ...others]: Motifs, place: SamplePlace): void {
    const { staging, size } = this;
    staging.jitter(place, size);
    const sitting = (motif: Motif) => ({ subject: motif, look: () => staging.look(motif, size) });
    this.machine.draw([sitting(first), ...others.map(sitting)], staging.camera, first.viewPoint.t);
  }

  /** Numbers are of the pixels' centres, and never a mean. */
  private settle(): void {
    const made = this.settled ? undefined : this.restage();
    if (made) this.sampleAt(made, CENTRE);
  }

  async readPixels(): Promise<Uint8Array> {
    await this.uploads.first?.refiner.count();
    this.restage();
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

  /**
   * Lends what the last picture was made of, all in its place, to who makes others of it on the same device (previews.ts); then everything is as it was.
   * Undefined where there is none.
   */
  lend<Made>(use: (set: Lent) => Made): Made | undefined {
    const { gpu, staging } = this;
    const motifs = this.restage();
    if (!motifs) return undefined;
    try {
      return use({ gpu, staging, motifs });
    } finally {
      staging.look(motifs[0], this.size);
    }
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

/** Whether its pictures come to more samples while they rest: colours that stand for numbers never do. */
const isRefined = ({ antialiasing, falseColors }: RenderSettings): boolean => antialiasing && !falseColors;

function wayOf(settings: RenderSettings, sampling: Sampling): Way {
  if (sampling === 'temporal' && isRefined(settings)) return 'followed';
  if (sampling !== 'temporal' && sampling > 1) return 'mean';
  return settings.antialiasing ? 'edges' : 'plain';
}

/** Names all the shaders that a picture takes. */
function shadersOf(settings: RenderSettings, way: Way, uploads: readonly SceneUpload[]): string {
  const { tone, grid, falseColors, shadows, occlusionRadius, plan } = settings;
  const buffers = uploads.map(({ serial, scene }, i) => {
    const own = bufferSettings(settings, i);
    const { event, place } = projectionOf(own);
    return [serial, event, place, paletteOf(own, scene)].join(' ');
  });
  const shape = plan && shapeOf(plan);
  return [...buffers, shadows, occlusionRadius !== 0, tone, grid, falseColors?.kind ?? way, shape].join(' ');
}

function withoutAlpha(rgba: Float32Array): Float32Array {
  const out = new Float32Array((rgba.length / 4) * 3);
  for (let i = 0; i < rgba.length / 4; i++) for (let k = 0; k < 3; k++) out[3 * i + k] = rgba[4 * i + k];
  return out;
}
