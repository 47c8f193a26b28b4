import { expect, test } from 'vitest';
import { toSharedMemory } from './sharedMemory.ts';

test('moves the arrays of plain data to shared memory, each once', () => {
  const positions = new Float32Array([1, 2, 3, 4]).subarray(1);
  const data = { name: 'a', lifetime: { birth: -Infinity }, meshes: [{ positions }, { positions }], none: undefined };
  const copy = toSharedMemory(data);
  expect(copy).toEqual(data);
  expect(copy.meshes[0].positions.buffer).toBeInstanceOf(SharedArrayBuffer);
  expect(copy.meshes[1].positions).toBe(copy.meshes[0].positions);
  const { key, by } = toSharedMemory({ key: positions, by: new Map([[positions, { x: 1 }]]) });
  expect(by.get(key)).toEqual({ x: 1 });
  // The other side of a thread sees what is written here.
  const sent = structuredClone(copy);
  copy.meshes[0].positions[2] = 7;
  expect(sent.meshes[1].positions[2]).toBe(7);
  expect(positions[2]).toBe(4);
});
