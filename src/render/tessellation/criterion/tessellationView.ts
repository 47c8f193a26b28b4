import { type Quat, rotate } from '../../../math/quat.ts';
import { type Vec3, ZERO } from '../../../math/vec3.ts';
import { type Frustum, farthestCorner } from '../../../scene/view/lenses/perspectiveLens.ts';
import { frustumSides } from '../../geometry/culling.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { SpacetimeProjection } from '../../geometry/vertexStage.ts';

/** A view, as far as tessellation depends on it. */
export interface TessellationView {
  readonly observation: Observation;
  readonly projection: SpacetimeProjection;
  /** Camera axes (−Z forward, +Y up) against the world axes carried by the pure boost. */
  readonly orientation: Quat;
  /** As in `ViewPoint`: from the observer to the camera [m]. */
  readonly vantage?: Vec3;
  readonly frustum: Frustum;
  /** Pixels per unit tangent. */
  readonly focal: number;
  /** Largest distance of a straight edge from the curve that it approximates [px]. */
  readonly tolerance: number;
  /** Most patches of a view; the tolerance is doubled until they suffice. */
  readonly maxPatches: number;
}

/** What a view's edges are measured with. */
export interface ScreenMetric {
  readonly view: TessellationView;
  /** Inward normals of the frustum's sides and the forward direction, and that direction by itself. */
  readonly sides: readonly Vec3[];
  readonly forward: Vec3;
  /** From the observer to the camera [m]. */
  readonly vantage: Vec3;
  /** The view's, or more to stay within the patch budget [px]. */
  readonly tolerance: number;
  /** 1 + tan² of the angle to the picture's corner. */
  readonly cornerMagnification: number;
}

export function screenMetricOf(view: TessellationView, tolerance: number): ScreenMetric {
  const { orientation, frustum, vantage = ZERO } = view;
  const forward = rotate(orientation, [0, 0, -1]);
  const sides = [...frustumSides(orientation, frustum), forward];
  return { view, sides, forward, vantage, tolerance, cornerMagnification: cornerMagnification(frustum) };
}

/** 1 + tan² of the angle between the forward axis and the corner farthest from it. */
export function cornerMagnification(frustum: Frustum): number {
  const [right, up] = farthestCorner(frustum);
  return 1 + right * right + up * up;
}
