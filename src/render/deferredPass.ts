import { vec4 } from 'three/tsl';
import { PerspectiveCamera, type RenderTarget, Scene, type Texture } from 'three/webgpu';
import { isStatic } from '../scene/motion/motion.ts';
import type { RenderSettings } from '../scene/view/view.ts';
import type { Capture } from './capture/capture.ts';
import { type ColorPipelines, colorVariantOf } from './color/colorPipelines.ts';
import { dataTarget, GBuffer } from './gbuffer/gbuffer.ts';
import type { Gpu } from './gpu/device.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import { blendedRange, type LightRange } from './gpu/lightRange.ts';
import type { PassCache } from './gpu/passCache.ts';
import type { LayeredPass } from './layers/layeredScene.ts';
import { AmbientOcclusion } from './occlusion/ambientOcclusion.ts';
import { drawOpaque, drawOverTarget, type GBufferView, setMaterial } from './opaqueGeometry.ts';
import type { SceneUpload } from './sceneUpload.ts';
import { backgroundPass, glassBackground } from './shading/glassBackground.ts';
import { type ForwardLighting, lightingPass, skyPass, transparentMaterial } from './shading/passes.ts';

/** Default radius of ambient occlusion, as a fraction of the scene's radius. */
const RELATIVE_OCCLUSION_RADIUS = 1 / 4;

/** The view of a G-buffer, of which a capture may show a part. */
export interface CapturedGBufferView extends GBufferView {
  readonly capture?: Capture;
}

/** Settings in which several lights of one G-buffer may differ. */
export type Lighting = Pick<RenderSettings, 'shadows' | 'occlusionRadius'>;

/** A light of one of a picture's G-buffers. */
export interface BufferLight {
  readonly buffer: number;
  /** Among the lights of its G-buffer. */
  readonly index: number;
  readonly lighting: Lighting;
}

/** Deferred shading: a G-buffer and the light that is computed from it. */
export class DeferredPass {
  readonly buffer: GBuffer;
  private readonly gpu: Gpu;
  private readonly range: LightRange;
  private readonly uniforms: FrameUniforms;
  private readonly colorPipelines: ColorPipelines;
  private readonly passes: PassCache;
  private readonly occlusion: AmbientOcclusion;
  /** One G-buffer may be lit several times, for example with and without shadows. */
  private readonly lightTargets: RenderTarget[] = [];
  /** Made when something is seen through glass. */
  private background: RenderTarget | undefined;
  private size = { width: 1, height: 1 };
  /** What the G-buffer was drawn of; undefined if its occlusion is not known. */
  private occluded: GBufferView | undefined;
  /** Whether anything opaque may be in the G-buffer. */
  private hasSurfaces = false;

  constructor(gpu: Gpu, uniforms: FrameUniforms, colorPipelines: ColorPipelines, passes: PassCache) {
    this.gpu = gpu;
    this.range = blendedRange(gpu);
    this.uniforms = uniforms;
    this.colorPipelines = colorPipelines;
    this.passes = passes;
    this.buffer = new GBuffer(gpu.maxBytesPerSample, gpu.maxAttachments);
    this.occlusion = new AmbientOcclusion(gpu, this.buffer, uniforms);
  }

  setSize(width: number, height: number): void {
    this.size = { width, height };
    this.buffer.setSize(width, height);
    this.occlusion.setSize(width, height);
    for (const light of this.lightTargets) this.sizeLight(light);
    this.background?.setSize(width, height);
  }

  /** The target of light `index`. Call it before the G-buffer is drawn: `sizeLight` clears the shared depth. */
  light(index = 0): RenderTarget {
    while (this.lightTargets.length <= index) {
      const target = dataTarget(1, this.range.type, this.buffer.depth);
      this.lightTargets.push(target);
      this.sizeLight(target);
    }
    return this.lightTargets[index];
  }

  /** Renders an empty scene, because three.js clears the depth of a resized target at its first draw, and the depth is shared with the G-buffer. */
  private sizeLight(light: RenderTarget): void {
    light.setSize(this.size.width, this.size.height);
    this.gpu.renderer.setRenderTarget(light);
    this.gpu.renderer.render(new Scene(), new PerspectiveCamera());
  }

