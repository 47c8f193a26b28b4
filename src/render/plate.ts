import { FloatType, HalfFloatType, PerspectiveCamera, type RenderTarget, Scene, type Texture } from 'three/webgpu';
import type { RenderSettings } from '../scene/view.ts';
import type { Gpu } from './device.ts';
import type { Drawable } from './drawable.ts';
import { Occlusion } from './occlusion/occlusion.ts';
import { type Palettes, paletteOf } from './palette.ts';
import type { PassBook } from './passBook.ts';
import { forwardMaterial, geometryMaterial, skyLight, surfaceLight } from './passes.ts';
import type { SceneUpload } from './sceneUpload.ts';
import { dataTarget, GBuffer } from './targets.ts';
import type { Uniforms } from './uniforms.ts';
import type { Projection } from './vertexStage.ts';

/** What is within this part of the scene's size from a point hides its sky, where nobody says how far that goes. */
const HIDING = 1 / 4;

/** What a plate is exposed to. */
export interface Subject {
  readonly upload: SceneUpload;
  readonly projection: Projection;
  readonly settings: RenderSettings;
}

/** How the light of a G-buffer is made; what of the settings that may be otherwise for another light of the same. */
export type Lighting = Pick<RenderSettings, 'shadows' | 'occlusionRadius'>;

/** A G-buffer, and the light of what is in it. */
export class Plate {
  readonly buffer: GBuffer;
  private readonly gpu: Gpu;
  private readonly uniforms: Uniforms;
  private readonly palettes: Palettes;
  private readonly passes: PassBook;
  private readonly occlusion: Occlusion;
  /** The same G-buffer may be lit with shadows, and without. */
  private readonly lights: RenderTarget[] = [];
  private size = { width: 1, height: 1 };
  private subject: Subject | undefined;

  constructor(gpu: Gpu, uniforms: Uniforms, palettes: Palettes, passes: PassBook) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.palettes = palettes;
    this.passes = passes;
    this.buffer = new GBuffer(gpu.bytesPerSample, gpu.attachments);
    this.occlusion = new Occlusion(gpu, this.buffer, uniforms);
  }

  setSize(width: number, height: number): void {
    this.size = { width, height };
    this.buffer.setSize(width, height);
    this.occlusion.setSize(width, height);
    for (const light of this.lights) this.sizeLight(light);
  }

  /** Where light `index` is; to be asked for before the G-buffer is drawn. */
  light(index = 0): RenderTarget {
    while (this.lights.length <= index) {
      const made = dataTarget(1, this.gpu.floatBlending ? FloatType : HalfFloatType, this.buffer.depth);
      this.lights.push(made);
      this.sizeLight(made);
    }
    return this.lights[index];
  }

  /** Three clears the depth of a target of a new size when it first draws to it. That of a light is the G-buffer's: after the scene it would be too late. */
  private sizeLight(light: RenderTarget): void {
    light.setSize(this.size.width, this.size.height);
    this.gpu.renderer.setRenderTarget(light);
    this.gpu.renderer.render(new Scene(), new PerspectiveCamera());
  }

  /** Draws the opaque scene into the G-buffer. */
  drawGeometry(subject: Subject, camera: PerspectiveCamera): void {
    const { upload, projection } = subject;
    const { renderer } = this.gpu;
    this.subject = subject;
    for (const { names, target } of this.buffer.passes) {
      for (const drawable of upload.drawables)
        if (!drawable.batch.transparent)
          dress(drawable, `${names[0]} ${projection.event} ${projection.place}`, () =>
            geometryMaterial(drawable, projection, names, renderer.reversedDepthBuffer),
          );
      renderer.setRenderTarget(target);
      renderer.render(upload.opaque, camera);
    }
  }

  /** G-buffer to light, then what is transparent over it. */
  drawLight({ upload, projection, settings }: Subject, camera: PerspectiveCamera, lighting: Lighting, index = 0): void {
    const { buffer, uniforms, passes } = this;
    const { environment, scene, atlas } = upload;
    const light = this.light(index);
    const palette = paletteOf(settings, scene);
    const optics = this.palettes.optics(palette, scene, atlas);
    const shadows = lighting.shadows ? upload.shadows : undefined;
    const owner = upload.serial;
    passes.run(`sky ${palette}`, () => skyLight(environment, uniforms, optics), light, { owner, where: 'sky' });
    if (upload.opaque.children.some((mesh) => mesh.visible)) {
      const openness = lighting.occlusionRadius === 0 ? undefined : this.openness(lighting.occlusionRadius).texture;
      passes.run(
        `light ${palette} ${lighting.shadows} ${openness !== undefined}`,
        () => surfaceLight(buffer, environment, uniforms, optics, isMoving(upload), shadows, openness),
        light,
        { owner, where: 'surfaces' },
      );
    }
    if (upload.stars) this.drawOver(light, upload.stars.scene, camera);
    if (upload.transparent.children.every((mesh) => !mesh.visible)) return;
    for (const drawable of upload.drawables)
      if (drawable.batch.transparent)
        dress(
          drawable,
          `forward ${projection.event} ${projection.place} ${palette} ${lighting.shadows} ${buffer.depth.id}`,
          () => forwardMaterial(drawable, projection, buffer, upload.environment, optics, shadows),
        );
    this.drawOver(light, upload.transparent, camera);
  }

  /** The share of the sky that each point of what is in the G-buffer sees. `radius`: as `RenderSettings.occlusionRadius`. */
  openness(radius = this.subject?.settings.occlusionRadius): RenderTarget {
    if (this.subject) {
      const { upload, projection } = this.subject;
      const reach = radius ?? upload.radius * HIDING;
      this.occlusion.draw({ place: projection.place, moving: isMoving(upload), radius: reach });
    }
    return this.occlusion.target;
  }

  /** Where `openness` draws. */
  get opennessTexture(): Texture {
    return this.occlusion.texture;
  }

  dispose(): void {
    this.buffer.dispose();
    this.occlusion.dispose();
    for (const light of this.lights) light.dispose();
  }

  /** Onto the light that is there. */
  private drawOver(light: RenderTarget, scene: Scene, camera: PerspectiveCamera): void {
    const { renderer } = this.gpu;
    renderer.autoClear = false;
    renderer.setRenderTarget(light);
    renderer.render(scene, camera);
    renderer.autoClear = true;
  }
}

const isMoving = ({ bodies }: SceneUpload): boolean => bodies.some(({ object }) => object.motion.kind !== 'static');

function dress(drawable: Drawable, key: string, make: () => Drawable['mesh']['material']): void {
  const material = drawable.materials.get(key) ?? make();
  drawable.materials.set(key, material);
  drawable.mesh.material = material;
}
