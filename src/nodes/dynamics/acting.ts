import { barrier } from '../../dynamics/forces/barrier.ts';
import { Penalty } from '../../dynamics/forces/contact.ts';
import { coulomb } from '../../dynamics/forces/coulomb.ts';
import type { Force } from '../../dynamics/forces/force.ts';
import { NearPairs } from '../../dynamics/forces/near.ts';
import type { Obstacle } from '../../dynamics/forces/obstacle.ts';
import { Pairs } from '../../dynamics/forces/pairs.ts';
import { type Springs, springs } from '../../dynamics/forces/springs.ts';
import { uniform } from '../../dynamics/forces/uniform.ts';
import type { System } from '../../dynamics/system.ts';
import { add, length, type Vec3, ZERO } from '../../math/vec3.ts';
import { refusal } from '../geometry/shared.ts';
import type { FieldMatter, SolidMatter } from './matter.ts';

/** The points of all parts, and what holds them together and stands in their way. World frame, SI units. */
export interface Collected {
  /** x, y, z of one point after the other. */
  readonly x: readonly number[];
  readonly masses: readonly number[];
  /** 1: it is held. */
  readonly pinned: readonly number[];
  readonly charges: readonly number[];
  /** The thing that each point is of, where it is of a net; else −1. */
  readonly bodies: readonly number[];
  readonly nets: readonly Springs[];
  readonly balls: readonly Ball[];
  readonly obstacles: readonly Standing[];
}

/** A ball, which its point is the middle of. */
export interface Ball {
  readonly point: number;
  readonly radius: number;
  readonly of: SolidMatter;
}

/** An obstacle; where it moves, the points that carry it. */
export interface Standing {
  readonly obstacle: Obstacle;
  readonly of: SolidMatter;
  readonly carriers?: readonly number[];
}

/** What acts between points that come near: of different things, and of one that is folded. */
export interface Touch {
  /** 0: nothing does [m]. */
  readonly reach: number;
  /** [N/m] */
  readonly stiffness: number;
}

/** Most pairs of a ball and a point, and of charges. */
const MOST_PAIRS = 4_000_000;

/** All that acts between and upon the points. Throws a NodeRefusal. */
export function actingOn(
  all: Collected,
  fields: readonly FieldMatter[],
  touch: Touch,
): Partial<System> & Pick<System, 'forces'> {
  const charges = Float64Array.from(all.charges);
  const isCharged = charges.some((charge) => charge !== 0);
  const sum = (of: (field: FieldMatter) => Vec3): Vec3 => fields.map(of).reduce(add, ZERO);
  const gravity = sum((field) => field.gravity);
  const electric = sum((field) => field.electric);
  const magnetic = sum((field) => field.magnetic);
  const forces = [
    ...(all.nets.length > 0 ? [springs(joined(all.nets))] : []),
    ...ballContacts(all),
    ...barriers(all),
    ...touches(all, touch),
    ...(length(gravity) > 0 ? [uniform(Float64Array.from(all.masses), gravity)] : []),
    ...(isCharged && length(electric) > 0 ? [uniform(charges, electric)] : []),
    ...(isCharged && fields.some((field) => field.coulomb) ? [repulsion(charges)] : []),
  ];
  return {
    ...{ forces, drag: fields.reduce((total, field) => total + field.drag, 0) },
    ...(isCharged && { charges }),
    ...(isCharged && length(magnetic) > 0 && { magneticField: magnetic }),
  };
}

function joined(nets: readonly Springs[]): Springs {
  const count = nets.reduce((all, { lengths }) => all + lengths.length, 0);
  const all = {
    ends: new Uint32Array(2 * count),
    stiffness: new Float64Array(count),
    lengths: new Float64Array(count),
  };
  let at = 0;
  for (const { ends, stiffness, lengths } of nets) {
    all.ends.set(ends, 2 * at);
    all.stiffness.set(stiffness, at);
    all.lengths.set(lengths, at);
    at += lengths.length;
  }
  return all;
}

/** Balls against each other and against points of nets; of those that are as hard, one force. */
function ballContacts({ bodies, balls, pinned }: Collected): Force[] {
  const points = bodies.flatMap((body, i) => (body < 0 ? [] : [i]));
  if (balls.length * (points.length + balls.length) > MOST_PAIRS) {
    const message = `${balls.length} balls and ${points.length} points are too many to meet; take fewer balls, or coarser meshes`;
    throw refusal('collider.many', balls[0].of.node, message);
  }
  const hard = new Map<number, { readonly ends: number[]; readonly reach: number[] }>();
  const meet = (K: number, a: number, b: number, reach: number): void => {
    if (pinned[a] && pinned[b]) return;
    const known = hard.get(K) ?? { ends: [], reach: [] };
    hard.set(K, known);
    known.ends.push(a, b);
    known.reach.push(reach);
  };
  balls.forEach(({ point, radius, of }, i) => {
    for (const other of balls.slice(i + 1)) {
      const reach = of.scale * radius + other.of.scale * other.radius;
      meet(Math.max(of.stiffness, other.of.stiffness), point, other.point, reach);
    }
    for (const other of points) meet(of.stiffness, point, other, of.scale * radius);
  });
  return [...hard].map(
    ([K, { ends, reach }]) => new Pairs(Uint32Array.from(ends), new Penalty(K, (pair) => reach[pair])),
  );
}

function barriers({ bodies, balls, pinned, obstacles }: Collected): Force[] {
  const moving = (i: number): boolean => !pinned[i];
  const points = bodies.flatMap((body, i) => (body >= 0 && moving(i) ? [i] : []));
  return obstacles.flatMap(({ obstacle, of: { stiffness, margin }, carriers }) => [
    barrier(obstacle, points, stiffness, margin, carriers),
    ...balls
      .filter(({ point }) => moving(point))
      .map(({ point, radius }) => barrier(obstacle, [point], stiffness, margin + radius, carriers)),
  ]);
}

function touches({ bodies, x }: Collected, { reach, stiffness }: Touch): Force[] {
  if (reach === 0) return [];
  const law = new Penalty(stiffness, () => reach);
  return [new NearPairs(Int32Array.from(bodies), Float64Array.from(x), reach, law)];
}

function repulsion(charges: Float64Array): Force {
  const charged = charges.filter((charge) => charge !== 0).length;
  if (charged ** 2 / 2 > MOST_PAIRS) {
    const message = `${charged} charged points are too many to act on each other; charge fewer things, or coarser ones`;
    throw refusal('field.charges', 'charge', message);
  }
  return coulomb(charges);
}
