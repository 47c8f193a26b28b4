import { add, length, scale, sub, type Vec3 } from '../../../src/math/vec3.ts';
import { boost, properVelocity } from '../../../src/physics/lorentz/boost.ts';
import { apparentPosition, inverseApparentPosition } from '../../../src/physics/optics/apparentPosition.ts';
import { dopplerFactor } from '../../../src/physics/optics/doppler.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { IDENTITY_POSE } from '../../../src/scene/defaults.ts';
import { box, plane } from '../../../src/scene/mesh/primitives.ts';
import type { Mesh, Motion, Scene, SceneObject } from '../../../src/scene/types.ts';
import { lookAtOrientation } from '../../../src/scene/view/camera.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import type { RenderSettings, ViewPoint } from '../../../src/scene/view/view.ts';
import { GREY, lambert, lit } from '../../support/lightKit.ts';

export const WIDTH = 240;
export const HEIGHT = 160;

/** Velocities of body and observer [c]. */
export interface CornerMotion {
  readonly body: Vec3;
  readonly observer: Vec3;
}

/** From the observer to the foot of the wall, in the wall's rest frame. */
const CORNER: Vec3 = [0, -2.6, -4.2];
const WALL = 1;

const moved = (mesh: Mesh, by: Vec3): Mesh => ({ ...mesh, positions: mesh.positions.map((x, i) => x + by[i % 3]) });

/** A floor with a wall, 1 m high and 60 m wide, which move together; the view is the same in their rest frame. */
function cornerScene(body: Vec3): { readonly scene: Scene; readonly start: Vec3; readonly seen: Vec3 } {
  const seen = inverseApparentPosition(CORNER, properVelocity(body));
  const start = add(seen, scale(body, length(seen)));
  const motion: Motion =
    length(body) === 0
      ? { kind: 'static', pose: { ...IDENTITY_POSE, position: start } }
      : { kind: 'uniform', pose: { ...IDENTITY_POSE, position: start }, velocity: body };
  const thing = (mesh: Mesh): Partial<SceneObject> & { mesh: Mesh; material: ReturnType<typeof lambert> } => ({
    mesh,
    material: lambert(0.5),
    motion,
    authoredIn: 'rest',
  });
  const wall = moved(box([60, WALL, 0.5]), [0, WALL / 2, -0.25]);
  const { scene } = lit([thing(plane(60, 60, 'Y')), thing(wall)]);
  return { scene, start, seen };
}

export interface CornerPicture {
  readonly scene: Scene;
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  readonly body: Vec3;
  readonly start: Vec3;
}

export function cornerPicture({ body, observer }: CornerMotion): CornerPicture {
  const { scene, start, seen } = cornerScene(body);
  const u = properVelocity(observer);
  const D = dopplerFactor(seen, u, properVelocity(body));
  const view: ViewPoint = {
    t: 0,
    position: [0, 0, 0],
    u,
    orientation: lookAtOrientation(apparentPosition(seen, u), [0, 1, 0]),
    lens: perspective(2 * Math.atan(Math.min(0.55 / D, 2))),
  };
  return { scene, view, settings: { ...GREY, occlusionRadius: 1000 }, body, start };
}

/** For the floor in front of the wall: each pixel's distance from the wall, in its rest frame, and its occlusion value. */
export async function floorOf(renderer: RasterRenderer, picture: CornerPicture): Promise<[number, number][]> {
  await renderer.setScene(picture.scene);
  renderer.render([picture.view], picture.settings, 1);
  const [place, time, open, object] = await Promise.all(
    (['position', 'emission_time', 'occlusion', 'object'] as const).map((name) => renderer.readAov(name)),
  );
  const found: [number, number][] = [];
  for (let i = 0; i < object.length; i++) {
    if (object[i] !== 1) continue;
    const x: Vec3 = [place[3 * i], place[3 * i + 1], place[3 * i + 2]];
    const [, across, , away] = boost([time[i], ...sub(x, picture.start)], properVelocity(picture.body));
    if (Math.abs(across) < 0.7 && away > 0.15 && away < 1.6) found.push([away, open[i]]);
  }
  return found;
}

/** A strip of sky of height α above the horizon is hidden along the wall: (1 + cos α)/2 of the light remains. */
export const exactOpenness = (away: number): number => (1 + away / Math.hypot(away, WALL)) / 2;

/** The error: mean and 95th percentile. */
export function errorStatistics(points: readonly (readonly [number, number])[]): { mean: number; most: number } {
  const errors = points.map(([away, open]) => Math.abs(open - exactOpenness(away))).sort((a, b) => a - b);
  return { mean: errors.reduce((a, b) => a + b, 0) / errors.length, most: errors[Math.floor(0.95 * errors.length)] };
}

/** Mean unoccluded fraction at several distances from the wall. */
export const profile = (points: readonly (readonly [number, number])[]): number[] =>
  [0.2, 0.4, 0.6, 0.9, 1.2].map((at) => {
    const near = points.filter(([away]) => Math.abs(away - at) < 0.05).map(([, open]) => open);
    return near.reduce((a, b) => a + b, 0) / near.length;
  });

/** At rest, for observers at 0.9 c, and for bodies at 0.9 c. */
export const FLIGHTS: readonly (readonly [string, CornerMotion])[] = [
  ['at rest', { body: [0, 0, 0], observer: [0, 0, 0] }],
  ['for an observer approaching at 0.9 c', { body: [0, 0, 0], observer: [0, 0, -0.9] }],
  ['for an observer passing at 0.9 c', { body: [0, 0, 0], observer: [0.9, 0, 0] }],
  ['for a wall passing at 0.9 c', { body: [-0.9, 0, 0], observer: [0, 0, 0] }],
  ['for a wall moving ahead of the observer, both fast', { body: [0.3, 0.2, -0.6], observer: [-0.5, 0, -0.6] }],
];
