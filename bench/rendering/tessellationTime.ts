import { makeBatches } from '../../src/render/geometry/batches.ts';
import { makeBody } from '../../src/render/geometry/bodies.ts';
import { worldObjects } from '../../src/render/geometry/worldObjects.ts';
import type { TessellationView } from '../../src/render/tessellation/criterion/tessellationView.ts';
import { LocalPlanner } from '../../src/render/tessellation/plan/planner.ts';
import type { Scene } from '../../src/scene/types.ts';
import { perspectiveOf } from '../../src/scene/view/lenses/lenses.ts';
import { frustumOf, pixelsPerTangent } from '../../src/scene/view/lenses/perspectiveLens.ts';
import type { TestView } from '../../tests/visual/frames.ts';
import type { Size } from '../../tests/visual/pixels.ts';
import { interleaved } from '../support/bench.ts';

const ROUNDS = 9;

/** CPU time to plan the tessellation of one light-cone picture: clusters and patches, and with the factors of all patches, as for WebGL2 [ms]. Without a budget. */
export async function tessellationTimes(
  scene: Scene,
  { view, settings }: TestView,
  size: Size,
): Promise<readonly number[]> {
  const { speedOfLight: c } = settings;
  const bodies = worldObjects(scene, c).map((object, i) => makeBody(object, i + 1));
  const batches = makeBatches({ ...scene, objects: bodies.map((body) => body.object) }, bodies);
  const tessellationView = tessellationViewOf(view, c, size);
  const works = [false, true].map((needsFactors) => {
    const planner = new LocalPlanner(batches.map((batch) => ({ batch, needsFactors })));
    return () => void planner.plan({ viewIndex: 0, view: tessellationView, visible: batches.map(() => true) });
  });
  return interleaved(works, ROUNDS);
}

function tessellationViewOf(
  { t, position, u, orientation, lens }: TestView['view'],
  c: number,
  { width, height }: Size,
): TessellationView {
  const frustum = frustumOf(perspectiveOf(lens), width, height);
  return {
    observation: { t, position, u, c, hypersurface: 'past-light-cone', coneSlope: 1 },
    projection: { event: 'emission', place: 'apparent' },
    orientation,
    frustum,
    focal: pixelsPerTangent(frustum, width, height),
    tolerance: 0.25,
    maxPatches: Number.POSITIVE_INFINITY,
  };
}
