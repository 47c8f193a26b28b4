import { zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { saying } from '../../../tests/support/inWords.ts';
import { serializeDocument } from '../../graph/document/serialize.ts';
import { applyCommand } from '../../graph/edits/commands.ts';
import { newProject, setParamCommand } from '../../nodes/project/projectCommands.ts';
import { LocalFiles } from '../loading/localFiles.ts';
import { expandArchives } from '../loading/userFiles.ts';
import { exportedName, fileName, findProject, namedFile, projectName } from './projectNames.ts';
import { openErrorOf, projectFromFiles } from './projectSource.ts';
import { restoreSession } from './restoreSession.ts';
import type { SessionRecord } from './sessionStore.ts';

const blob = (words: string) => new Blob([words]);
const projectOf = (source: string) => blob(serializeDocument(newProject(source)));
const sourceOf = (document: ReturnType<typeof newProject>) => document.nodes.read?.params.source;

describe('the names of files', () => {
  it.each([
    ['examples/street.usdc', '', 'examples/street.usdc'],
    ['local:3/set/scene.usda', '', 'set/scene.usda'],
    ['local:4.1@examples/street.usdc', '', 'examples/street.usdc'],
    ['local:3/set.zip/a/scene.usda', '', 'set.zip[a/scene.usda]'],
    ['local:3/yard.zip/a/scene.usda', 'local:3/yard.zip/project.slowlight.json', 'a/scene.usda'],
    ['local:3.2/yard/a/scene.usda', 'local:3/yard/my.slowlight.json', 'a/scene.usda'],
    ['local:4/yard/a/scene.usda', 'local:3/yard/my.slowlight.json', 'yard/a/scene.usda'],
  ])('%s, of a project at "%s", is outside %s', (source, origin, name) =>
    expect(exportedName(source, origin)).toBe(name),
  );

  it('a project is found among files, the least nested first, ignoring hidden files', () => {
    expect(findProject(['a/b.slowlight.json', 'z.SLOWLIGHT.json', '.x.slowlight.json', 'scene.usda'])).toBe(
      'z.SLOWLIGHT.json',
    );
    expect(findProject(['__MACOSX/a.slowlight.json', 'a.json'])).toBeUndefined();
  });

  it('a project’s name is the user’s, else that of its file, its archive or its scene', () => {
    const state = (origin: string, title?: string) => ({
      history: { document: { ...newProject(), title }, origin, past: [], future: [] },
      pictureSource: { origin, source: 'local:1/a/street.v2.usda', reads: {} },
    });
    expect(projectName(state('local:1/yard.zip/project.slowlight.json'))).toBe('yard');
    expect(projectName(state('examples/workshop.slowlight.json'))).toBe('workshop');
    expect(projectName(state('examples/workshop.slowlight.json', 'Mine'))).toBe('Mine');
    expect(projectName(state(''))).toBe('street.v2');
    const refused = { document: newProject('examples/wheel.usdc'), origin: '', past: [], future: [] };
    expect(projectName({ history: refused, pictureSource: { origin: '', source: '', reads: {} } })).toBe('wheel');
    expect(fileName('a/b: "c"?\n', '.zip')).toBe('a b c.zip');
    expect(fileName('///', '.zip')).toBe('project.zip');
  });
});

describe('a project among files', () => {
  it.each([
    ['beside it', 'set/scene.usda', ['p/my.slowlight.json', 'p/set/scene.usda'], 'local:1/p/set/scene.usda'],
    ['flattened', 'set/scene.usda', ['my.slowlight.json', 'scene.usda'], 'local:1/scene.usda'],
    [
      'in an archive',
      'set.zip[a/scene.usda]',
      ['my.slowlight.json', 'set.zip/a/scene.usda'],
      'local:1/set.zip/a/scene.usda',
    ],
    ['beside the page', 'examples/street.usdc', ['my.slowlight.json'], 'examples/street.usdc'],
    ['of another session', 'local:9/set/scene.usda', ['my.slowlight.json'], 'set/scene.usda'],
  ])('finds a file %s', async (_, named, paths, found) => {
    const files = new Map(paths.map((path) => [path, path.endsWith('.json') ? projectOf(named) : blob('x')]));
    const { document, origin } = await projectFromFiles(files, findProject(paths)!, new LocalFiles());
    expect(sourceOf(document)).toBe(found);
    expect(origin).toBe(`local:1/${findProject(paths)}`);
  });

  it('a name that is typed means a file opened with it, else one opened before', () => {
    const local = new LocalFiles();
    local.add(
      new Map([
        ['stage.usda', blob('x')],
        ['blur.fs', blob('x')],
      ]),
      'stage.usda',
    );
    local.add(
      new Map([
        ['p/my.slowlight.json', blob('x')],
        ['p/stage.usda', blob('x')],
      ]),
      'p/my.slowlight.json',
    );
    const named = (name: string) => namedFile(name, 'local:2/p/my.slowlight.json', local);
    expect(named('stage.usda')).toBe('local:2/p/stage.usda');
    expect(named('blur.fs')).toBe('local:1/blur.fs');
    expect(named('examples/street.usdc')).toBe('examples/street.usdc');
    expect(named('')).toBe('');
    expect(namedFile('stage.usda', '', local)).toBe('local:1/stage.usda');
  });

  it('finds files given before, and those packed with it', async () => {
    const local = new LocalFiles();
    local.add(new Map([['set/scene.usda', blob('x')]]), 'set/scene.usda');
    const alone = await projectFromFiles(
      new Map([['my.slowlight.json', projectOf('set/scene.usda')]]),
      'my.slowlight.json',
      local,
    );
    expect(sourceOf(alone.document)).toBe('local:1/set/scene.usda');
    const text = new TextEncoder().encode(serializeDocument(newProject('scene.usda')));
    const zip = new Blob([zipSync({ 'project.slowlight.json': text, 'scene.usda': new Uint8Array(1) })]);
    const files = await expandArchives(new Map([['yard.zip', zip]]));
    const packed = await projectFromFiles(files, findProject([...files.keys()])!, new LocalFiles());
    expect(sourceOf(packed.document)).toBe('local:1/yard.zip/scene.usda');
  });

  it('that is invalid is rejected with file, place and remedy', async () => {
    const open = (words: string) =>
      projectFromFiles(new Map([['my.slowlight.json', blob(words)]]), 'my.slowlight.json', new LocalFiles()).then(
        () => undefined,
        (error) => openErrorOf('my.slowlight.json', error),
      );
    const bad = JSON.parse(await projectOf('a.usda').text());
    bad.nodes.read.params.source = { no: 'text' };
    expect(await open(JSON.stringify(bad))).toMatchObject({
      place: 'my.slowlight.json',
      text: saying(/^nodes\.read\.params\.source: .*Save the project again/),
    });
    expect(await open('{"format"')).toMatchObject({ text: saying(/^not JSON/) });
  });
});

describe('a stored session', () => {
  const kept = (document: unknown, origin = ''): SessionRecord => ({
    ...{ id: 'a', address: '/', name: 'x', document, origin, unsaved: true, at: 0, passed: false },
  });
  const files = new Map([['2.3', new Map([['s.usda', blob('s')]])]]);

  it('is restored under its own names, and its keys are not reused', () => {
    const local = new LocalFiles();
    const { document, unsaved } = restoreSession(kept(newProject('local:2.3/s.usda')), files, local);
    expect([sourceOf(document), unsaved]).toEqual(['local:2.3/s.usda', true]);
    expect(local.get('local:2.3/s.usda')?.entry).toBe('s.usda');
    expect(local.add(new Map(), 'b.usda')).toBe('local:4/b.usda');
  });

  it('is restored into another session under other names if they are taken', () => {
    const local = new LocalFiles();
    restoreSession(kept(newProject()), files, local);
    const { document, origin } = restoreSession(
      kept(newProject('local:2.3@examples/s.usda'), 'local:2.3/p.slowlight.json'),
      files,
      local,
    );
    expect([sourceOf(document), origin]).toEqual(['local:4@examples/s.usda', 'local:4/p.slowlight.json']);
  });

  it('whose files were not stored does not get files of others', () => {
    const local = new LocalFiles();
    const { document } = restoreSession(kept(newProject('local:7/big.usda')), new Map(), local);
    expect(sourceOf(document)).toBe('local:7/big.usda');
    expect(local.add(new Map(), 'b.usda')).toBe('local:8/b.usda');
  });

  it('is validated as strictly as a file', () => {
    const { document } = applyCommand(newProject(), setParamCommand(newProject(), 'read', 'source', 'a'));
    expect(() => restoreSession(kept({ ...document, nodes: 3 }), new Map(), new LocalFiles())).toThrow(/nodes/);
  });
});
