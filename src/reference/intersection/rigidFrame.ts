import { multiply } from '../../math/mat3.ts';
import { conjugate, rotate, toMatrix } from '../../math/quat.ts';
import { add, scale, type Vec3 } from '../../math/vec3.ts';
import { gamma, properVelocity } from '../../physics/lorentz/boost.ts';
import { contraction } from '../../physics/worldLines/simultaneity.ts';
import type { Pose, SceneObject, UniformMotion } from '../../scene/types.ts';
import { emptyBox, growBox } from '../acceleration/bvh.ts';
import type { Hit, SpacetimeRay } from '../acceleration/ray.ts';
import { type Crossing, createHit, type MovingBox } from '../acceleration/rayQuery.ts';

/**
 * The coordinates y = M (x − x₀ − v t) of an object at rest or in uniform motion: its points are at rest there, and a straight line of events is a straight
 * line. M inverts the object's orientation and, if the object is authored in its rest frame, the contraction.
 */
export class RigidFrame {
  /** M, row-major. */
  readonly toObject: readonly number[];
  private readonly authoredIn: SceneObject['authoredIn'];
  private readonly pose: Pose;
  private readonly c: number;
  /** Velocity [m/s], β [c] and γβ. */
  private readonly velocity: Vec3;
  private readonly beta: Vec3;
  private readonly u: Vec3;

  constructor(
    authoredIn: SceneObject['authoredIn'],
    { pose, velocity }: Pick<UniformMotion, 'pose' | 'velocity'>,
    c: number,
  ) {
    this.authoredIn = authoredIn;
    this.pose = pose;
    this.c = c;
    this.velocity = velocity;
    this.beta = scale(velocity, 1 / c);
    this.u = properVelocity(this.beta);
    const turn = toMatrix(conjugate(pose.orientation));
    this.toObject = authoredIn === 'rest' ? multiply(turn, lengthening(this.u)) : turn;
  }

  /** The moving box around a box with these corners in the object's axes. */
  boxAround(corners: readonly Vec3[]): MovingBox {
    const box = new Float64Array(6);
    emptyBox(box, 0);
    for (const corner of corners) {
      const turned = rotate(this.pose.orientation, corner);
      const at = add(this.pose.position, this.authoredIn === 'rest' ? contraction(turned, this.u) : turned);
      growBox(box, 0, [...at, ...at], 0);
    }
    return { box: [...box], velocity: this.velocity };
  }

  /** Writes a ray's m (x − x₀ − v t) and its derivative to `line`: o x y z, d x y z. m, row-major, is M, or M followed by another map. */
  writeLine({ t, x, dt, dx }: SpacetimeRay, m: Float64Array, line: Float64Array): void {
    const { velocity: v, beta } = this;
    const p = this.pose.position;
    const ox = x[0] - p[0] - v[0] * t;
    const oy = x[1] - p[1] - v[1] * t;
    const oz = x[2] - p[2] - v[2] * t;
    const dX = dx[0] - beta[0] * dt;
    const dY = dx[1] - beta[1] * dt;
    const dZ = dx[2] - beta[2] * dt;
    line[0] = m[0] * ox + m[1] * oy + m[2] * oz;
    line[1] = m[3] * ox + m[4] * oy + m[5] * oz;
    line[2] = m[6] * ox + m[7] * oy + m[8] * oz;
    line[3] = m[0] * dX + m[1] * dY + m[2] * dZ;
    line[4] = m[3] * dX + m[4] * dY + m[5] * dZ;
    line[5] = m[6] * dX + m[7] * dY + m[8] * dZ;
  }

  /** The hit of a crossing. `normal`: of the surface as authored, in the object's axes. */
  hitAt(ray: SpacetimeRay, object: number, crossing: Crossing, normal: Vec3): Hit {
    const turned = rotate(this.pose.orientation, normal);
    const N = this.authoredIn === 'world' ? contraction(turned, this.u) : turned;
    return createHit(ray, object, crossing, this.c, this.beta, N);
  }
}

/** The inverse of `contraction`, x + (u·x) u/(γ + 1), row-major. */
function lengthening(u: Vec3): readonly number[] {
  const k = 1 / (gamma(u) + 1);
  return [0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => (i === j ? 1 : 0) + k * u[i] * u[j]));
}
