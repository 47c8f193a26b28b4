import type { PerspectiveCamera, RenderTarget } from 'three/webgpu';
import { UnsignedByteType } from 'three/webgpu';
import type { Gauge } from '../scene/gauge.ts';
import { isFinished, type Plan, shapeOf } from '../scene/plan.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { FalseColors } from '../spectrum/falseColor.ts';
import type { Gpu } from './device.ts';
import type { Look } from './display.ts';
import { FalseColorTable, falseColored } from './falseColor.ts';
import { GaugeReader } from './gauge.ts';
import { Palettes } from './palette.ts';
import { PassBook } from './passBook.ts';
import { Composition, type Seen, type Sitting } from './plan/composition.ts';
import { Plate } from './plate.ts';
import type { SceneUpload } from './sceneUpload.ts';
import { Smoothing, type Way } from './smoothing.ts';
import { dataTarget, type GBuffer } from './targets.ts';
import type { Uniforms } from './uniforms.ts';
import type { Projection } from './vertexStage.ts';

/** How a picture is shown. */
type Shown = Look & Pick<RenderSettings, 'falseColors' | 'antialiasing' | 'plan'>;

/** So many compositions are kept: what is shown, what is being compiled, and what was shown before. */
const KEPT = 3;

/** The targets and passes of a picture of one size: G-buffers with their light, what a plan makes of it, display. */
export class PictureMachine {
  readonly smoothing: Smoothing;
  private readonly screen = dataTarget(1, UnsignedByteType);
  private readonly gpu: Gpu;
  private readonly uniforms: Uniforms;
  private readonly passes: PassBook;
  private readonly palettes = new Palettes();
  private readonly gauge: GaugeReader;
  /** The first is that of the picture itself. */
  private readonly plates: Plate[] = [];
  /** By the shape of their plans; the last that was drawn at the end. */
  private readonly compositions = new Map<string, Composition>();
  private readonly falseColors = new FalseColorTable();
  private size = { width: 1, height: 1 };
  /** Where the light of the last sample is. */
  private light: RenderTarget;
  /** How the picture that is there is to be shown; of how many samples its light is. */
  look: Shown = { tone: 'neutral', grid: false, starry: false, antialiasing: true };
  samples = 1;

  constructor(gpu: Gpu, uniforms: Uniforms) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.passes = new PassBook(gpu.renderer);
    this.light = this.plate(0).light();
    const light = () => this.light.texture;
    this.smoothing = new Smoothing({ light, buffer: this.buffer, uniforms, run: this.passes.run.bind(this.passes) });
    this.gauge = new GaugeReader(gpu, this.buffer, uniforms);
  }

  get buffer(): GBuffer {
    return this.bufferOf(0);
  }

  bufferOf(index: number): GBuffer {
    return this.plate(index).buffer;
  }

  setSize(width: number, height: number): void {
    this.size = { width, height };
    for (const sized of [...this.plates, ...this.compositions.values(), this.screen, this.smoothing])
      sized.setSize(width, height);
  }

  /** One sample of a picture: its G-buffers and their light, and what its plan makes of them; `seen` is told of each of its steps. */
  draw(sittings: readonly [Sitting, ...Sitting[]], camera: PerspectiveCamera, time: number, seen?: Seen): void {
    const [first] = sittings;
    const { plan } = first.subject.settings;
    if (plan) {
      this.light = this.compose(plan).draw(plan, { sittings, camera, time }, seen);
      return;
    }
    const plate = this.plate(0);
    plate.drawGeometry(first.subject, camera);
    plate.drawLight(first.subject, camera, first.subject.settings);
    this.light = plate.light();
  }

  /** What carries out plans of this shape; to be asked for before it is gone through without being drawn (rehearsal.ts), for it draws to targets to make them. */
  compose(plan: Plan): Composition {
    const shape = shapeOf(plan);
    const known = this.compositions.get(shape);
    const composition = known ?? new Composition(plan, this.gpu, this.uniforms, (i) => this.plate(i));
    if (!known) composition.setSize(this.size.width, this.size.height);
    this.compositions.delete(shape);
    this.compositions.set(shape, composition);
    const [oldest] = this.compositions;
    if (oldest && this.compositions.size > KEPT) {
      oldest[1].dispose();
      this.compositions.delete(oldest[0]);
    }
    return composition;
  }

  private plate(index: number): Plate {
    while (this.plates.length <= index) {
      const plate = new Plate(this.gpu, this.uniforms, this.palettes, this.passes);
      this.plates.push(plate);
      plate.setSize(this.size.width, this.size.height);
    }
    return this.plates[index];
  }

  /** The share of the sky that each point of what is in the first G-buffer sees. */
  openness(): RenderTarget {
    return this.plate(0).openness();
  }

  /** Goes through what makes a picture of its light, and pictures at rest of many, without making any. */
  rehearse(way: Way, projection: Projection, where: 'canvas' | 'screen'): void {
    const target = where === 'canvas' ? null : this.screen;
    if (this.look.falseColors) this.colorFalsely(this.look, this.look.falseColors, target);
    else this.smoothing.rehearse(way, this.look, projection, target);
  }

  /** The finished picture to the canvas (`null`), or to where it can be read. */
  present(where: 'canvas' | 'screen'): RenderTarget {
    const target = where === 'canvas' ? null : this.screen;
    if (this.look.falseColors) this.colorFalsely(this.look, this.look.falseColors, target);
    else this.smoothing.present(target);
    return this.screen;
  }

  private colorFalsely(look: Shown, colors: FalseColors, target: RenderTarget | null): void {
    const { falseColors, buffer, uniforms } = this;
    const { target: lit, index } = this.beauty();
    const light = lit.textures[index];
    falseColors.use(colors);
    const name = `false ${colors.kind} ${look.tone} ${look.grid} ${light.id}`;
    this.passes.run(name, () => falseColored(colors.kind, light, buffer, uniforms, falseColors, look), target);
  }

  /** Where the light of the whole picture is, and in which of its textures. */
  beauty(): { readonly target: RenderTarget; readonly index: number } {
    return this.samples > 1 ? this.smoothing.lightMean : { target: this.light, index: 0 };
  }

  /** What the picture is like at places spread over it; c [m/s]. */
  measure(c: number): Promise<Gauge> {
    const { target, index } = isFinished(this.look.plan) ? { target: this.plate(0).light(), index: 0 } : this.beauty();
    return this.gauge.read(target.textures[index], target.width, target.height, c);
  }

  /** Lets go of the passes that read a scene. */
  forget(upload: SceneUpload): void {
    this.smoothing.forget();
    this.passes.forget(upload.serial);
  }

  dispose(): void {
    for (const held of [...this.plates, ...this.compositions.values(), this.passes, this.gauge]) held.dispose();
    this.falseColors.dispose();
    for (const target of [this.screen, this.smoothing]) target.dispose();
  }
}
