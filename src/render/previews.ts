import { Fn, select, uniform, vec4 } from 'three/tsl';
import { type RenderTarget, type Texture, UnsignedByteType } from 'three/webgpu';
import { bufferSettings, type Plan, shapeOf } from '../scene/plan.ts';
import { toneMaps } from '../shaders/toneMap.ts';
import type { Vec4 } from '../shaders/types.ts';
import type { Gpu } from './device.ts';
import { encode } from './display.ts';
import { texelHere } from './fullScreen.ts';
import { GaugeReader } from './gauge.ts';
import { PassBook } from './passBook.ts';
import { PictureMachine } from './picture.ts';
import type { Sitting } from './plan/composition.ts';
import { readBytes } from './readback.ts';
import { rehearse } from './rehearsal.ts';
import type { Lent, SceneRenderer } from './renderer.ts';
import { CENTRE } from './samplePlaces.ts';
import type { SceneUpload } from './sceneUpload.ts';
import { dataTarget } from './targets.ts';
import type { Uniforms } from './uniforms.ts';

/** What of a plan is to be looked at. */
export type PreviewOf =
  /** The image of a step. `exposure` [EV]: of light that no tone curve was over yet; absent: it is 0 … 1 already. */
  | { readonly kind: 'image'; readonly step: number; readonly exposure?: number }
  /** The luminance of a step's light, at as many places as exposure is metered at. */
  | { readonly kind: 'luminance'; readonly step: number }
  /** The colours of the surfaces in a G-buffer; clear where there are none. */
  | { readonly kind: 'albedo'; readonly buffer: number };

/** Rows from the top: sRGB, RGBA8; or luminances. */
export type Preview = Uint8Array | Float32Array;

interface Size {
  readonly width: number;
  readonly height: number;
}

/**
 * Small pictures of the steps of a plan: drawn by the passes of the picture that is shown, of its scenes as they are staged for it, into targets of their own.
 * Nothing of that picture, its samples or its history changes.
 */
export class Previews {
  private readonly renderer: SceneRenderer;
  private desk: Desk | undefined;
  /** What the shaders that are ready depend on. */
  private ready = '';

  constructor(renderer: SceneRenderer) {
    this.renderer = renderer;
  }

  /**
   * In the order of what is asked for. `plan`: its G-buffers are those of the picture that is shown, in that order. New shaders are compiled between the
   * frames of others. Undefined where there is nothing that previews could be made of. One at a time.
   */
  async make(plan: Plan, of: readonly PreviewOf[], size: Size): Promise<readonly Preview[] | undefined> {
    await this.renderer.lend((set) => this.rehearsed(plan, of, this.deskFor(set, size), set));
    const reading = this.renderer.lend((set) => {
      const read: Promise<Preview>[] = [];
      this.deskFor(set, size).draw(plan, of, set, (i, made) => {
        read[i] = made();
      });
      return read;
    });
    return reading && Promise.all(reading);
  }

  dispose(): void {
    this.desk?.dispose();
  }

  private deskFor({ gpu, staging, motifs }: Lent, size: Size): Desk {
    this.desk ??= new Desk(gpu, staging.uniforms);
    this.desk.prepare(
      size,
      motifs.map(({ upload }) => upload),
    );
    return this.desk;
  }

  private rehearsed(plan: Plan, of: readonly PreviewOf[], desk: Desk, set: Lent): Promise<void> | undefined {
    const shaders = [shapeOf(plan), ...set.motifs.map(({ upload }) => upload.serial)].join(' ');
    if (shaders === this.ready) return undefined;
    this.ready = shaders;
    desk.begin(plan);
    return rehearse(set.gpu.renderer, () => desk.draw(plan, of, set, () => {}));
  }
}

/** Is told that what was asked for at place `i` is there, and how it is read. */
type Finished = (i: number, read: () => Promise<Preview>) => void;

