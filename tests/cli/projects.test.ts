import { readFileSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { expect, test } from 'vitest';
import { projects } from '../../examples/projects/index.ts';
import { parseDocument } from '../../src/graph/document/parse.ts';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { applyCommand } from '../../src/graph/edits/commands.ts';
import { packProjectArchive } from '../../src/nodes/project/projectArchive.ts';
import { newProject } from '../../src/nodes/project/projectCommands.ts';
import { outputFolder, scene, slowlight } from './program.ts';

const folder = outputFolder();
const at = (name: string): string => join(folder, name);
const example = (name: string): string => new URL(`../../examples/${name}.slowlight.json`, import.meta.url).pathname;

/** A project that shows one file unchanged. */
function projectOf(file: string, name: string): string {
  const path = at(name);
  const node = { kind: 'set-param', node: 'toneMap', param: 'metering', value: 'resting-eye' } as const;
  writeFileSync(path, serializeDocument(applyCommand(newProject(relative(folder, file)), node).document));
  return path;
}

/** A small picture in one thread, because each thread has to load the program. */
const sized = ['--size', '32x18', '--pipeline', 'reference', '--threads', '1', '--beta', '0,0,-0.5'];
const picture = [...sized, '--samples', '1'];

test('a project renders as its scene with the same flags, and a set parameter acts as its flag', async () => {
  const project = projectOf(scene('movers.usda'), 'movers.slowlight.json');
  const runs = [
    [project],
    [scene('movers.usda'), '--metering', 'resting-eye'],
    [project, '--set', 'toneMap.exposure=-1', '--set', 'rasterize.antialiasing=off'],
    [scene('movers.usda'), '--metering', 'resting-eye', '--exposure', '-1', '--no-antialiasing'],
  ];
  const made: Buffer[] = [];
  for (const [i, run] of runs.entries()) {
    const { code, err } = await slowlight('render', ...run, ...sized, '-o', at(`${i}.png`));
    expect(code, err).toBe(0);
    made.push(readFileSync(at(`${i}.png`)));
  }
  expect(made[0]!.equals(made[1]!)).toBe(true);
  expect(made[2]!.equals(made[3]!)).toBe(true);
  expect(made[0]!.equals(made[2]!)).toBe(false);
});

test('the observer of a project has the given velocity', async () => {
  const document = parseDocument(readFileSync(projectOf(scene('movers.usda'), 'observed.slowlight.json'), 'utf8'));
  const start = { node: 'start', output: 'observer' } as const;
  const observed = applyCommand(document, {
    kind: 'batch',
    commands: [
      { kind: 'add-node', node: 'start', type: 'observer', at: [0, 0], params: { beta: [0, 0.6, 0] } },
      { kind: 'connect', edge: { from: start, to: { node: 'scene', input: 'observer' } } },
    ],
  });
  writeFileSync(at('observed.slowlight.json'), serializeDocument(observed.document));
  const size = ['--size', '16x9', '--pipeline', 'reference', '--samples', '1', '--json'];
  const { out } = await slowlight('render', at('observed.slowlight.json'), ...size, '-o', at('observed.png'));
  expect(JSON.parse(out).observer).toMatchObject({ beta: [0, expect.closeTo(0.6, 12), 0] });
});

test('an archive renders the project in it, with its files', async () => {
  const document = parseDocument(readFileSync(projectOf('movers.usda', 'packed.slowlight.json'), 'utf8'));
  const named = applyCommand(document, { kind: 'set-param', node: 'read', param: 'source', value: 'movers.usda' });
  const files = new Map([['movers.usda', new Uint8Array(readFileSync(scene('movers.usda')))]]);
  writeFileSync(at('packed.zip'), await packProjectArchive(named.document, files));
  const whole = projectOf(scene('movers.usda'), 'beside.slowlight.json');
  for (const [i, run] of [at('packed.zip'), whole].entries()) {
    const { code, err } = await slowlight('render', run, ...picture, '-o', at(`packed${i}.png`));
    expect(code, err).toBe(0);
  }
  expect(readFileSync(at('packed0.png')).equals(readFileSync(at('packed1.png')))).toBe(true);
  expect((await slowlight('graph', 'check', at('packed.zip'))).code).toBe(0);
});

/** What the reference renderer needs for the examples: of slow ones a part, and no grid over a picture that the project puts together. */
const adapted: Readonly<Record<string, readonly string[]>> = {
  checkerboards: ['--set', 'seen.grid=false'],
  truth: ['--set', 'truth.width=32', '--set', 'truth.height=18'],
  workshop: ['--set', 'smooth.levels=1'],
  'falling-cloth': ['--set', 'fall.duration=0.1'],
  'hanging-cloth': ['--set', 'swing.duration=0.1'],
  impact: ['--set', 'meeting.duration=0.05'],
  bouncing: ['--set', 'fall.duration=0.05'],
  cradle: ['--set', 'swing.duration=0.1'],
  pendulums: ['swing1', 'swing10', 'swing100'].flatMap((run) => ['--set', `${run}.duration=0.1`]),
  'source-speeds': ['--set', 'span.number=0.02'],
  'source-corrections': ['--set', 'span.number=0.02'],
  'source-ball': ['--set', 'span.number=0.02'],
};

test('the examples are valid', async () => {
  const { code, err } = await slowlight('graph', 'check', ...Object.keys(projects).map(example));
  expect(code, err).toBe(0);
});

test.each(Object.entries(projects))('the example %s equals its sketch, and renders', async (name, make) => {
  expect(readFileSync(example(name), 'utf8')).toBe(serializeDocument(make()));
  const { code, err } = await slowlight(
    'render',
    example(name),
    ...[...picture, ...(adapted[name] ?? [])],
    ...['-o', at(`${name}.png`)],
  );
  expect(code, err).toBe(0);
});

test('invalid projects are rejected with name and place', async () => {
  const project = projectOf(scene('movers.usda'), 'set.slowlight.json');
  const refused = async (...args: string[]) => {
    const { code, err } = await slowlight('render', ...args, '-o', at('no.png'));
    return `${code} ${err}`;
  };
  expect(await refused(project, '--set', 'toneMap.exposure=bright')).toMatch(
    /^2 .*toneMap\.exposure=bright: bright is not a number/,
  );
  for (const none of ['', '1,5']) {
    expect(await refused(project, '--set', `toneMap.exposure=${none}`)).toMatch(
      /^2 .*=(1,5)?: (1,5)? ?is not a number/,
    );
  }
  expect(await refused(project, '--set', 'nobody.x=1')).toMatch(/^2 .*no such node; it has .*toneMap/);
  expect(await refused(project, '--set', 'toneMap.x=1')).toMatch(/^2 .*no such parameter; it has .*exposure/);
  expect(await refused(project, '--set', 'toneMap')).toMatch(/^2 .*write node\.param=value/);
  expect(await refused(project, '--fly', '/A=0.5,0,0')).toMatch(/^2 .*--fly is for scene files/);
  expect(await refused(scene('movers.usda'), '--set', 'a.b=1')).toMatch(/^2 .*--set is for projects/);
  expect(await refused(at('none.slowlight.json'))).toMatch(/^3 .*no such file/);
  expect(await refused(projectOf(at('none.usda'), 'lost.slowlight.json'))).toMatch(
    /^3 .*there is no picture\n.*none\.usda/,
  );
});

test('check lists faults, upgrade preserves a project’s meaning, and docs cover every node', async () => {
  const damaged = JSON.parse(readFileSync(example('workshop'), 'utf8'));
  damaged.nodes.orbit.params.radius = -1;
  writeFileSync(at('bad.slowlight.json'), JSON.stringify(damaged));
  const { code, err } = await slowlight('graph', 'check', at('bad.slowlight.json'));
  expect((await slowlight('graph', 'check', at('bad.slowlight.json'), '--json')).code).toBe(3);
  expect(`${code} ${err}`).toMatch(/^3 .*orbit\.radius: -1 is outside/);
  writeFileSync(at('half.slowlight.json'), '{"format":"slowlight","version":3');
  expect((await slowlight('graph', 'check', at('half.slowlight.json'))).code).toBe(3);
  const several = [at('half.slowlight.json'), example('workshop'), at('bad.slowlight.json'), at('none.slowlight.json')];
  const all = await slowlight('graph', 'check', ...several);
  expect(all.code).toBe(3);
  expect(all.out).toMatch(/^\S*workshop\.slowlight\.json: \d+ nodes, nothing is wrong\n$/);
  for (const wrong of [
    /half\.slowlight\.json: /,
    /bad\.slowlight\.json: orbit\.radius/,
    /none\.slowlight\.json: no such file/,
  ])
    expect(all.err).toMatch(wrong);
  const list = JSON.parse((await slowlight('graph', 'check', ...several, '--json')).out);
  expect(list).toMatchObject([
    { nodes: 0, error: expect.stringContaining('half') },
    { faults: [] },
    { faults: [{ place: 'orbit.radius' }] },
    { error: expect.stringContaining('no such file') },
  ]);

  const old = {
    format: 'slowlight',
    version: 1,
    nodes: {
      read: { type: 'read', params: {} },
      retime: { type: 'retime', params: {} },
      scene: { type: 'scene', params: {} },
    },
  };
  const edge = (from: string, to: string) => [
    `${to}.scene`,
    { from: { node: from, output: 'scene' }, to: { node: to, input: 'scene' } },
  ];
  const edges = Object.fromEntries([edge('read', 'retime'), edge('retime', 'scene')]);
  writeFileSync(at('old.slowlight.json'), JSON.stringify({ ...old, edges, layout: {} }));
  expect((await slowlight('graph', 'upgrade', at('old.slowlight.json'), '-o', at('new.slowlight.json'))).code).toBe(0);
  expect((await slowlight('graph', 'check', at('new.slowlight.json'))).code).toBe(0);
  expect(Object.keys(JSON.parse(readFileSync(at('new.slowlight.json'), 'utf8')).edges)).toEqual([
    'retime.geometry',
    'scene.geometry.1',
  ]);

  const page = new URL('../../docs/guide/nodes.md', import.meta.url);
  const { out } = await slowlight('graph', 'docs');
  expect(readFileSync(page, 'utf8')).toBe(out);
  expect((await slowlight('graph', 'docs', 'nothing')).code).toBe(2);
});
