import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { ListOp } from '../layer/layer.ts';
import { applyListOp, composeList, inOrder } from './layers/listOps.ts';
import { composeOffsets, inverseOffset, mapTime } from './layers/timeOffset.ts';
import { arcMap, composeMaps, inverseMap, mapToSource, mapToTarget, withRoot } from './primIndex/namespaceMap.ts';

const name = fc.constantFrom('A', 'B', 'C');
const path = fc.array(name, { minLength: 1, maxLength: 4 }).map((names) => `/${names.join('/')}`);
const time = fc.record({ offset: fc.integer({ min: -9, max: 9 }), scale: fc.constantFrom(1, 2, 0.5, 4) });
const map = fc
  .tuple(path, path, time, fc.boolean())
  .map(([source, target, t, rooted]) => (rooted ? withRoot(arcMap(source, target, t)) : arcMap(source, target, t)));

describe('maps of namespace', () => {
  it('lead back where they come from', () => {
    fc.assert(
      fc.property(map, map, path, (outer, inner, p) => {
        const both = composeMaps(outer, inner);
        const there = mapToTarget(both, p);
        if (there !== undefined) expect(mapToSource(both, there)).toBe(p);
      }),
    );
  });

  it('compose as one after the other', () => {
    fc.assert(
      fc.property(map, map, path, (outer, inner, p) => {
        const middle = mapToTarget(inner, p);
        const expected = middle === undefined ? undefined : mapToTarget(outer, middle);
        expect(mapToTarget(composeMaps(outer, inner), p)).toBe(expected);
      }),
    );
  });

  it('are undone by their inverses', () => {
    fc.assert(
      fc.property(map, path, (m, p) => {
        expect(mapToTarget(inverseMap(m), p)).toBe(mapToSource(m, p));
      }),
    );
  });

  it('take descendants and properties along, but not names that only begin alike', () => {
    const m = arcMap('/Ref', '/World/Car', { offset: 0, scale: 1 });
    expect(mapToTarget(m, '/Ref/Wheel.size')).toBe('/World/Car/Wheel.size');
    expect(mapToTarget(m, '/Ref.size')).toBe('/World/Car.size');
    expect(mapToTarget(m, '/Reference')).toBeUndefined();
    expect(mapToTarget(withRoot(m), '/World/Car')).toBeUndefined();
  });
});

it('offsets of time compose as one after the other, and are undone', () => {
  fc.assert(
    fc.property(time, time, fc.integer({ min: -99, max: 99 }), (outer, inner, t) => {
      expect(mapTime(composeOffsets(outer, inner), t)).toBeCloseTo(mapTime(outer, mapTime(inner, t)), 9);
      expect(mapTime(inverseOffset(outer), mapTime(outer, t))).toBeCloseTo(t, 9);
    }),
  );
});

describe('list edits', () => {
  const same = (item: string): string => item;
  const items = fc.uniqueArray(fc.constantFrom('a', 'b', 'c', 'd', 'e'));

  it('never make an item come twice, and keep what they do not name in order', () => {
    fc.assert(
      fc.property(items, items, items, items, (list, prepended, appended, deleted) => {
        const out = applyListOp(list, { prepended, appended, deleted }, same);
        expect(new Set(out).size).toBe(out.length);
        const named = new Set([...prepended, ...appended, ...deleted]);
        expect(out.filter((item) => !named.has(item))).toEqual(list.filter((item) => !named.has(item)));
      }),
    );
  });

  it('of layers compose from the weakest; what is written whole hides the weaker', () => {
    const ops: ListOp<string>[] = [{ appended: ['z'] }, { explicit: ['a', 'b'] }, { prepended: ['hidden'] }];
    expect(composeList(ops, same)).toEqual(['a', 'b', 'z']);
  });

  it('reorder what is there and take along what follows', () => {
    expect(inOrder(['x', 'a', 'y', 'b', 'z'], ['b', 'a', 'none'], same)).toEqual(['x', 'b', 'z', 'a', 'y']);
  });
});
