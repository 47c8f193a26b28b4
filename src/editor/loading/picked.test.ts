import { expect, it, vi } from 'vitest';
import { droppedFiles, entryOf, pickedFiles } from './picked.ts';

vi.mock('../../formats/registry.ts', () => {
  const sceneFormats = ['usda', 'glb', 'obj'].map((id) => ({ id }));
  return { sceneFormats, formatOf: (path: string) => sceneFormats.find(({ id }) => path.endsWith(`.${id}`)) };
});

it('takes the least deep scene, or the only file', () => {
  expect(entryOf(['a/parts/wheel.usda', 'a/car.usda', 'a/bus.usda', 'a/readme.txt'])).toBe('a/bus.usda');
  expect(entryOf(['a/body.obj', 'a/car.usda'])).toBe('a/car.usda');
  expect(entryOf(['a/body.obj', 'a/b/car.usda'])).toBe('a/body.obj');
  expect(entryOf(['odd.xyz'])).toBe('odd.xyz');
  expect(entryOf(['a.txt', 'b.png'])).toBeUndefined();
  expect(entryOf([])).toBeUndefined();
});

it('keeps the folders of a chosen folder', () => {
  const file = new File(['x'], 'a.usda');
  Object.defineProperty(file, 'webkitRelativePath', { value: 'set/a.usda' });
  expect([...pickedFiles([file, new File(['y'], 'b.png')]).keys()]).toEqual(['set/a.usda', 'b.png']);
});

it('walks dropped folders, portion by portion', async () => {
  const fileEntry = (path: string) => ({
    isFile: true,
    isDirectory: false,
    fullPath: path,
    file: (done: (file: File) => void) => done(new File([path], path)),
  });
  const portions = [[fileEntry('/set/a.usda')], [fileEntry('/set/b.png')], []];
  const folder = {
    isFile: false,
    isDirectory: true,
    createReader: () => ({ readEntries: (done: (entries: unknown[]) => void) => done(portions.shift() ?? []) }),
  };
  const transfer = { items: [{ webkitGetAsEntry: () => folder }], files: [] } as unknown as DataTransfer;
  expect([...(await droppedFiles(transfer)).keys()]).toEqual(['set/a.usda', 'set/b.png']);
});
