import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, expect, it } from 'vitest';
import { chunkStarts, filmOf, type TestTrack } from '../../../tests/support/mp4Kit.ts';
import { sphericalMp4Edit } from '../../formats/spherical/sphericalMp4.ts';
import { sphericalOf } from '../../formats/spherical/sphericalOf.ts';
import { applyFileEdit } from './fileEdit.ts';
import { partedFile } from './sceneFiles.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-edit-'));
afterAll(() => rmSync(folder, { recursive: true }));

it('replaces bytes of a file by fewer, as many or more, whatever is moved at once', () => {
  const path = join(folder, 'film');
  const [length, block] = [fc.nat(50), fc.integer({ min: 1, max: 60 })];
  fc.assert(
    fc.property(
      length,
      length,
      length,
      fc.uint8Array({ maxLength: 60 }),
      block,
      (before, removed, after, bytes, size) => {
        const old = Array.from({ length: before + removed + after }, (_, i) => i);
        writeFileSync(path, Uint8Array.from(old));
        applyFileEdit(path, { at: before, removed, bytes: Uint8Array.from(bytes) }, size);
        expect([...readFileSync(path)]).toEqual([...old.slice(0, before), ...bytes, ...old.slice(before + removed)]);
      },
    ),
  );
});

it('marks a film on disk, whose chunks are found where they now are', async () => {
  const tracks: readonly TestTrack[] = [{ handler: 'vide', isWide: false }];
  const data = Uint8Array.from({ length: 3000 }, (_, i) => i);
  const chunk = { media: [{ track: 0, data }], isWide: true };
  const path = join(folder, 'film.mp4');
  writeFileSync(path, filmOf(tracks, ['moov', chunk]).bytes);
  const picture = { projection: 'equirectangular', stereo: 'top-bottom' } as const;
  applyFileEdit(path, await sphericalMp4Edit(await partedFile(path), path, picture), 100);
  expect(await sphericalOf(await partedFile(path), path)).toEqual(picture);
  const marked = readFileSync(path);
  const [[at]] = chunkStarts(marked);
  expect(Uint8Array.from(marked.subarray(at))).toEqual(data);
});
