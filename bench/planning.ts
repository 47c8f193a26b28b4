import { makeBatches } from '../src/render/batches.ts';
import { makeBody } from '../src/render/bodies.ts';
import type { Look } from '../src/render/refine/look.ts';
import { LocalPlanner } from '../src/render/refine/planner.ts';
import { worldObjects } from '../src/render/worldObjects.ts';
import type { Scene } from '../src/scene/types.ts';
import type { Frame } from '../tests/visual/frames.ts';
import type { Size } from '../tests/visual/pixels.ts';
import { interleaved } from './bench.ts';

const ROUNDS = 9;

/** What a processor does to cut one picture of light: clusters and coarse cuts, and with the levels of all leaves, as for WebGL2 [ms]. No budget. */
export async function timesOfPlanning(scene: Scene, { view, settings }: Frame, size: Size): Promise<readonly number[]> {
  const { speedOfLight: c } = settings;
  const bodies = worldObjects(scene, c).map((object, i) => makeBody(object, i + 1));
  const batches = makeBatches({ ...scene, objects: bodies.map((body) => body.object) }, bodies);
  const look = lookOf(view, c, size);
  const works = [false, true].map((levelled) => {
    const planner = new LocalPlanner(batches.map((batch) => ({ batch, levelled })));
    return () => void planner.plan({ look, seen: batches.map(() => true) });
  });
  return interleaved(works, ROUNDS);
}

function lookOf({ t, position, u, orientation, fovY }: Frame['view'], c: number, { width, height }: Size): Look {
  const tanY = Math.tan(fovY / 2);
  return {
    sight: { t, position, u, c, surface: 'past-light-cone' },
    projection: { event: 'emission', place: 'apparent' },
    orientation,
    tanX: (tanY * width) / height,
    tanY,
    focal: height / (2 * tanY),
    tolerance: 0.25,
    budget: Number.POSITIVE_INFINITY,
  };
}
