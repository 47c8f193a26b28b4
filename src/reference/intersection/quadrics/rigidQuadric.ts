import { multiply, transform } from '../../../math/mat3.ts';
import { conjugate, rotate, toMatrix } from '../../../math/quat.ts';
import { add, negate, scale, type Vec3 } from '../../../math/vec3.ts';
import { properVelocity } from '../../../physics/lorentz/boost.ts';
import { contraction } from '../../../physics/worldLines/simultaneity.ts';
import type { Pose, SceneObject, UniformMotion } from '../../../scene/types.ts';
import { emptyBox, growBox } from '../../acceleration/bvh.ts';
import type { Hit, SpacetimeRay } from '../../acceleration/ray.ts';
import {
  type Crossing,
  clipToTimes,
  createHit,
  type MovingBox,
  type ObjectIntersector,
  type RayQuery,
} from '../../acceleration/rayQuery.ts';
import { lengthening } from '../rigid.ts';
import { addLineRoots, Crossings } from './crossings.ts';
import type { RoundSolid } from './roundSolid.ts';

const crossings = new Crossings();
/** The current ray in the solid's axes: o x y z, d x y z. */
const line = new Float64Array(6);

/**
 * Intersects rays with a round solid at rest or in uniform motion. In the coordinates of `RigidIntersector` the ray is a straight line, and so it is in the
 * solid's axes, where its surfaces are quadratic equations in s.
 */
export class RigidQuadricIntersector implements ObjectIntersector {
  readonly index: number;
  readonly doubleSided: boolean;
  readonly bounds: MovingBox;
  private readonly object: SceneObject;
  private readonly solid: RoundSolid;
  private readonly c: number;
  private readonly pose: Pose;
  private readonly velocity: Vec3;
  private readonly beta: Vec3;
  private readonly u: Vec3;
  /** From x − x₀ − v t to the solid's axes: x → M x + `shift`. */
  private readonly toSolid: Float64Array;
  private readonly shift: Vec3;

  constructor(
    index: number,
    object: SceneObject,
    { pose, velocity }: Pick<UniformMotion, 'pose' | 'velocity'>,
    solid: RoundSolid,
    c: number,
  ) {
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.object = object;
    this.solid = solid;
    this.c = c;
    this.pose = pose;
    this.velocity = velocity;
    this.beta = scale(velocity, 1 / c);
    this.u = properVelocity(this.beta);
    const turn = toMatrix(conjugate(pose.orientation));
    const toMesh = object.authoredIn === 'rest' ? multiply(turn, lengthening(this.u)) : turn;
    this.toSolid = Float64Array.from(multiply(solid.inverse, toMesh));
    this.shift = negate(transform(solid.inverse, solid.place));
    this.bounds = { box: this.box(), velocity };
  }

  private box(): readonly number[] {
    const { extent, linear, place } = this.solid;
    const box = new Float64Array(6);
    emptyBox(box, 0);
    for (let corner = 0; corner < 8; corner++) {
      const sign = (axis: number) => (corner & (1 << axis) ? 1 : -1) * extent[axis];
      const turned = rotate(this.pose.orientation, add(place, transform(linear, [sign(0), sign(1), sign(2)])));
      const offset = this.object.authoredIn === 'rest' ? contraction(turned, this.u) : turned;
      const at = add(this.pose.position, offset);
      growBox(box, 0, [...at, ...at], 0);
    }
    return [...box];
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { birth, death } = this.object.lifetime;
    const [begin, end] = clipToTimes(ray, birth, death, this.c, search.begin, search.end);
    if (begin > end) return;
    const nearest = this.toNearest(ray);
    if (nearest === undefined) return;
    crossings.clear();
    addLineRoots(this.solid, line, crossings);
    crossings.visit(
      Number.NEGATIVE_INFINITY,
      Number.POSITIVE_INFINITY,
      (s) =>
        Number.isFinite(s) && this.solid.contains(line[0] + s * line[3], line[1] + s * line[4], line[2] + s * line[5]),
      (sigma, part, entering) => {
        const s = nearest + sigma;
        return s > end || (s >= begin && search.offer(this, s, part, 0, 0, entering, 0));
      },
    );
  }

  hitAt(ray: SpacetimeRay, crossing: Crossing): Hit {
    const nearest = this.toNearest(ray) ?? 0;
    const sigma = crossing.s - nearest;
    const y: Vec3 = [line[0] + sigma * line[3], line[1] + sigma * line[4], line[2] + sigma * line[5]];
    const plane = rotate(this.pose.orientation, this.solid.meshNormalAt(y, crossing.corner));
    const N = this.object.authoredIn === 'world' ? contraction(plane, this.u) : plane;
    const at = { ...crossing, ...this.solid.facetAt(y, crossing.corner) };
    return createHit(ray, this.index, at, this.c, this.beta, N);
  }

  /** Writes the ray in the solid's axes to `line`, from the place nearest to its centre, and returns that place; undefined if it passes the solid. */
  private toNearest({ t, x, dt, dx }: SpacetimeRay): number | undefined {
    const { toSolid: m, velocity: v, beta, shift } = this;
    const p = this.pose.position;
    const [ox, oy, oz] = [x[0] - p[0] - v[0] * t, x[1] - p[1] - v[1] * t, x[2] - p[2] - v[2] * t];
    const [dX, dY, dZ] = [dx[0] - beta[0] * dt, dx[1] - beta[1] * dt, dx[2] - beta[2] * dt];
    let [along, square] = [0, 0];
    for (let i = 0; i < 3; i++) {
      line[i] = m[3 * i] * ox + m[3 * i + 1] * oy + m[3 * i + 2] * oz + shift[i];
      line[3 + i] = m[3 * i] * dX + m[3 * i + 1] * dY + m[3 * i + 2] * dZ;
      along += line[i] * line[3 + i];
      square += line[3 + i] * line[3 + i];
    }
    const nearest = square > 0 ? -along / square : 0;
    let distance = 0;
    for (let i = 0; i < 3; i++) {
      line[i] += nearest * line[3 + i];
      distance += line[i] * line[i];
    }
    return distance <= this.solid.radius * this.solid.radius * (1 + 1e-9) ? nearest : undefined;
  }
}