/** The targets and passes of previews of one size. */
class Desk {
  private readonly gpu: Gpu;
  private readonly uniforms: Uniforms;
  private readonly machine: PictureMachine;
  private readonly screen = dataTarget(1, UnsignedByteType);
  private readonly exposure = uniform(0);
  private passes: PassBook;
  private gauge: GaugeReader;
  private size = { width: 1, height: 1 };
  private uploads: readonly SceneUpload[] = [];

  constructor(gpu: Gpu, uniforms: Uniforms) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.machine = new PictureMachine(gpu, uniforms);
    this.passes = new PassBook(gpu.renderer);
    this.gauge = new GaugeReader(gpu, this.machine.buffer, uniforms);
  }

  /** Lets go of the passes of scenes that are gone. */
  prepare({ width, height }: Size, uploads: readonly SceneUpload[]): void {
    for (const upload of this.uploads) if (!uploads.includes(upload)) this.machine.forget(upload);
    this.uploads = uploads;
    if (width === this.size.width && height === this.size.height) return;
    this.size = { width, height };
    this.machine.setSize(width, height);
    this.screen.setSize(width, height);
  }

  /** Plans of another shape have other targets, which passes read. */
  begin(plan: Plan): void {
    this.passes.dispose();
    this.gauge.dispose();
    this.passes = new PassBook(this.gpu.renderer);
    this.gauge = new GaugeReader(this.gpu, this.machine.buffer, this.uniforms);
    this.machine.compose(plan).develop(plan);
  }

  draw(plan: Plan, of: readonly PreviewOf[], { staging, motifs }: Lent, finished: Finished): void {
    const [first] = motifs;
    const { size } = this;
    const settings = { ...first.settings, plan };
    const sittingOf = (motif: typeof first, i: number): Sitting => ({
      subject: { ...motif, settings: bufferSettings(settings, i) },
      look: () => staging.look(motif, size),
    });
    const [sitting, ...others] = motifs.map(sittingOf);
    staging.look(first, size);
    staging.jitter(CENTRE, size);
    this.machine.draw([sitting, ...others], staging.camera, first.viewPoint.t, (step, image) => {
      of.forEach((each, i) => {
        if (each.kind === 'image' && each.step === step) finished(i, this.image(image, each.exposure));
        if (each.kind === 'luminance' && each.step === step) finished(i, () => this.luminance(image, first.sight.c));
      });
    });
    of.forEach((each, i) => {
      if (each.kind === 'albedo') finished(i, this.albedo(each.buffer));
    });
  }

  dispose(): void {
    for (const held of [this.machine, this.passes, this.gauge, this.screen]) held.dispose();
  }

  private image({ texture }: RenderTarget, exposure: number | undefined): () => Promise<Preview> {
    const tone = exposure === undefined ? 'linear' : 'neutral';
    this.exposure.value = exposure ?? 0;
    return this.shown(`${tone} ${texture.id}`, () =>
      Fn(() => vec4(encode(toneMaps[tone](texelHere(texture).rgb, this.exposure)), 1))(),
    );
  }

  private albedo(buffer: number): () => Promise<Preview> {
    const { machine } = this;
    const texel = (name: 'base' | 'object'): Texture => machine.bufferOf(buffer).texture(name);
    return this.shown(`albedo ${buffer}`, () =>
      Fn(() => {
        const there = texelHere(texel('object')).x.greaterThan(0.5);
        return select(there, vec4(encode(texelHere(texel('base')).rgb), 1), vec4(0));
      })(),
    );
  }

  private shown(name: string, output: () => Vec4): () => Promise<Preview> {
    this.passes.run(name, output, this.screen);
    return () => readBytes(this.gpu, this.screen, { x: 0, y: 0, ...this.size });
  }

  private async luminance(image: RenderTarget, c: number): Promise<Preview> {
    const { luminance } = await this.gauge.read(image.texture, image.width, image.height, c);
    return luminance;
  }
}
