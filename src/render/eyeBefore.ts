import { uniform } from 'three/tsl';
import { Matrix3, Vector2, Vector3, Vector4 } from 'three/webgpu';
import { toMatrix } from '../math/quat.ts';
import { sub } from '../math/vec3.ts';
import { gamma } from '../physics/boost.ts';
import type { ViewPoint } from '../scene/view.ts';
import type { Sight } from './sight.ts';
import type { Projection } from './vertexStage.ts';

/** From where and how a picture was seen. */
export interface Look {
  readonly sight: Sight;
  readonly viewPoint: ViewPoint;
  readonly projection: Projection;
  /** Width over height. */
  readonly aspect: number;
}

/** The eye of the picture before, as the passes read it (temporal.ts), besides the picture's own uniforms. */
export class EyeBefore {
  readonly u = uniform(new Vector3());
  readonly gamma = uniform(1);
  /** World axes carried by its boost → camera axes. */
  readonly toCamera = uniform(new Matrix3());
  readonly halfTangents = uniform(new Vector2(1, 1));
  /** From its event to that of this picture: (Δx [m], cΔt [m of light]), made in f64. */
  readonly step = uniform(new Vector4());
  /** 0: this picture follows none. */
  readonly known = uniform(0);
  private last: Look | undefined;

  /** To be told of every picture that is to follow another, or to be followed. */
  meet(look: Look): void {
    const { last } = this;
    const follows = last !== undefined && last.sight.c === look.sight.c && isSameKind(last.projection, look.projection);
    this.known.value = follows ? 1 : 0;
    if (follows) this.remember(last, look.sight);
    this.last = look;
  }

  private remember({ sight, viewPoint: view, aspect }: Look, now: Sight): void {
    const tanY = Math.tan(view.fovY / 2);
    this.u.value.set(...sight.u);
    this.gamma.value = gamma(sight.u);
    this.toCamera.value.fromArray([...toMatrix(view.orientation)]);
    this.halfTangents.value.set(tanY * aspect, tanY);
    this.step.value.set(...sub(now.position, sight.position), now.c * (now.t - sight.t));
  }

  /** The next picture follows none. */
  forget(): void {
    this.last = undefined;
  }
}

const isSameKind = (a: Projection, b: Projection): boolean => a.event === b.event && a.place === b.place;
