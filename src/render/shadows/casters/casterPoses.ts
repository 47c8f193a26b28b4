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

/** Slot of bodies without a tile of their own: they are drawn only on the tiles round a light. */
export const SURROUNDINGS = -2;
/** Texels per body: three rows of its linear map with its place, then its slot with its velocity [c]. */
const POSE_TEXELS = 4;

/** Poses of rigid occluders relative to a layer's origin, and their slots, by the number of the body. */
export class PoseTable {
  private readonly table = new FloatTable(256);

  constructor(bodies: number) {
    this.table.reserve(bodies * POSE_TEXELS);
    this.clear();
  }

  /** Draws no body until it is set again. */
  clear(): void {
    this.table.values.fill(-1);
  }

  set({ id }: Body, [x, y, z]: LinearMap, place: Vec3, slot: number, beta: Vec3 = ZERO): void {
    const rows = [0, 1, 2].flatMap((k) => [x[k], y[k], z[k], place[k]]);
    this.table.values.set([...rows, slot, ...beta], 4 * POSE_TEXELS * (id - 1));
  }

  /** Uploads the poses of bodies at rest, relative to `origin`. */
  setStatic(resting: readonly Body[], drawCalls: readonly DrawCall[], origin: Vec3): void {
    const instanced = new Set(drawCalls.flatMap(({ batch }) => (batch.instancing ? batch.bodies : [])));
    for (const body of resting) {
      const linearMap = linearMapOf(body, instanced.has(body), 0, 1);
      if (linearMap) this.set(body, linearMap, sub(positionAt(body.line, 0, 1), origin), 0);
    }
    this.upload();
  }

  upload(): void {
    this.table.upload();
  }

  /** The layer is `first` plus the slot. Where `drawsSurroundings` is 1, only bodies with the slot `SURROUNDINGS` are drawn, on layer `first`. */
  placement(first: Int, drawsSurroundings?: Int): CasterPlacement {
    return ({ object, offset }) => {
      const begin = int(object).mul(int(POSE_TEXELS)).toVar();
      const texel = (k: number) => this.table.texel(begin.add(int(k)));
      const slot = int(texel(3).x).toVar();
      const point = vec4(offset, float(1));
      const own = slot.lessThan(int(0)).select(int(-1), slot.add(first));
      const shared = slot.equal(int(SURROUNDINGS)).select(first, int(-1));
      return {
        layer: drawsSurroundings ? drawsSurroundings.greaterThan(int(0)).select(shared, own) : own,
        x: () => vec3(dot(texel(0), point), dot(texel(1), point), dot(texel(2), point)),
      };
    };
  }

  /** The velocity of a vertex's body [c]. */
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
