import { expect, it } from 'vitest';
import { transferables } from './transferables.ts';

it('finds every buffer once, at any depth', () => {
  const shared = new Float32Array(4);
  const other = new Float64Array(2);
  const value = { a: shared, b: [{ c: shared.subarray(1) }, other], d: null, e: 'text', loop: {} };
  value.loop = value;
  expect(transferables(value)).toEqual([shared.buffer, other.buffer]);
});

it('shared objects are sent once, and stay shared', () => {
  const mesh = { positions: new Float32Array(6), indices: new Uint32Array(3) };
  const scene = { objects: Array.from({ length: 1000 }, (_, i) => ({ path: `/${i}`, mesh })) };
  const buffers = transferables(scene);
  expect(buffers).toHaveLength(2);
  const { objects } = structuredClone(scene, { transfer: buffers });
  expect(new Set(objects.map((object) => object.mesh)).size).toBe(1);
  expect(objects[999].mesh.positions).toHaveLength(6);
});
