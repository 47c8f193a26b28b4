import fc from 'fast-check';
import { expect, it } from 'vitest';
import { uniform } from '../../../tests/support/physicsArbitraries.ts';
import { buildBvh } from './bvh.ts';
import { BvhTraversal } from './bvhTraversal.ts';

const box = fc
  .tuple(uniform(-9, 9), uniform(-9, 9), uniform(-9, 9), uniform(0, 2), uniform(0, 2), fc.constantFrom(0, 1))
  .map(([x, y, z, a, b, c]) => [x, y, z, x + a, y + b, z + c]);
/** Includes copies of one box, which no plane can separate. */
const boxes = fc
  .tuple(fc.array(box, { maxLength: 60 }), fc.integer({ min: 0, max: 30 }))
  .map(([list, copies]) => [...list, ...Array.from({ length: copies }, () => [1, 2, 3, 2, 3, 4])]);

it('every item is in exactly one leaf, inside the boxes of all its ancestors', () =>
  fc.assert(
    fc.property(boxes, (list) => {
      const { bounds, link, count, order } = buildBvh(Float64Array.from(list.flat()));
      expect([...order].sort((a, b) => a - b)).toEqual(list.map((_, i) => i));
      const visit = (node: number): number[] => {
        const items =
          count[node] > 0
            ? [...order.subarray(link[node], link[node] + count[node])]
            : [...visit(node + 1), ...visit(link[node])];
        const outside = items.filter((i) =>
          [0, 1, 2].some((k) => list[i][k] < bounds[6 * node + k] || list[i][3 + k] > bounds[6 * node + 3 + k]),
        );
        expect(outside).toEqual([]);
        return items;
      };
      if (list.length > 0) expect(visit(0).length).toBe(list.length);
      else expect(link.length).toBe(0);
    }),
  ));

it('traversal visits every item whose box the line meets, also along faces', () =>
  fc.assert(
    fc.property(
      boxes,
      fc.array(uniform(-12, 12), { minLength: 3, maxLength: 3 }),
      fc.array(fc.constantFrom(0, 1, -1, 0.3, -0.7), { minLength: 3, maxLength: 3 }),
      (list, o, d) => {
        fc.pre(d.some((x) => x !== 0));
        const tree = buildBvh(Float64Array.from(list.flat()));
        const traversal = new BvhTraversal();
        traversal.start(tree, [...o, ...d], 0);
        const visited = new Set<number>();
        for (let leaf = traversal.next(50); leaf >= 0; leaf = traversal.next(50))
          for (let i = 0; i < tree.count[leaf]; i++) visited.add(tree.order[tree.link[leaf] + i]);
        list.forEach((b, i) => {
          let [near, far] = [0, 50];
          for (let axis = 0; axis < 3; axis++) {
            const [p, q] = [(b[axis] - o[axis]) / d[axis], (b[3 + axis] - o[axis]) / d[axis]];
            if (d[axis] === 0) {
              if (o[axis] < b[axis] || o[axis] > b[3 + axis]) far = -1;
            } else [near, far] = [Math.max(near, Math.min(p, q)), Math.min(far, Math.max(p, q))];
          }
          if (near <= far) expect(visited.has(i)).toBe(true);
        });
      },
    ),
  ));
