import { type Quat, rotate } from '../../../math/quat.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import { type Frustum, farthestCorner } from '../../../scene/view/lens.ts';
import { frustumSides } from '../../geometry/culling.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { SpacetimeProjection } from '../../geometry/vertexStage.ts';

/** How a picture is looked at, as far as the cutting of edges depends on it. */
export interface TessellationView {
  readonly observation: Observation;
  readonly projection: SpacetimeProjection;
  /** Camera axes (−Z forward, +Y up) against the world axes carried by the pure boost. */
  readonly orientation: Quat;
  readonly frustum: Frustum;
  /** Pixels per unit tangent. */
  readonly focal: number;
  /** How far a straight edge may be from the curve that is seen [px]. */
  readonly tolerance: number;
  /** Most leaves of a picture; where more were needed, the tolerance is doubled until there are not. */
  readonly maxPatches: number;
}

/** What all bodies of a picture are measured by. */
export interface ScreenMetric {
  readonly view: TessellationView;
  /** Inward normals of the picture's sides, and its forward direction. */
  readonly sides: readonly Vec3[];
  readonly forward: Vec3;
  /** That of the look, or more where the budget asks for it [px]. */
  readonly tolerance: number;
  /** 1 + tan² of the angle to the picture's corner. */
  readonly cornerMagnification: number;
}

export function screenMetricOf(look: TessellationView, tolerance: number): ScreenMetric {
  const { orientation, frustum } = look;
  const forward = rotate(orientation, [0, 0, -1]);
  const sides = [...frustumSides(orientation, frustum), forward];
  return { view: look, sides, forward, tolerance, cornerMagnification: cornerMagnification(frustum) };
}

/** 1 + tan² of the angle between the forward axis and the corner farthest from it. */
export function cornerMagnification(frustum: Frustum): number {
  const [across, up] = farthestCorner(frustum);
  return 1 + across * across + up * up;
}
