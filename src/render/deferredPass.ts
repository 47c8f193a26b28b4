import { FloatType, HalfFloatType, PerspectiveCamera, type RenderTarget, Scene, type Texture } from 'three/webgpu';
import { isStatic } from '../scene/motion/motion.ts';
import type { RenderSettings } from '../scene/view/view.ts';
import { type ColorPipelines, colorVariantOf } from './color/colorPipelines.ts';
import type { DrawCall } from './gbuffer/drawCall.ts';
import { dataTarget, GBuffer } from './gbuffer/gbuffer.ts';
import type { SpacetimeProjection } from './geometry/vertexStage.ts';
import type { Gpu } from './gpu/device.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import type { PassCache } from './gpu/passCache.ts';
import { AmbientOcclusion } from './occlusion/ambientOcclusion.ts';
import type { SceneUpload } from './sceneUpload.ts';
import { forwardMaterial, geometryMaterial, lightingPass, skyPass } from './shading/passes.ts';

/** What is within this part of the scene's size from a point hides its sky, where nobody says how far that goes. */
const OCCLUSION_RADIUS_SHARE = 1 / 4;

/** What a plate is exposed to. */
export interface GBufferView {
  readonly upload: SceneUpload;
  readonly projection: SpacetimeProjection;
  readonly settings: RenderSettings;
}

/** How the light of a G-buffer is made; what of the settings that may be otherwise for another light of the same. */
export type Lighting = Pick<RenderSettings, 'shadows' | 'occlusionRadius'>;

/** A G-buffer, and the light of what is in it. */
export class DeferredPass {
  readonly buffer: GBuffer;
  private readonly gpu: Gpu;
  private readonly uniforms: FrameUniforms;
  private readonly colorPipelines: ColorPipelines;
  private readonly passes: PassCache;
  private readonly occlusion: AmbientOcclusion;
  /** The same G-buffer may be lit with shadows, and without. */
  private readonly lightTargets: RenderTarget[] = [];
  private size = { width: 1, height: 1 };
  private view: GBufferView | undefined;

  constructor(gpu: Gpu, uniforms: FrameUniforms, palettes: ColorPipelines, passes: PassCache) {
    this.gpu = gpu;
    this.uniforms = uniforms;
    this.colorPipelines = palettes;
    this.passes = passes;
    this.buffer = new GBuffer(gpu.maxBytesPerSample, gpu.maxAttachments);
    this.occlusion = new AmbientOcclusion(gpu, this.buffer, uniforms);
  }

  setSize(width: number, height: number): void {
    this.size = { width, height };
    this.buffer.setSize(width, height);
    this.occlusion.setSize(width, height);
    for (const light of this.lightTargets) this.sizeLight(light);
  }

  /** Where light `index` is; to be asked for before the G-buffer is drawn. */
  light(index = 0): RenderTarget {
    while (this.lightTargets.length <= index) {
      const made = dataTarget(1, this.gpu.floatBlending ? FloatType : HalfFloatType, this.buffer.depth);
      this.lightTargets.push(made);
      this.sizeLight(made);
    }
    return this.lightTargets[index];
  }

  /** Three clears the depth of a target of a new size when it first draws to it. That of a light is the G-buffer's: after the scene it would be too late. */
  private sizeLight(light: RenderTarget): void {
    light.setSize(this.size.width, this.size.height);
    this.gpu.renderer.setRenderTarget(light);
    this.gpu.renderer.render(new Scene(), new PerspectiveCamera());
  }

  /** Draws the opaque scene into the G-buffer. */
  drawGeometry(subject: GBufferView, camera: PerspectiveCamera): void {
    const { upload, projection } = subject;
    const { renderer } = this.gpu;
    this.view = subject;
    for (const { names, target } of this.buffer.passes) {
      for (const drawable of upload.drawCalls)
        if (!drawable.batch.transparent)
          setMaterial(drawable, `${names[0]} ${projection.event} ${projection.place}`, () =>
            geometryMaterial(drawable, projection, names, renderer.reversedDepthBuffer),
          );
      renderer.setRenderTarget(target);
      renderer.render(upload.opaque, camera);
    }
  }

  /** G-buffer to light, then what is transparent over it. */
  drawLight(
    { upload, projection, settings }: GBufferView,
    camera: PerspectiveCamera,
    lighting: Lighting,
    index = 0,
  ): void {
    const { buffer, uniforms, passes } = this;
    const { environment, scene, atlas } = upload;
    const light = this.light(index);
    const palette = colorVariantOf(settings, scene);
    const optics = this.colorPipelines.pipeline(palette, scene, atlas);
    const shadows = lighting.shadows ? upload.shadows : undefined;
    const owner = upload.serial;
    passes.run(`sky ${palette}`, () => skyPass(environment, uniforms, optics), light, { owner, region: 'sky' });
    if (upload.opaque.children.some((mesh) => mesh.visible)) {
      const openness = lighting.occlusionRadius === 0 ? undefined : this.openness(lighting.occlusionRadius).texture;
      passes.run(
        `light ${palette} ${lighting.shadows} ${openness !== undefined}`,
        () => lightingPass(buffer, environment, uniforms, optics, isMoving(upload), shadows, openness),
        light,
        { owner, region: 'surfaces' },
      );
    }
    if (upload.stars) this.drawOver(light, upload.stars.scene, camera);
    if (upload.transparent.children.every((mesh) => !mesh.visible)) return;
    for (const drawable of upload.drawCalls)
      if (drawable.batch.transparent)
        setMaterial(
          drawable,
          `forward ${projection.event} ${projection.place} ${palette} ${lighting.shadows} ${buffer.depth.id}`,
          () => forwardMaterial(drawable, projection, buffer, upload.environment, optics, shadows),
        );
    this.drawOver(light, upload.transparent, camera);
  }

  /** The share of the sky that each point of what is in the G-buffer sees. `radius`: as `RenderSettings.occlusionRadius`. */
  openness(radius = this.view?.settings.occlusionRadius): RenderTarget {
    if (this.view) {
      const { upload, projection } = this.view;
      const reach = radius ?? upload.radius * OCCLUSION_RADIUS_SHARE;
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
    for (const light of this.lightTargets) light.dispose();
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

const isMoving = ({ bodies }: SceneUpload): boolean => bodies.some(({ object }) => !isStatic(object.motion));

function setMaterial(drawable: DrawCall, key: string, make: () => DrawCall['mesh']['material']): void {
  const material = drawable.materials.get(key) ?? make();
  drawable.materials.set(key, material);
  drawable.mesh.material = material;
}
