import { barrier } from '../../dynamics/forces/barrier.ts';
import { PenaltyPotential } from '../../dynamics/forces/contact.ts';
import { coulomb } from '../../dynamics/forces/coulomb.ts';
import type { Force } from '../../dynamics/forces/force.ts';
import { NeighborPairs } from '../../dynamics/forces/neighborPairs.ts';
import type { Obstacle } from '../../dynamics/forces/obstacle.ts';
import { PairForce } from '../../dynamics/forces/pairs.ts';
import { type Springs, springForce } from '../../dynamics/forces/springs.ts';
import { uniformField } from '../../dynamics/forces/uniformField.ts';
import type { System } from '../../dynamics/system.ts';
import { add, length, type Vec3, ZERO } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { nodeRefusal } from '../common/params.ts';
import type { ColliderMatter, FieldMatter } from './matter.ts';

/** Points of all parts, the springs between them and their obstacles. World frame, SI units. */
export interface PointCollection {
  /** x, y, z of each point. */
  readonly x: readonly number[];
  readonly masses: readonly number[];
  /** 1 for pinned points. */
  readonly pinned: readonly number[];
  readonly charges: readonly number[];
  /** Index of the object of each point, for points of nets; otherwise −1. */
  readonly bodies: readonly number[];
  readonly nets: readonly Springs[];
  readonly spheres: readonly SimulatedSphere[];
  readonly obstacles: readonly PlacedObstacle[];
}

/** A sphere centered at its point. */
export interface SimulatedSphere {
  readonly point: number;
  readonly radius: number;
  readonly of: ColliderMatter;
}

/** An obstacle; if it moves, the points that carry it. */
export interface PlacedObstacle {
  readonly obstacle: Obstacle;
  readonly of: ColliderMatter;
  readonly carriers?: readonly number[];
}

/** Contact between nearby points: of different objects, and of an object that is folded. */
export interface ProximityContact {
  /** 0: no contact [m]. */
  readonly reach: number;
  /** [N/m] */
  readonly stiffness: number;
}

/** Maximum number of sphere–point pairs, and of pairs of charges. */
const MAX_PAIRS = 4_000_000;

/** All forces on and between the points. Throws a NodeRefusal. */
export function forcesOn(
  all: PointCollection,
  fields: readonly FieldMatter[],
  contact: ProximityContact,
): Partial<System> & Pick<System, 'forces'> {
  const charges = Float64Array.from(all.charges);
  const isCharged = charges.some((charge) => charge !== 0);
  const sum = (of: (field: FieldMatter) => Vec3): Vec3 => fields.map(of).reduce(add, ZERO);
  const gravity = sum((field) => field.gravity);
  const electric = sum((field) => field.electric);
  const magnetic = sum((field) => field.magnetic);
  const forces = [
    ...(all.nets.length > 0 ? [springForce(concatSprings(all.nets))] : []),
    ...sphereContactForces(all),
    ...barrierForces(all),
    ...proximityForces(all, contact),
    ...(length(gravity) > 0 ? [uniformField(Float64Array.from(all.masses), gravity)] : []),
    ...(isCharged && length(electric) > 0 ? [uniformField(charges, electric)] : []),
    ...(isCharged && fields.some((field) => field.coulomb) ? [coulombForce(charges)] : []),
  ];
  return {
    ...{ forces, drag: fields.reduce((total, field) => total + field.drag, 0) },
    ...(isCharged && { charges }),
    ...(isCharged && length(magnetic) > 0 && { magneticField: magnetic }),
  };
}

function concatSprings(nets: readonly Springs[]): Springs {
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

/** Contact of spheres with each other and with points of nets; one force for all of equal stiffness. */
function sphereContactForces({ bodies, spheres: balls, pinned }: PointCollection): Force[] {
  const points = bodies.flatMap((body, i) => (body < 0 ? [] : [i]));
  if (balls.length * (points.length + balls.length) > MAX_PAIRS) {
    const message = msg`${balls.length} balls and ${points.length} points make too many pairs; take fewer balls, or coarser meshes`;
    throw nodeRefusal('collider.many', balls[0].of.node, message);
  }
  const byStiffness = new Map<number, { readonly ends: number[]; readonly reach: number[] }>();
  const meet = (K: number, a: number, b: number, reach: number): void => {
    if (pinned[a] && pinned[b]) return;
    const contacts = byStiffness.get(K) ?? { ends: [], reach: [] };
    byStiffness.set(K, contacts);
    contacts.ends.push(a, b);
    contacts.reach.push(reach);
  };
  balls.forEach(({ point, radius, of }, i) => {
    for (const other of balls.slice(i + 1)) {
      const reach = of.scale * radius + other.of.scale * other.radius;
      meet(Math.max(of.stiffness, other.of.stiffness), point, other.point, reach);
    }
    for (const other of points) meet(of.stiffness, point, other, of.scale * radius);
  });
  return [...byStiffness].map(
    ([K, { ends, reach }]) => new PairForce(Uint32Array.from(ends), new PenaltyPotential(K, (pair) => reach[pair])),
  );
}

function barrierForces({ bodies, spheres: balls, pinned, obstacles }: PointCollection): Force[] {
  const moving = (i: number): boolean => !pinned[i];
  const points = bodies.flatMap((body, i) => (body >= 0 && moving(i) ? [i] : []));
  return obstacles.flatMap(({ obstacle, of: { stiffness, margin }, carriers }) => [
    barrier(obstacle, points, stiffness, margin, carriers),
    ...balls
      .filter(({ point }) => moving(point))
      .map(({ point, radius }) => barrier(obstacle, [point], stiffness, margin + radius, carriers)),
  ]);
}

function proximityForces({ bodies, x }: PointCollection, { reach, stiffness }: ProximityContact): Force[] {
  if (reach === 0) return [];
  const potential = new PenaltyPotential(stiffness, () => reach);
  return [new NeighborPairs(Int32Array.from(bodies), Float64Array.from(x), reach, potential)];
}

function coulombForce(charges: Float64Array): Force {
  const charged = charges.filter((charge) => charge !== 0).length;
  if (charged ** 2 / 2 > MAX_PAIRS) {
    const message = msg`${charged} charged points make too many pairs; charge fewer or coarser objects`;
    throw nodeRefusal('field.charges', 'charge', message);
  }
  return coulomb(charges);
}
