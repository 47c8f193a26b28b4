import type { PerspectiveCamera, RenderTarget, Scene } from 'three/webgpu';
import type { RenderSettings } from '../scene/view/view.ts';
import type { DrawCall } from './gbuffer/drawCall.ts';
import type { GBuffer } from './gbuffer/gbuffer.ts';
import type { SpacetimeProjection } from './geometry/vertexStage.ts';
import type { Gpu } from './gpu/device.ts';
import type { SceneUpload } from './sceneUpload.ts';
import { geometryMaterial } from './shading/passes.ts';

/** What a G-buffer is drawn of. */
export interface GBufferView {
  readonly upload: SceneUpload;
  readonly projection: SpacetimeProjection;
  readonly settings: RenderSettings;
}

/** Draws the opaque scene into a G-buffer. `over`: over what it holds. */
export function drawOpaque(
  { renderer }: Gpu,
  { upload, projection }: GBufferView,
  buffer: GBuffer,
  camera: PerspectiveCamera,
  over = false,
): void {
  renderer.autoClear = !over;
  for (const { names, target } of buffer.passes) {
    for (const drawCall of upload.drawCalls)
      if (!drawCall.batch.transparent)
        setMaterial(drawCall, `${names[0]} ${projection.event} ${projection.place}`, () =>
          geometryMaterial(drawCall, projection, names, renderer.reversedDepthBuffer),
        );
    renderer.setRenderTarget(target);
    renderer.render(upload.opaque, camera);
  }
  renderer.autoClear = true;
}

/** Draws without clearing the target. */
export function drawOverTarget({ renderer }: Gpu, target: RenderTarget, scene: Scene, camera: PerspectiveCamera): void {
  renderer.autoClear = false;
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  renderer.autoClear = true;
}

export function setMaterial(drawCall: DrawCall, key: string, make: () => DrawCall['mesh']['material']): void {
  const material = drawCall.materials.get(key) ?? make();
  drawCall.materials.set(key, material);
  drawCall.mesh.material = material;
}
