import { multiply, transform } from '../../../math/mat3.ts';
import { add, negate, type Vec3 } from '../../../math/vec3.ts';
import type { Lifetime, SceneObject, UniformMotion } from '../../../scene/types.ts';
import type { Hit, SpacetimeRay } from '../../acceleration/ray.ts';
import {
  type Crossing,
  clipToTimes,
  type MovingBox,
  type ObjectIntersector,
  type RayQuery,
} from '../../acceleration/rayQuery.ts';
import { RigidFrame } from '../rigidFrame.ts';
import { addLineRoots, Crossings } from './crossings.ts';
import type { RoundSolid } from './roundSolid.ts';

const crossings = new Crossings();
/** The current ray in the solid's axes: o x y z, d x y z. */
const line = new Float64Array(6);

/**
 * Intersects rays with a round solid at rest or in uniform motion. In the coordinates of `RigidFrame` the ray is a straight line, and so it is in the solid's
 * axes, where its surfaces are quadratic equations in s.
 */
export class RigidQuadricIntersector implements ObjectIntersector {
  readonly index: number;
  readonly doubleSided: boolean;
  readonly bounds: MovingBox;
  private readonly lifetime: Lifetime;
  private readonly solid: RoundSolid;
  private readonly c: number;
  private readonly frame: RigidFrame;
  /** From x − x₀ − v t to the solid's axes: x → M x + `shift`. */
  private readonly toSolid: Float64Array;
  private readonly shift: Vec3;

  constructor(
    index: number,
    object: SceneObject,
    motion: Pick<UniformMotion, 'pose' | 'velocity'>,
    solid: RoundSolid,
    c: number,
  ) {
    this.index = index;
    this.doubleSided = object.mesh.doubleSided;
    this.lifetime = object.lifetime;
    this.solid = solid;
    this.c = c;
    this.frame = new RigidFrame(object.authoredIn, motion, c);
    this.toSolid = Float64Array.from(multiply(solid.inverse, this.frame.toObject));
    this.shift = negate(transform(solid.inverse, solid.place));
    this.bounds = this.frame.boxAround(cornersOf(solid));
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    const { birth, death } = this.lifetime;
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
    const at = { ...crossing, ...this.solid.facetAt(y, crossing.corner) };
    return this.frame.hitAt(ray, this.index, at, this.solid.meshNormalAt(y, crossing.corner));
  }

  /** Writes the ray in the solid's axes to `line`, from the place nearest to its centre, and returns that place; undefined if it passes the solid. */
  private toNearest(ray: SpacetimeRay): number | undefined {
    this.frame.writeLine(ray, this.toSolid, line);
    let [along, square] = [0, 0];
    for (let i = 0; i < 3; i++) {
      line[i] += this.shift[i];
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

const cornersOf = ({ extent, linear, place }: RoundSolid): readonly Vec3[] =>
  [0, 1, 2, 3, 4, 5, 6, 7].map((corner) => {
    const sign = (axis: number) => (corner & (1 << axis) ? 1 : -1) * extent[axis];
    return add(place, transform(linear, [sign(0), sign(1), sign(2)]));
  });
