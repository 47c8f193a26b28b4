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
  it('map back to where they come from', () => {
    fc.assert(
      fc.property(map, map, path, (outer, inner, p) => {
        const both = composeMaps(outer, inner);
        const there = mapToTarget(both, p);
        if (there !== undefined) expect(mapToSource(both, there)).toBe(p);
      }),
    );
  });

  it('compose like functions', () => {
    fc.assert(
      fc.property(map, map, path, (outer, inner, p) => {
        const middle = mapToTarget(inner, p);
        const expected = middle === undefined ? undefined : mapToTarget(outer, middle);
        expect(mapToTarget(composeMaps(outer, inner), p)).toBe(expected);
      }),
    );
  });

  it('are inverted by their inverses', () => {
    fc.assert(
      fc.property(map, path, (m, p) => {
        expect(mapToTarget(inverseMap(m), p)).toBe(mapToSource(m, p));
      }),
    );
  });

  it('map descendants and properties, but not names with a common prefix', () => {
    const m = arcMap('/Ref', '/World/Car', { offset: 0, scale: 1 });
    expect(mapToTarget(m, '/Ref/Wheel.size')).toBe('/World/Car/Wheel.size');
    expect(mapToTarget(m, '/Ref.size')).toBe('/World/Car.size');
    expect(mapToTarget(m, '/Reference')).toBeUndefined();
    expect(mapToTarget(withRoot(m), '/World/Car')).toBeUndefined();
  });
});

it('time offsets compose like functions, and have inverses', () => {
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

  it('never duplicate an item, and keep the order of others', () => {
    fc.assert(
      fc.property(items, items, items, items, (list, prepended, appended, deleted) => {
        const out = applyListOp(list, { prepended, appended, deleted }, same);
        expect(new Set(out).size).toBe(out.length);
        const named = new Set([...prepended, ...appended, ...deleted]);
        expect(out.filter((item) => !named.has(item))).toEqual(list.filter((item) => !named.has(item)));
      }),
    );
  });

  it('of layers compose from the weakest; explicit lists hide weaker ones', () => {
    const ops: ListOp<string>[] = [{ appended: ['z'] }, { explicit: ['a', 'b'] }, { prepended: ['hidden'] }];
    expect(composeList(ops, same)).toEqual(['a', 'b', 'z']);
  });

  it('reorder existing items together with those that follow them', () => {
    expect(inOrder(['x', 'a', 'y', 'b', 'z'], ['b', 'a', 'none'], same)).toEqual(['x', 'b', 'z', 'a', 'y']);
  });
});
