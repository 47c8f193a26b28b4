import { uniform } from 'three/tsl';
import { Matrix3, Vector2, Vector4 } from 'three/webgpu';
import { toMatrix } from '../../../math/quat.ts';
import { sub } from '../../../math/vec3.ts';
import type { Frustum } from '../../../scene/view/lenses/perspectiveLens.ts';
import type { ViewPoint } from '../../../scene/view/view.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { SpacetimeProjection } from '../../geometry/vertexStage.ts';
import { makeObserverUniforms, setObserverUniforms } from '../../gpu/observerUniforms.ts';

/** The observation, camera and projection that a picture was drawn with. */
export interface ViewState {
  readonly observation: Observation;
  readonly viewPoint: ViewPoint;
  readonly projection: SpacetimeProjection;
  readonly frustum: Frustum;
}

/** Uniforms of the previous picture's view, which temporalAntialiasing.ts reads beside those of the current picture. */
export class PreviousView {
  readonly observer = makeObserverUniforms();
  /** World axes carried by its boost → camera axes. */
  readonly toCamera = uniform(new Matrix3());
  readonly halfTangents = uniform(new Vector2(1, 1));
  readonly frustumCenter = uniform(new Vector2());
  /** From its observer event to that of this picture: (Δx [m], cΔt [m of light]), computed in f64. */
  readonly displacement = uniform(new Vector4());
  /** 1 if the previous picture can be reprojected, otherwise 0. */
  readonly isValid = uniform(0);
  private last: ViewState | undefined;

  /** Sets the uniforms for a picture of this view, which becomes the previous one. */
  update(state: ViewState): void {
    const { last } = this;
    const isValid =
      last !== undefined &&
      last.observation.c === state.observation.c &&
      isSameProjection(last.projection, state.projection);
    this.isValid.value = isValid ? 1 : 0;
    if (isValid) this.store(last, state.observation);
    this.last = state;
  }

  private store({ observation, viewPoint, frustum }: ViewState, now: Observation): void {
    setObserverUniforms(this.observer, observation, viewPoint.vantage);
    this.toCamera.value.fromArray([...toMatrix(viewPoint.orientation)]);
    this.halfTangents.value.set(frustum.tanX, frustum.tanY);
    this.frustumCenter.value.set(...frustum.center);
    this.displacement.value.set(...sub(now.position, observation.position), now.c * (now.t - observation.t));
  }

  /** The next picture will have no previous one. */
  reset(): void {
    this.last = undefined;
  }
}

const isSameProjection = (a: SpacetimeProjection, b: SpacetimeProjection): boolean =>
  a.event === b.event && a.place === b.place;
