import { fromAxisAngle, IDENTITY } from '../../../src/math/quat.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import { makeMesh } from '../../../src/scene/mesh/makeMesh.ts';
import { box, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import type { Scene } from '../../../src/scene/types.ts';

/** Relative distance of the two sheets, and the viewing distances [m]. */
const GAP = 3e-5;
export const DISTANCES = [0.01, 1, 100, 1e4, 1e6] as const;

/** Half a millimetre across, its front `distance` from the origin along −Z [m]. */
const speck = (name: string, distance: number): Scene =>
  makeScene({
    name,
    objects: [makeObject({ path: '/speck', mesh: box([5e-4, 5e-4, 5e-4]), motion: restingAt([0, 0, -distance]) })],
  });

/** Two parallel slanted sheets that fill the picture; the nearer one is drawn first, so that equal depths show the other. */
function sheets(distance: number): Scene {
  const orientation = fromAxisAngle([1, 0, 0], 0.5);
  const sheet = (path: string, away: number) =>
    makeObject({
      path,
      mesh: plane(8 * distance, 8 * distance),
      motion: { kind: 'static', pose: { position: [0, 0, -away], orientation } },
    });
  return makeScene({
    name: `sheets at ${distance} m`,
    objects: [sheet('/near', distance), sheet('/far', distance * (1 + GAP))],
  });
}

/** The observer's height above the floor [m]. */
export const HEIGHT = 1.5;
/**
 * Corners of the floor [m, along X and Z]: one triangle with two corners in front of the camera and one behind. Not far away, because
 * SwiftShader rounds them to 1/16 pixel, which would tilt a plane whose corners are a tenth of a pixel below the horizon.
 */
export const FLOOR = [
  [-40, -15],
  [8, 30],
  [40, -20],
] as const;

const floor = makeMesh({
  points: FLOOR.flatMap(([x, z]): Vec3 => [x, -HEIGHT, z]),
  faceCounts: [3],
  faceIndices: [0, 1, 2],
}).mesh;

/** Behind an observer at the origin looking along −Z, at 120° from the view direction. */
export const BEHIND: Vec3 = [10 * Math.sin((2 * Math.PI) / 3), 0, 5];

/** A ball of the fewest segments: where its centre is at t = 0, its radius [m], and its velocity [c]. */
export interface Ball {
  readonly name: string;
  readonly center: Vec3;
  readonly radius: number;
  readonly velocity: Vec3;
}

export const BALLS: readonly Ball[] = [
  { name: 'ball at rest', center: [0.3, 0.2, -5], radius: 1.8, velocity: [0, 0, 0] },
  { name: 'ball at the nose', center: [0.2, -14, -5], radius: 14, velocity: [0, 0, 0] },
  { name: 'ball passing at 0.9 c', center: [4, 0, -5], radius: 1.5, velocity: [0.9, 0, 0] },
  { name: 'ball fleeing at 0.9 c', center: [0.3, 0, -10], radius: 2, velocity: [0, 0.1, -0.89] },
];

const ballScene = ({ name, center, radius, velocity }: Ball): Scene =>
  makeScene({
    name,
    objects: [
      makeObject({
        path: '/ball',
        mesh: sphere(radius, { segments: 20 }),
        authoredIn: 'rest',
        motion: { kind: 'uniform', pose: { position: center, orientation: fromAxisAngle([1, 0, 0], 1) }, velocity },
      }),
    ],
  });

export const DEPTH_SCENES: readonly Scene[] = [
  ...BALLS.map(ballScene),
  speck('speck in front', 2.25e-3),
  speck('speck behind', -2.25e-3),
  makeScene({
    name: 'speck before a wall',
    objects: [
      makeObject({ path: '/speck', mesh: box([5e-4, 5e-4, 5e-4]), motion: restingAt([0, 0, -2.25e-3]) }),
      makeObject({
        path: '/wall',
        mesh: plane(1e7, 1e7),
        motion: { kind: 'static', pose: { position: [0, 0, -1e6], orientation: IDENTITY } },
      }),
    ],
  }),
  makeScene({ name: 'floor', objects: [makeObject({ path: '/floor', mesh: floor })] }),
  makeScene({ name: 'behind', objects: [makeObject({ path: '/ball', mesh: sphere(1), motion: restingAt(BEHIND) })] }),
  ...DISTANCES.map(sheets),
];
