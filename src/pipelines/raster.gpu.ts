import { PreviewRenderer } from '../render/previews.ts';
import { SceneRenderer } from '../render/renderer.ts';
import type { RendererOptions } from '../render/settings.ts';
import type { InteractiveRenderer } from './interactiveRenderer.ts';

/** The rasterizer. Files named *.gpu.ts are excluded from the page's workers (vite.config.ts). */
export async function openRasterRenderer(options: RendererOptions): Promise<InteractiveRenderer> {
  const renderer = await SceneRenderer.create(options);
  return Object.assign(renderer, { createPreviews: () => new PreviewRenderer(renderer) });
}
