import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { add, cross, dot, length, normalize, scale, sub, type Vec3, ZERO } from '../../src/math/vec3.ts';
import { properVelocity } from '../../src/physics/lorentz/boost.ts';
import { apparentPosition } from '../../src/physics/optics/apparentPosition.ts';
import { simultaneousPosition } from '../../src/physics/worldLines/simultaneity.ts';
import type { Scene } from '../../src/scene/types.ts';
import { lookAtOrientation } from '../../src/scene/view/camera.ts';
import { perspective } from '../../src/scene/view/lenses/perspectiveLens.ts';
import { probeVertices } from '../../src/scene/view/probe.ts';
import type { RenderSettings } from '../../src/scene/view/view.ts';
import { DATA_SETTINGS } from '../gpu/support/dataSettings.ts';
import type { TestView } from './frames.ts';
import { C, LATE_SCENES, OBSERVER_POSITION, T } from './lateScenes.ts';
import { MAX_DISPLACEMENT } from './pixelOracle.ts';
import { allPixels } from './pixels.ts';
import {
  type ComparedScene,
  expectWithinTolerance,
  judgeFrame,
  openComparedScene,
  Report,
  withRasterizers,
} from './visual.ts';

const SIZE = { width: 160, height: 90 };
/** Pixels compared: every fifth of every fifth row. */
const PIXELS = allPixels(SIZE).filter((i) => (i % SIZE.width) % 5 === 2 && Math.floor(i / SIZE.width) % 5 === 2);

const FORWARD = normalize([0.3, 0.1, -0.6]);
/** Bounds [px]: where edges are straight, or too short to bend, only f32 errors remain; otherwise also those of the tessellation. */
const [STRAIGHT, CURVED] = [0.1, MAX_DISPLACEMENT];
const LOOKS: readonly (readonly [string, Partial<RenderSettings>, beta: number, limit: number])[] = [
  ['light-cone', {}, 0, STRAIGHT],
  ['light-cone', {}, 0.9, CURVED],
  ['light-cone', {}, 0.9999, STRAIGHT],
  ['without light delay', { lightDelay: false }, 0.6, CURVED],
  ['without aberration', { aberration: false }, 0.6, STRAIGHT],
  ['simultaneity', { view: 'simultaneity' }, 0.6, STRAIGHT],
  ['galilean', { view: 'galilean' }, 0.6, STRAIGHT],
];

/** A view centred on the first object, which fills most of the picture at any speed. */
function frameOf(scene: Scene, change: Partial<RenderSettings>, beta: number): TestView {
  const settings = { ...DATA_SETTINGS, ...change, speedOfLight: C };
  const u = properVelocity(scale(FORWARD, beta));
  const places = placesOf(scene, u, settings);
  const middle = scale(places.reduce(add, ZERO), 1 / places.length);
  const fovY = Math.min(1.5, 3 * Math.max(...places.map((x) => angle(x, middle))));
  return {
    view: {
      t: T,
      position: OBSERVER_POSITION,
      u,
      orientation: lookAtOrientation(middle, [0, 1, 0]),
      lens: perspective(fovY),
    },
    settings,
  };
}

/** Displayed positions of the first object's vertices, relative to the observer [m]. */
function placesOf({ objects }: Scene, u: Vec3, { view, lightDelay, aberration }: RenderSettings): Vec3[] {
  const events = view === 'light-cone' && !lightDelay ? 'galilean' : view;
  const probes = probeVertices(objects[0], { t: T, position: OBSERVER_POSITION, u }, C, events).filter(
    (p) => p !== undefined,
  );
  const show = view === 'simultaneity' ? simultaneousPosition : apparentPosition;
  const plain = view === 'galilean' || (view === 'light-cone' && !aberration);
  return probes.map(({ position }) =>
    plain ? sub(position, OBSERVER_POSITION) : show(sub(position, OBSERVER_POSITION), u),
  );
}

const angle = (a: Vec3, b: Vec3): number => Math.atan2(length(cross(a, b)), dot(a, b));

const rasterizers = withRasterizers();

describe.each(LATE_SCENES.map((scene) => [scene.name, scene] as const))(
  '%s, at t = 1e4 s and c = 10 m/s',
  (name, scene) => {
    let stage: ComparedScene;
    const report = new Report();
    beforeAll(async () => {
      stage = await openComparedScene(scene, rasterizers);
    });
    afterAll(() => report.print(name));

    it.each(LOOKS)('%s', async (look, change, beta, limit) => {
      const tallies = await judgeFrame(stage, frameOf(scene, change, beta), SIZE, PIXELS);
      report.add(`${look} ${beta} c`, tallies);
      expectWithinTolerance(tallies);
      for (const tally of tallies.values()) {
        expect(tally.wrong).toBe(0);
        expect(tally.displacement.worst).toBeLessThan(limit);
      }
    });
  },
);
