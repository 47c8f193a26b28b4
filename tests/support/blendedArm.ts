import { blendedSkin, jointPoses } from '../../src/formats/read/blendedSkin.ts';
import { fromPose, type Mat4, multiply } from '../../src/math/mat4.ts';
import { fromAxisAngle } from '../../src/math/quat.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { capsule } from '../../src/scene/mesh/primitives.ts';
import { type BlendedPoints, MATRIX } from '../../src/scene/streaming/blendedPoints.ts';
import type { Mesh, SampledPointsMotion } from '../../src/scene/types.ts';

const at = (position: Vec3, axis: Vec3 = [1, 0, 0], angle = 0): Mat4 =>
  fromPose({ position, orientation: fromAxisAngle(axis, angle) });

export interface BlendedArm {
  readonly mesh: Mesh;
  readonly motion: SampledPointsMotion & { readonly points: BlendedPoints };
  /** By joint at a time, from the rest shape to the world: what the motion has at its times. */
  readonly jointsAt: (t: number) => readonly Mat4[];
  /** Weight of the one blend shape. */
  readonly shapeAt: (t: number) => number;
  /** Of each vertex, for the second joint; the first has the rest. */
  readonly bend: Float32Array;
  /** The blend shape's displacement of a vertex. */
  readonly bulge: (vertex: number) => Vec3;
}

/** An arm along z that waves about its middle, travels, and swells: two joints, smooth weights, one blend shape. */
export function blendedArm(times: Float64Array, origin: Vec3 = [0, 0, 0], segments = 16): BlendedArm {
  const mesh = capsule(0.3, 2, { segments });
  const vertices = mesh.positions.length / 3;
  const bend = Float32Array.from({ length: vertices }, (_, v) =>
    Math.min(1, Math.max(0, mesh.positions[3 * v + 2] + 0.5)),
  );
  const frames = (t: number): readonly Mat4[] => {
    const root = at([origin[0] + 0.1 * t, origin[1] + 0.2 * Math.sin(t), origin[2]], [0, 1, 0], 0.3 * t);
    return [root, multiply(root, at([0, 0, 0.1], [1, 0.2, 0], 1.2 * Math.sin(2 * t)))];
  };
  const binds = [at([0, 0, 0]), at([0, 0, -0.1])];
  const shapeAt = (t: number): number => Math.max(0, 0.4 * Math.sin(1.5 * t));
  const bulge = (v: number): Vec3 => [mesh.positions[3 * v], mesh.positions[3 * v + 1], 0.1];
  const points = blendedSkin({
    rest: mesh,
    shapes: [
      {
        positions: Float32Array.from(mesh.positions, (_, i) => bulge(Math.floor(i / 3))[i % 3]),
        normals: new Float32Array(3 * vertices),
      },
    ],
    shapeWeights: times.slice().map(shapeAt),
    skin: {
      perPoint: 2,
      joints: Uint16Array.from({ length: 2 * vertices }, (_, i) => i % 2),
      weights: Float32Array.from({ length: 2 * vertices }, (_, i) => (i % 2 ? bend[i >> 1] : 1 - bend[i >> 1])),
    },
    binds,
    poses: jointPoses(times.length, { names: ['Upper', 'Lower'], parents: [-1, 0] }, (k, out) => {
      frames(times[k]).forEach((m, j) => {
        out.set(m.slice(0, MATRIX), MATRIX * j);
      });
    }),
    origin,
  });
  return {
    mesh,
    motion: { kind: 'sampled-points', times, origin, points },
    jointsAt: (t) => frames(t).map((m, j) => multiply(m, binds[j])),
    shapeAt,
    bend,
    bulge,
  };
}
