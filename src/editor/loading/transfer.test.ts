import { expect, it } from 'vitest';
import { transferables } from './transfer.ts';

it('finds every buffer once, however deep', () => {
  const shared = new Float32Array(4);
  const other = new Float64Array(2);
  const value = { a: shared, b: [{ c: shared.subarray(1) }, other], d: null, e: 'text', loop: {} };
  value.loop = value;
  expect(transferables(value)).toEqual([shared.buffer, other.buffer]);
});
