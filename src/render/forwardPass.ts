import type { PerspectiveCamera, RenderTarget } from 'three/webgpu';
import { type ColorPipelines, colorVariantOf } from './color/colorPipelines.ts';
import { dataTarget, surfaceDepth } from './gbuffer/gbuffer.ts';
import type { Gpu } from './gpu/device.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import { blendedRange, type LightRange } from './gpu/lightRange.ts';
import type { PassCache } from './gpu/passCache.ts';
import { drawOverTarget, type GBufferView, setMaterial } from './opaqueGeometry.ts';
import { depthTestedMaterial, type ForwardLighting, opaqueMaterial, skyPass } from './shading/passes.ts';

/** Forward shading: the light of a surface is computed in the pass that finds its events, without a G-buffer (docs/adr/0054-forward.md). */
export class ForwardPass {
  private readonly gpu: Gpu;
  private readonly range: LightRange;
  private readonly uniforms: FrameUniforms;
  private readonly colorPipelines: ColorPipelines;
  private readonly passes: PassCache;
  private readonly light: RenderTarget;

  constructor(gpu: Gpu, uniforms: FrameUniforms, colorPipelines: ColorPipelines, passes: PassCache) {
    this.gpu = gpu;
    this.range = blendedRange(gpu);
    this.uniforms = uniforms;
    this.colorPipelines = colorPipelines;
    this.passes = passes;
    this.light = dataTarget(1, this.range.type, surfaceDepth());
  }

  setSize(width: number, height: number): void {
    this.light.setSize(width, height);
  }

  /** Draws the light of a view that needs no G-buffer (`shadingOf`). */
  draw({ upload, projection, settings }: GBufferView, camera: PerspectiveCamera): RenderTarget {
    const { gpu, uniforms, range, light } = this;
    const { environment, scene, atlas, serial: owner } = upload;
    const { renderer } = gpu;
    const colorVariant = colorVariantOf(settings, scene);
    const pipeline = this.colorPipelines.pipeline(colorVariant, scene, atlas);
    const shadows = settings.shadows ? upload.shadows : undefined;
    const lit: ForwardLighting = { projection, environment, pipeline, range, ...(shadows && { shadows }) };
    const key = `forward ${projection.event} ${projection.place} ${colorVariant} ${settings.shadows}`;
    for (const drawCall of upload.drawCalls)
      setMaterial(drawCall, key, () => {
        const material = drawCall.batch.transparent ? depthTestedMaterial : opaqueMaterial;
        return material(drawCall, lit, renderer.reversedDepthBuffer);
      });
    renderer.setRenderTarget(light);
    renderer.render(upload.opaque, camera);
    this.passes.run(`sky ${colorVariant}`, () => skyPass(environment, uniforms, pipeline, range), light, {
      ...{ owner, over: true },
      region: 'sky',
    });
    if (upload.transparent.children.some((mesh) => mesh.visible))
      drawOverTarget(gpu, light, upload.transparent, camera);
    return light;
  }

  dispose(): void {
    this.light.dispose();
  }
}
