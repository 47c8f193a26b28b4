import { lerp, type Vec3, ZERO } from '../../math/vec3.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { boundingBox } from '../bounds/bounds.ts';
import type { SceneObject } from '../types.ts';
import { deforms, vertexWorldLine } from './motion.ts';

/**
 * The world line that stands for an object: of the middle of its bounding box, carried by its frame; of a deforming object of
 * the vertex nearest to that middle. c [m/s].
 */
export function middleWorldLine(object: SceneObject, c: number): WorldLine {
  const { mesh } = object;
  const middle = middleOf(mesh.positions);
  return deforms(object.motion)
    ? vertexWorldLine(object, nearestVertex(mesh.positions, middle), c)
    : vertexWorldLine({ ...object, mesh: { ...mesh, positions: Float32Array.from(middle) } }, 0, c);
}

function middleOf(positions: Float32Array): Vec3 {
  const box = boundingBox(positions);
  return box ? lerp(box.min, box.max, 0.5) : ZERO;
}

function nearestVertex(positions: Float32Array, [x, y, z]: Vec3): number {
  let [best, least] = [0, Number.POSITIVE_INFINITY];
  for (let i = 0; i < positions.length / 3; i++) {
    const d = Math.hypot(positions[3 * i]! - x, positions[3 * i + 1]! - y, positions[3 * i + 2]! - z);
    if (d < least) [best, least] = [i, d];
  }
  return best;
}
