import { dot, float, int, vec3, vec4 } from 'three/tsl';
import { sub, type Vec3, ZERO } from '../../../math/vec3.ts';
import { positionAt } from '../../../physics/worldLines/worldLine.ts';
import type { Int, Vec3 as Vector } from '../../../shaders/types.ts';
import type { DrawCall } from '../../gbuffer/drawCall.ts';
import type { Body } from '../../geometry/bodies.ts';
import { type LinearMap, linearMapOf } from '../../geometry/bodies.ts';
import type { VertexInput } from '../../geometry/vertexInput.ts';
import { FloatTable } from '../../gpu/floatTable.ts';
import type { CasterPlacement } from './casterMesh.ts';

/** Slot of what has none of its own, and is drawn where all that is round a light is. */
export const SURROUNDINGS = -2;
/** Texels of a body: rows of its turn with its place, and its slot with its velocity [c]. */
const POSE_TEXELS = 4;

/** Where rigid occluders are, from where a layer's places are measured, and the slot that each has; by the number of a body. */
export class PoseTable {
  private readonly table = new FloatTable(256);

  constructor(bodies: number) {
    this.table.reserve(bodies * POSE_TEXELS);
    this.clear();
  }

  /** None is drawn. */
  clear(): void {
    this.table.values.fill(-1);
  }

  set({ id }: Body, [x, y, z]: LinearMap, place: Vec3, slot: number, beta: Vec3 = ZERO): void {
    const rows = [0, 1, 2].flatMap((k) => [x[k], y[k], z[k], place[k]]);
    this.table.values.set([...rows, slot, ...beta], 4 * POSE_TEXELS * (id - 1));
  }

  /** Uploads where bodies are that rest, from `origin`. */
  setStatic(resting: readonly Body[], drawables: readonly DrawCall[], origin: Vec3): void {
    const worn = new Set(drawables.flatMap(({ batch }) => (batch.instancing ? batch.bodies : [])));
    for (const body of resting) {
      const turn = linearMapOf(body, worn.has(body), 0, 1);
      if (turn) this.set(body, turn, sub(positionAt(body.line, 0, 1), origin), 0);
    }
    this.upload();
  }

  upload(): void {
    this.table.upload();
  }

  /** Slots are layers from `first` on; where `round` is 1, only what is round a light is drawn, on that layer. */
  placement(first: Int, round?: Int): CasterPlacement {
    return ({ object, offset }) => {
      const begin = int(object).mul(int(POSE_TEXELS)).toVar();
      const texel = (k: number) => this.table.texel(begin.add(int(k)));
      const slot = int(texel(3).x).toVar();
      const point = vec4(offset, float(1));
      const own = slot.lessThan(int(0)).select(int(-1), slot.add(first));
      const shared = slot.equal(int(SURROUNDINGS)).select(first, int(-1));
      return {
        layer: round ? round.greaterThan(int(0)).select(shared, own) : own,
        x: () => vec3(dot(texel(0), point), dot(texel(1), point), dot(texel(2), point)),
      };
    };
  }

  /** The velocity of the body that a vertex is of [c]. */
  velocity({ object }: VertexInput): Vector {
    const last = int(object)
      .mul(int(POSE_TEXELS))
      .add(int(POSE_TEXELS - 1));
    return this.table.texel(last).yzw;
  }

  dispose(): void {
    this.table.dispose();
  }
}
