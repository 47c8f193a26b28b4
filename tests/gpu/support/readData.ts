import type { SceneRenderer } from '../../../src/render/renderer.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';

const NAMES = ['object', 'position', 'emission_time', 'doppler', 'velocity', 'depth'] as const;

/** Data AOVs of one picture as plain arrays, which can be transferred from a page. */
export type Data = Record<(typeof NAMES)[number], ArrayLike<number>>;

export async function readData(renderer: SceneRenderer, view: ViewPoint, settings: RenderSettings): Promise<Data> {
  renderer.render([view], settings);
  const [object, position, emission_time, doppler, velocity, depth] = await Promise.all(
    NAMES.map((name) => renderer.readAov(name)),
  );
  return { object, position, emission_time, doppler, velocity, depth };
}
