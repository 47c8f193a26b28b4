import { blendedSkin, jointPoses, ONE_JOINT } from '../../src/formats/read/blendedSkin.ts';
import { fromParts, type Mat4, multiply } from '../../src/math/mat4.ts';
import { fromAxisAngle, toMatrix } from '../../src/math/quat.ts';
import { makeObject, makeScene, restingAt } from '../../src/scene/defaults.ts';
import { flippedWinding } from '../../src/scene/mesh/meshOps.ts';
import { box } from '../../src/scene/mesh/primitives.ts';
import {
  type BlendedPoints,
  MATRIX,
  makeBlendedPoints,
  transformBlendedPoints,
  translateBlendedPoints,
} from '../../src/scene/streaming/blendedPoints.ts';
import type { Mesh, Scene, SceneObject } from '../../src/scene/types.ts';
import { blendedArm } from './blendedArm.ts';

/** Samples between which joints turn by at most 0.03 rad. */
const TIMES = Float64Array.from({ length: 241 }, (_, k) => -0.5 + k / 80);

/** Objects that follow joints in all ways that a scene has: two at one skeleton, mirrored and stretched, flown, with incomplete weights, squashed as a whole. */
export function skinnedScene(parts: Partial<Scene> = {}): Scene {
  const { mesh, motion } = blendedArm(TIMES, [3, 1, -2], 8);
  const { points, origin } = motion;
  const made = (path: string, own: BlendedPoints, of: Mesh = mesh, times = TIMES): SceneObject =>
    makeObject({
      path,
      mesh: { ...of, positions: makeBlendedPoints(own, 0) },
      motion: { kind: 'sampled-points', times, origin, points: own },
    });
  const stretch: Mat4 = [-1.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1];
  const mirror = multiply(turn([0, 1, 1], 0.7), stretch);
  const sleeve = multiply(turn([1, 2, 0], 1.1), fromParts([1.2, 0, 0, 0, 1.2, 0, 0, 0, 1.2], [0.1, 0, 0.3]));
  const flight = Float64Array.from({ length: 3 * TIMES.length }, (_, i) => [0, 4, 1][i % 3] * TIMES[Math.floor(i / 3)]);
  const order = Array.from(TIMES.keys());
  const objects = [
    made('/Crowd/Arm', points),
    makeObject({ path: '/Crowd/Arm/Ball', mesh: box([1, 1, 1]), motion: restingAt([0, 0, 5]) }),
    made('/Crowd/Sleeve', {
      ...points,
      binds: Float64Array.from(bindsOf(points).flatMap((m) => multiply(m, sleeve).slice(0, MATRIX))),
    }),
    made('/Mirrored', transformBlendedPoints(points, mirror), { ...mesh, indices: flippedWinding(mesh.indices) }),
    made('/Flown/Arm', translateBlendedPoints(points, order, flight)),
    incomplete(made, points),
    squashed(),
  ];
  return makeScene({ name: 'skins', startTime: TIMES[0], endTime: TIMES[TIMES.length - 1], objects, ...parts });
}

const turn = (axis: readonly [number, number, number], angle: number): Mat4 =>
  fromParts(toMatrix(fromAxisAngle(axis, angle)), [0, 0, 0]);

/** By joint, its bind matrix. */
const bindsOf = ({ binds }: BlendedPoints): Mat4[] =>
  Array.from({ length: binds.length / MATRIX }, (_, j) => [
    ...binds.subarray(MATRIX * j, MATRIX * (j + 1)),
    0,
    0,
    0,
    1,
  ]);

/** A tenth of each weight is missing. */
function incomplete(made: (path: string, own: BlendedPoints) => SceneObject, points: BlendedPoints): SceneObject {
  const { poses, rest, shapes, shapeWeights } = points;
  const vertices = rest.positions.length / 3;
  const own = blendedSkin({
    poses,
    rest,
    shapes,
    shapeWeights,
    origin: [3, 1, -2],
    binds: bindsOf(points),
    skin: {
      perPoint: 2,
      joints: Uint16Array.from({ length: 2 * vertices }, (_, i) => i % 2),
      weights: new Float32Array(2 * vertices).fill(0.45),
    },
  });
  return made('/Crowd/Incomplete', own);
}

/** A box whose frame turns, and shrinks to nothing and grows again. */
function squashed(): SceneObject {
  const mesh = box([1, 2, 3]);
  const poses = jointPoses(TIMES.length, ONE_JOINT, (k, out) => {
    const size = Math.abs(TIMES[k] - 1);
    const m = multiply(turn([0, 0, 1], 2 * TIMES[k]), fromParts([size, 0, 0, 0, 1, 0, 0, 0, size], [0, 0, TIMES[k]]));
    out.set(m.slice(0, MATRIX));
  });
  const points = blendedSkin({ rest: mesh, shapes: [], shapeWeights: new Float64Array(0), poses, origin: [0, 0, 0] });
  return makeObject({
    path: '/Squashed',
    mesh: { ...mesh, positions: makeBlendedPoints(points, 0) },
    motion: { kind: 'sampled-points', times: TIMES, origin: [0, 0, 0], points },
  });
}
