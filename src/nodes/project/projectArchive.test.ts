import fc from 'fast-check';
import { unzipSync } from 'fflate';
import { expect, it } from 'vitest';
import { add, edited, set } from '../../../tests/support/graphKit.ts';
import { packZip } from '../../formats/zip/pack.ts';
import { DocumentError } from '../../graph/document/document.ts';
import { referencedFiles, renameFiles } from '../../graph/document/fileReferences.ts';
import { InputError } from '../../scene/types.ts';
import { nodeLibrary } from '../library.ts';
import { openProjectArchive, packProjectArchive } from './projectArchive.ts';
import { newProject } from './projectCommands.ts';

const bytes = (text: string) => new TextEncoder().encode(text);
const document = newProject('set/street.usda');
const files = new Map([
  ['set/street.usda', bytes('#usda 1.0')],
  ['set/wood.png', bytes('wood')],
]);

it('a project round-trips through its archive, with its files and their hashes', async () => {
  const packed = await packProjectArchive(document, files);
  const opened = await openProjectArchive(packed, 'street.zip');
  expect(opened.files).toEqual(files);
  // Computed by Python's hashlib.
  expect(opened.document.files['set/street.usda']).toEqual({
    size: 9,
    hash: HASH,
  });
  expect({ ...opened.document, files: {} }).toEqual(document);
  expect(Object.keys(unzipSync(packed))[0]).toBe('project.slowlight.json');
  expect(await packProjectArchive(opened.document, files)).toEqual(packed);
});
const HASH = '1c18c54d5a3f29abd62c564320532ef3d4112ea03856ba53088f5828f25cf109';

it('files that nodes read must exist', async () => {
  await expect(packProjectArchive(document, new Map())).rejects.toMatchObject({
    diagnostic: { code: 'file.missing', place: 'set/street.usda' },
  });
});

it('file references of all nodes are found and renamed', () => {
  const two = edited(document, add('other', 'read'), set('other', 'source', 'b.glb'), add('none', 'read'), {
    kind: 'set-file',
    file: 'b.glb',
    value: { size: 3 },
  });
  expect(referencedFiles(two, nodeLibrary)).toEqual(['b.glb', 'set/street.usda']);
  const renamed = renameFiles(two, nodeLibrary, (file) => `local:1/${file}`);
  expect(referencedFiles(renamed, nodeLibrary)).toEqual(['local:1/b.glb', 'local:1/set/street.usda']);
  expect(renamed.files).toEqual({ 'local:1/b.glb': { size: 3 } });
  expect(renameFiles(renamed, nodeLibrary, (file) => file.replace('local:1/', ''))).toEqual(two);
});

it('an archive that is damaged or without a project is rejected', async () => {
  const packed = await packProjectArchive(document, files);
  await expect(openProjectArchive(bytes('no zip'), 'a.zip')).rejects.toThrow(InputError);
  await expect(openProjectArchive(packZip(files), 'a.zip')).rejects.toMatchObject({
    diagnostic: { code: 'zip.no-project' },
  });
  const damage = fc.tuple(fc.nat(packed.length - 1), fc.nat(255));
  await fc.assert(
    fc.asyncProperty(damage, async ([at, value]) => {
      const copy = packed.slice();
      copy[at] = value;
      try {
        await openProjectArchive(copy, 'a.zip');
      } catch (error) {
        expect(error instanceof InputError || error instanceof DocumentError).toBe(true);
      }
    }),
  );
});
