import { properTimeBetween } from '../../physics/worldLines/properTime.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { middleWorldLine } from '../motion/middleWorldLine.ts';
import type { Lifetime } from '../motion/motionTypes.ts';
import type { SceneObject } from '../types.ts';

/** What carries a clock for a part of its time. */
export interface ClockCarrier {
  /** Its path in spacetime, world frame. */
  readonly line: WorldLine;
  /** When it exists [s]. */
  readonly lifetime: Lifetime;
}

/** The clock of a thing: in the middle of its bounding box, or of a deforming mesh at the vertex nearest to that. */
export interface Clock {
  /** Of the thing. */
  readonly path: string;
  /** At least one, in the order of their births: of pieces that take turns one hands it to the next. */
  readonly carriers: readonly ClockCarrier[];
}

/** World time at which the clock of something shows 0 [s]: its birth, or 0 if it always existed. */
export const clockStart = ({ birth }: Lifetime): number => (Number.isFinite(birth) ? birth : 0);

/**
 * The clocks of objects, in their order; pieces of one thing share a clock. c [m/s].
 * @example
 * const ball = makeObject({ path: '/Ball', mesh: sphere(1), motion: restingAt([5, 0, 0]) });
 * objectClocks([ball], 10).map(({ path }) => path); // ['/Ball']
 */
export function objectClocks(objects: readonly SceneObject[], c: number): readonly Clock[] {
  const carriers = new Map<string, ClockCarrier[]>();
  for (const object of objects) {
    const path = object.pieceOf ?? object.path;
    const carrier = { line: middleWorldLine(object, c), lifetime: object.lifetime };
    carriers.set(path, [...(carriers.get(path) ?? []), carrier]);
  }
  return [...carriers].map(([path, all]) => ({
    path,
    carriers: all.sort((a, b) => a.lifetime.birth - b.lifetime.birth),
  }));
}

/**
 * What a clock shows at world time t [s]: the proper time of its carriers since `clockStart` of the first, negative before. c [m/s].
 * docs/physics.md §4.13.
 */
export function clockTime({ carriers }: Clock, t: number, c: number): number {
  const start = clockStart(carriers[0]!.lifetime);
  const [from, to] = t < start ? [t, start] : [start, t];
  const elapsed = carriers.reduce((sum, { line, lifetime: { birth, death } }) => {
    const [begin, end] = [Math.max(from, birth), Math.min(to, death)];
    return begin < end ? sum + properTimeBetween(line, begin, end, c) : sum;
  }, 0);
  return t < start ? -elapsed : elapsed;
}