  /** Fills the G-buffer: with the opaque scene, or with what a capture shows and over it with what that does not hold. */
  drawGeometry(view: CapturedGBufferView, camera: PerspectiveCamera): void {
    const { capture, upload } = view;
    this.occluded = view;
    capture?.show(view, this.buffer);
    const hasGeometry = upload.opaque.children.some((mesh) => mesh.visible);
    if (!capture || hasGeometry) drawOpaque(this.gpu, view, this.buffer, camera, capture !== undefined);
    this.hasSurfaces = capture !== undefined || hasGeometry;
  }

  /** Computes the light of the G-buffer, then blends stars and transparent objects over it. */
  drawLight(
    { upload, projection, settings }: GBufferView,
    camera: PerspectiveCamera,
    lighting: Lighting,
    index = 0,
  ): void {
    const { buffer, uniforms, passes, range } = this;
    const { environment, scene, atlas } = upload;
    const light = this.light(index);
    const colorVariant = colorVariantOf(settings, scene);
    const optics = this.colorPipelines.pipeline(colorVariant, scene, atlas);
    const shadows = lighting.shadows ? upload.shadows : undefined;
    const owner = upload.serial;
    passes.run(`sky ${colorVariant}`, () => skyPass(environment, uniforms, optics, range), light, {
      owner,
      region: 'sky',
    });
    const key = `${projection.event} ${projection.place} ${colorVariant} ${lighting.shadows} ${buffer.depth.id}`;
    const lit: ForwardLighting = { projection, environment, pipeline: optics, range, ...(shadows && { shadows }) };
    const layeredPass: LayeredPass = { ...lit, key, buffer };
    if (this.hasSurfaces) {
      const openness = lighting.occlusionRadius === 0 ? undefined : this.openness(lighting.occlusionRadius).texture;
      passes.run(
        `light ${buffer.depth.id} ${colorVariant} ${lighting.shadows} ${openness !== undefined}`,
        () => lightingPass(buffer, environment, uniforms, optics, isMoving(upload), shadows, openness, range),
        light,
        { owner, region: 'surfaces' },
      );
      upload.layered?.drawSurfaces(
        { ...layeredPass, key: `${key} ${openness !== undefined}`, ...(openness && { openness }) },
        (layers) => drawOverTarget(this.gpu, light, layers, camera),
      );
    }
    if (upload.stars) drawOverTarget(this.gpu, light, upload.stars.scene, camera);
    if (upload.transparent.children.every((mesh) => !mesh.visible)) return;
    const isGlass = upload.drawCalls.some(({ batch, mesh }) => batch.layered?.transmission && mesh.visible);
    const background = isGlass ? this.copyBackground(light) : light.texture;
    for (const drawCall of upload.drawCalls) {
      const { transparent, layered } = drawCall.batch;
      if (!transparent) continue;
      if (layered && upload.layered)
        setMaterial(drawCall, `glass ${key} ${background.id}`, () =>
          upload.layered!.glassMaterial(drawCall, layeredPass, background),
        );
      else setMaterial(drawCall, `forward ${key}`, () => transparentMaterial(drawCall, lit, buffer));
    }
    drawOverTarget(this.gpu, light, upload.transparent, camera);
  }

  /** The light so far, which is seen through glass. */
  private copyBackground({ texture }: RenderTarget): Texture {
    const background = this.background ?? glassBackground(this.size);
    this.background = background;
    this.passes.run(`background ${texture.id}`, () => backgroundPass(texture), background);
    return background.texture;
  }

  /** Says that the G-buffer is gathered from faces, at whose edges occlusion on the screen ends: its openness is 1. */
  setGathered(): void {
    this.occluded = undefined;
  }

  /** Draws the G-buffer's ambient occlusion: the unoccluded fraction of the sky. `radius`: as `RenderSettings.occlusionRadius`. */
  openness(radius = this.occluded?.settings.occlusionRadius): RenderTarget {
    if (!this.occluded) this.passes.run('open', () => vec4(1), this.occlusion.target);
    else {
      const { upload, projection } = this.occluded;
      this.occlusion.draw({
        place: projection.place,
        moving: isMoving(upload),
        radius: radius ?? upload.radius * RELATIVE_OCCLUSION_RADIUS,
      });
    }
    return this.occlusion.target;
  }

  /** The texture that `openness` draws into. */
  get opennessTexture(): Texture {
    return this.occlusion.texture;
  }

  dispose(): void {
    this.buffer.dispose();
    this.occlusion.dispose();
    for (const light of this.lightTargets) light.dispose();
    this.background?.dispose();
  }
}

const isMoving = ({ bodies }: SceneUpload): boolean => bodies.some(({ object }) => !isStatic(object.motion));
