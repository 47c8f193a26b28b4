import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { type CurveArrays, segmentCount, varyingCount } from './stencils.ts';

type Kind = Exclude<CurveArrays['kind'], { basis: 'nurbs' }>;
type Row = [basis: Kind['basis'], wrap: Kind['wrap'], count: number, segments: number, varying: number];

describe.skipIf(!hasUsdCore())('usd-core', () => {
  it('counts the same segments and varying values of curves', () => {
    const rows = JSON.parse(python(fileURLToPath(new URL('fixtures/oracle.py', import.meta.url)))) as Row[];
    // Where the number of vertices is valid for the basis.
    const isValid = ([basis, wrap, count]: Row): boolean =>
      basis !== 'bezier' || count % 3 === (wrap === 'periodic' ? 0 : 1);
    const valid = rows.filter(isValid);
    expect(valid.length).toBeGreaterThan(80);
    for (const [basis, wrap, count, segments, varying] of valid) {
      const curves = { counts: [count], kind: { basis, wrap } } as CurveArrays;
      const ours = segmentCount(curves, count, 0);
      expect([basis, wrap, count, ours, varyingCount(curves, count, ours)]).toEqual([
        basis,
        wrap,
        count,
        segments,
        varying,
      ]);
    }
  });
});
