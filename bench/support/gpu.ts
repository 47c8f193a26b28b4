import { type HeadlessDevice, openDevice } from '../../src/cli/gpu/device.ts';
import { pumpFrame } from '../../src/cli/gpu/nodeShim.ts';
import type { RendererOptions } from '../../src/render/settings.ts';
import { DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../../src/scene/view/view.ts';
import { C, VIEW } from './scenes.ts';

export const SETTINGS: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: C };

/** The GPU device, shared by all benchmarks. */
let opened: Promise<HeadlessDevice> | undefined;
export const gpu = (): Promise<HeadlessDevice> => {
  opened ??= openDevice();
  return opened;
};
export const releaseGpu = async (): Promise<void> => (await opened)?.release();

/** A renderer without a window; imported lazily, after the shim that three needs. */
export async function openRenderer(width: number, height: number, options: RendererOptions = {}) {
  const { device } = await gpu();
  const { SceneRenderer } = await import('../../src/render/renderer.ts');
  const renderer = await SceneRenderer.create({ ...options, device, backend: 'webgpu' });
  renderer.setSize(width, height);
  const frame = async (change: Partial<RenderSettings> = {}, view: Partial<ViewPoint> = {}): Promise<void> => {
    pumpFrame();
    renderer.render([{ ...VIEW, ...view }], { ...SETTINGS, ...change });
    await renderer.readPixels();
  };
  return { renderer, frame };
}
