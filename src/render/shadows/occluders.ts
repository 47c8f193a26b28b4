import type { Vec3 } from '../../math/vec3.ts';
import type { Material } from '../../scene/types.ts';
import type { DrawCall } from '../gbuffer/drawCall.ts';
import type { Body } from '../geometry/bodies.ts';
import type { ObjectTables } from '../geometry/objectRows.ts';
import type { ShadowDetail } from './shadowDetail.ts';

/** What may be between a light and a surface. */
export interface Occluders {
  readonly bodies: readonly Body[];
  /** Draw calls of whole batches. */
  readonly drawCalls: readonly DrawCall[];
  readonly materials: readonly Material[];
  readonly points: ObjectTables['points'];
  readonly detail: ShadowDetail;
  /** Radius of the scene [m]. */
  readonly radius: number;
}

/** Unit vector to the light, and the radius of its disc [rad]. */
export interface ShadowedDistantLight {
  readonly direction: Vec3;
  readonly radius: number;
}
