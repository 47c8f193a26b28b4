import { uniform } from 'three/tsl';
import { Matrix3, Vector2, Vector3, Vector4 } from 'three/webgpu';
import { toMatrix } from '../../../math/quat.ts';
import { sub } from '../../../math/vec3.ts';
import { gamma } from '../../../physics/lorentz/boost.ts';
import type { Frustum } from '../../../scene/view/lens.ts';
import type { ViewPoint } from '../../../scene/view/view.ts';
import type { Observation } from '../../geometry/observation.ts';
import type { SpacetimeProjection } from '../../geometry/vertexStage.ts';

/** From where and how a picture was seen. */
export interface ViewState {
  readonly observation: Observation;
  readonly viewPoint: ViewPoint;
  readonly projection: SpacetimeProjection;
  readonly frustum: Frustum;
}

/** The eye of the picture before, as the passes read it (temporalAntialiasing.ts), besides the picture's own uniforms. */
export class PreviousView {
  readonly u = uniform(new Vector3());
  readonly gamma = uniform(1);
  /** World axes carried by its boost → camera axes. */
  readonly toCamera = uniform(new Matrix3());
  readonly halfTangents = uniform(new Vector2(1, 1));
  readonly frustumCenter = uniform(new Vector2());
  /** From its event to that of this picture: (Δx [m], cΔt [m of light]), made in f64. */
  readonly displacement = uniform(new Vector4());
  /** 0: this picture follows none. */
  readonly isValid = uniform(0);
  private last: ViewState | undefined;

  /** To be told of every picture that is to follow another, or to be followed. */
  update(look: ViewState): void {
    const { last } = this;
    const follows =
      last !== undefined &&
      last.observation.c === look.observation.c &&
      isSameProjection(last.projection, look.projection);
    this.isValid.value = follows ? 1 : 0;
    if (follows) this.store(last, look.observation);
    this.last = look;
  }

  private store({ observation, viewPoint, frustum }: ViewState, now: Observation): void {
    this.u.value.set(...observation.u);
    this.gamma.value = gamma(observation.u);
    this.toCamera.value.fromArray([...toMatrix(viewPoint.orientation)]);
    this.halfTangents.value.set(frustum.tanX, frustum.tanY);
    this.frustumCenter.value.set(...frustum.center);
    this.displacement.value.set(...sub(now.position, observation.position), now.c * (now.t - observation.t));
  }

  /** The next picture follows none. */
  reset(): void {
    this.last = undefined;
  }
}

const isSameProjection = (a: SpacetimeProjection, b: SpacetimeProjection): boolean =>
  a.event === b.event && a.place === b.place;
