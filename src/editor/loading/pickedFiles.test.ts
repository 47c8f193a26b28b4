import { expect, it } from 'vitest';
import { droppedFiles, pickedFiles } from './pickedFiles.ts';

it('keeps the folders of a chosen folder', () => {
  const file = new File(['x'], 'a.usda');
  Object.defineProperty(file, 'webkitRelativePath', { value: 'set/a.usda' });
  expect([...pickedFiles([file, new File(['y'], 'b.png')]).keys()]).toEqual(['set/a.usda', 'b.png']);
});

it('reads dropped folders batch by batch', async () => {
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
