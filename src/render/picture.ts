import { FloatType, HalfFloatType, PerspectiveCamera, type RenderTarget, Scene, UnsignedByteType } from 'three/webgpu';
import type { Gauge } from '../scene/gauge.ts';
import type { RenderSettings } from '../scene/view.ts';
import type { FalseColors } from '../spectrum/falseColor.ts';
import type { Gpu } from './device.ts';
import type { Look } from './display.ts';
import type { Drawable } from './drawable.ts';
import { FalseColorTable, falseColored } from './falseColor.ts';
import { FullScreen, type Where } from './fullScreen.ts';
import { GaugeReader } from './gauge.ts';
import { Occlusion, type OcclusionRequest } from './occlusion/occlusion.ts';
import { Palettes, paletteOf } from './palette.ts';
import { forwardMaterial, geometryMaterial, skyLight, surfaceLight } from './passes.ts';
import type { SceneUpload } from './sceneUpload.ts';
import { Smoothing } from './smoothing.ts';
import { dataTarget, GBuffer } from './targets.ts';
import type { Uniforms } from './uniforms.ts';
import type { Projection } from './vertexStage.ts';

/** What is within this part of the scene's size from a point hides its sky, where nobody says how far that goes. */
const HIDING = 1 / 4;

/** How a picture is shown. */
type Shown = Look & Pick<RenderSettings, 'falseColors'>;

/** The targets and passes of a picture of one size: G-buffer, light, transparent things, display. */
export class PictureMachine {
  readonly buffer: GBuffer;
  readonly light: RenderTarget;
  readonly smoothing: Smoothing;
  private readonly screen = dataTarget(1, UnsignedByteType);
  private readonly gpu: Gpu;
  private readonly uniforms: Uniforms;
  private readonly passes = new Map<string, FullScreen>();
  private readonly palettes = new Palettes();
  private readonly gauge: GaugeReader;
  private readonly occlusion: Occlusion;
  private hiding: OcclusionRequest | undefined;
  private readonly falseColors = new FalseColorTable();
  /** How the picture that is there is to be shown; of how many samples its light is. */
  look: Shown = { tone: 'neutral', grid: false, starry: false };
  samples = 1;

