import type { Vec3 } from '../../math/vec3.ts';
import { type Bvh, buildBvh, emptyBox, growBox } from './bvh.ts';
import { BvhTraversal } from './bvhTraversal.ts';
import type { SpacetimeRay } from './ray.ts';
import type { ObjectIntersector, RayQuery } from './rayQuery.ts';

/** Boxes are enlarged by this fraction of their greatest coordinate, since objects and their boxes are computed by different routes. */
const MARGIN = 1e-9;

/** Objects of one velocity, in a BVH in the coordinates x − v t − `origin`, where they are at rest. */
interface VelocityGroup {
  /** [m/s] */
  readonly velocity: Vec3;
  /** In their middle, where boxes in 32 bits are most accurate. */
  readonly origin: Vec3;
  readonly tree: Bvh;
  readonly tracers: readonly ObjectIntersector[];
}

/** All objects: those that stay in a box at rest or in uniform motion are found by their boxes, the others are always tested. */
export class TopLevelBvh {
  private readonly groups: readonly VelocityGroup[];
  private readonly others: readonly ObjectIntersector[];
  private readonly c: number;
  private readonly traversal = new BvhTraversal();
  /** The ray in a group's coordinates. */
  private readonly line = new Float64Array(6);

  constructor(tracers: readonly ObjectIntersector[], c: number) {
    this.c = c;
    this.others = tracers.filter(({ bounds }) => !bounds);
    const membersByVelocity = new Map<string, ObjectIntersector[]>();
    for (const tracer of tracers) {
      if (!tracer.bounds) continue;
      const key = tracer.bounds.velocity.join(' ');
      membersByVelocity.set(key, [...(membersByVelocity.get(key) ?? []), tracer]);
    }
    this.groups = [...membersByVelocity.values()].map(buildVelocityGroup);
  }

  intersect(ray: SpacetimeRay, search: RayQuery): void {
    for (const group of this.groups) this.traceGroup(group, ray, search);
    for (const tracer of this.others) tracer.intersect(ray, search);
  }

  private traceGroup({ velocity: v, origin, tree, tracers }: VelocityGroup, ray: SpacetimeRay, search: RayQuery): void {
    const { traversal, line } = this;
    const { t, x, dx } = ray;
    const rate = ray.dt / this.c;
    line[0] = x[0] - v[0] * t - origin[0];
    line[1] = x[1] - v[1] * t - origin[1];
    line[2] = x[2] - v[2] * t - origin[2];
    line[3] = dx[0] - v[0] * rate;
    line[4] = dx[1] - v[1] * rate;
    line[5] = dx[2] - v[2] * rate;
    traversal.start(tree, line, search.begin);
    for (let leaf = traversal.next(search.end); leaf >= 0; leaf = traversal.next(search.end)) {
      const from = tree.link[leaf];
      for (let i = from; i < from + tree.count[leaf]; i++) tracers[i].intersect(ray, search);
    }
  }
}

/** The group's tracers are in the order of the tree's leaves. */
function buildVelocityGroup(members: readonly ObjectIntersector[]): VelocityGroup {
  const boxes = new Float64Array(6 * members.length);
  const whole = new Float64Array(6);
  emptyBox(whole, 0);
  members.forEach(({ bounds }, i) => {
    if (bounds) boxes.set(enlarged(bounds.box), 6 * i);
    growBox(whole, 0, boxes, 6 * i);
  });
  const middle = (axis: number) => (whole[axis] + whole[3 + axis]) / 2;
  const origin: Vec3 = [middle(0), middle(1), middle(2)];
  const tree = buildBvh(boxes.map((x, k) => x - origin[k % 3]));
  const tracers = Array.from(tree.order, (i) => members[i]);
  return { velocity: members[0].bounds?.velocity ?? [0, 0, 0], origin, tree, tracers };
}

function enlarged(box: readonly number[]): number[] {
  const margin = MARGIN * Math.max(...box.map(Math.abs));
  return box.map((x, i) => x + (i < 3 ? -margin : margin));
}