  constructor(gpu: Gpu, uniforms: Uniforms) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.buffer = new GBuffer(gpu.bytesPerSample, gpu.attachments);
    this.occlusion = new Occlusion(gpu, this.buffer, uniforms);
    this.light = dataTarget(1, gpu.floatBlending ? FloatType : HalfFloatType, this.buffer.depth);
    const run = this.run.bind(this);
    this.smoothing = new Smoothing({ light: this.light, buffer: this.buffer, uniforms, run });
    this.gauge = new GaugeReader(gpu, this.buffer, uniforms);
  }

  setSize(width: number, height: number): void {
    this.buffer.setSize(width, height);
    this.occlusion.setSize(width, height);
    for (const target of [this.light, this.screen, this.smoothing]) target.setSize(width, height);
    // Three clears the depth of a target of a new size when it first draws to it. That of `light` is the G-buffer's: after the scene it would be too late.
    this.gpu.renderer.setRenderTarget(this.light);
    this.gpu.renderer.render(new Scene(), new PerspectiveCamera());
  }

  /** Draws the opaque scene into the G-buffer. */
  drawGeometry(upload: SceneUpload, projection: Projection, camera: PerspectiveCamera): void {
    const { renderer } = this.gpu;
    for (const { names, target } of this.buffer.passes) {
      for (const drawable of upload.drawables)
        if (!drawable.batch.transparent)
          this.dress(drawable, `${names[0]} ${projection.event} ${projection.place}`, () =>
            geometryMaterial(drawable, projection, names, renderer.reversedDepthBuffer),
          );
      renderer.setRenderTarget(target);
      renderer.render(upload.opaque, camera);
    }
  }

  /** G-buffer to light, then what is transparent over it. */
  drawLight(upload: SceneUpload, projection: Projection, camera: PerspectiveCamera, settings: RenderSettings): void {
    const { buffer, uniforms, light } = this;
    const { environment, bodies, scene } = upload;
    const palette = paletteOf(settings, scene);
    const optics = this.palettes.optics(palette, scene);
    const shadows = settings.shadows ? upload.shadows : undefined;
    const moving = bodies.some(({ object }) => object.motion.kind !== 'static');
    this.run(`sky ${upload.serial} ${palette}`, () => skyLight(environment, uniforms, optics), light, 'sky');
    const radius = settings.occlusionRadius ?? upload.radius * HIDING;
    this.hiding = { place: projection.place, moving, radius };
    if (upload.opaque.children.some((mesh) => mesh.visible)) {
      const openness = radius > 0 ? this.openness().texture : undefined;
      this.run(
        `light ${upload.serial} ${palette} ${settings.shadows} ${openness !== undefined}`,
        () => surfaceLight(buffer, environment, uniforms, optics, moving, shadows, openness),
        light,
        'surfaces',
      );
    }
    if (upload.stars) this.drawOver(upload.stars.scene, camera);
    if (upload.transparent.children.every((mesh) => !mesh.visible)) return;
    for (const drawable of upload.drawables)
      if (drawable.batch.transparent)
        this.dress(drawable, `forward ${projection.event} ${projection.place} ${palette} ${settings.shadows}`, () =>
          forwardMaterial(drawable, projection, buffer, upload.environment, optics, shadows),
        );
    this.drawOver(upload.transparent, camera);
  }

  /** The share of the sky that each point of what is in the G-buffer sees. */
  openness(): RenderTarget {
    if (this.hiding) this.occlusion.draw(this.hiding);
    return this.occlusion.target;
  }

  /** Onto the light that is there. */
  private drawOver(scene: Scene, camera: PerspectiveCamera): void {
    const { renderer } = this.gpu;
    renderer.autoClear = false;
    renderer.setRenderTarget(this.light);
    renderer.render(scene, camera);
    renderer.autoClear = true;
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
    this.run(name, () => falseColored(colors.kind, light, buffer, uniforms, falseColors, look), target);
  }

  /** Where the light of the whole picture is, and in which of its textures. */
  beauty(): { readonly target: RenderTarget; readonly index: number } {
    return this.samples > 1 ? this.smoothing.mean : { target: this.light, index: 0 };
  }

  /** What the picture is like at places spread over it; c [m/s]. */
  measure(c: number): Promise<Gauge> {
    const { target, index } = this.beauty();
    return this.gauge.read(target.textures[index], target.width, target.height, c);
  }

  /** Lets go of the passes that read a scene. */
  forget(upload: SceneUpload): void {
    this.smoothing.forget();
    for (const [name, pass] of this.passes) {
      if (!name.startsWith(`sky ${upload.serial} `) && !name.startsWith(`light ${upload.serial} `)) continue;
      pass.dispose();
      this.passes.delete(name);
    }
  }

  dispose(): void {
    for (const pass of this.passes.values()) pass.dispose();
    this.buffer.dispose();
    this.palettes.dispose();
    this.gauge.dispose();
    this.occlusion.dispose();
    this.falseColors.dispose();
    for (const target of [this.light, this.screen, this.smoothing]) target.dispose();
  }

  private run(
    name: string,
    output: () => ConstructorParameters<typeof FullScreen>[0],
    target: RenderTarget | null,
    where?: Where,
  ): void {
    const pass = this.passes.get(name) ?? new FullScreen(output(), name, where);
    this.passes.set(name, pass);
    pass.render(this.gpu.renderer, target, where === 'surfaces');
  }

  private dress(drawable: Drawable, key: string, make: () => Drawable['mesh']['material']): void {
    const material = drawable.materials.get(key) ?? make();
    drawable.materials.set(key, material);
    drawable.mesh.material = material;
  }
}
