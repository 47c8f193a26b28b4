import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { panoramaProject, utilityProject } from '../../tests/support/exampleGraphs.ts';
import { saying } from '../../tests/support/inWords.ts';
import { validateDocument } from '../graph/analysis/validate.ts';
import type { ParamValue } from '../graph/document/document.ts';
import { parseDocument } from '../graph/document/parse.ts';
import { serializeDocument } from '../graph/document/serialize.ts';
import { applyCommand, type Command } from '../graph/edits/commands.ts';
import { Evaluator } from '../graph/evaluation/evaluator.ts';
import { type NodeType, resolveParams, valueError } from '../graph/nodeType.ts';
import { inEnglish, type LocalizedText, msg } from '../messages/message.ts';
import { makeMaterial, makeObject, restingAt } from '../scene/defaults.ts';
import { EFFECTS } from '../scene/frameGraph/effects.ts';
import { box } from '../scene/mesh/primitives.ts';
import { InputError, type Scene } from '../scene/types.ts';
import { DEFAULT_SETTINGS } from '../scene/view/view.ts';
import { nodeLibrary } from './library.ts';
import { evaluatedPicture, pictureLens, renderSettings } from './pictures/renderSettings.ts';
import { flyCommand, flyNodesIn, newProject, openFileCommand, removeFlightCommand } from './project/projectCommands.ts';
import { type LoadedScene, type Services, workerServices } from './services.ts';

const folder = new URL('../../examples/', import.meta.url);
const scene: Scene = {
  name: 'test',
  upAxis: 'Y',
  metersPerUnit: 1,
  timeCodesPerSecond: 24,
  startTime: 0,
  endTime: 1,
  objects: [],
  materials: [makeMaterial({ name: 'grey' })],
  lights: [],
  cameras: [
    { path: '/cam', fovY: 1, motion: { kind: 'static', pose: { position: [0, 0, 0], orientation: [0, 0, 0, 1] } } },
  ],
  hints: {},
  diagnostics: [],
};
const serving = (loaded: LoadedScene): Services => ({ ...workerServices, readScene: async () => loaded });
const set = (node: string, param: string, value: ParamValue): Command => ({
  kind: 'set-param',
  node,
  param,
  value,
});

async function evaluate(loaded: LoadedScene, ...commands: Command[]) {
  const { document } = applyCommand(newProject('a.usda'), { kind: 'batch', commands });
  const evaluation = await new Evaluator(nodeLibrary).evaluate(document, 'output', serving(loaded));
  return { picture: evaluatedPicture(evaluation), evaluation };
}

it('the Camera node gives pictures the lens that is chosen', async () => {
  const chosen = async (...commands: Command[]) => {
    const { picture } = await evaluate({ scene }, set('camera', 'lens', 'dome'), ...commands);
    return picture && pictureLens(picture);
  };
  expect(await chosen(set('camera', 'aperture', 220), set('camera', 'domeTilt', 30))).toEqual({
    kind: 'fisheye',
    aperture: expect.closeTo((220 / 180) * Math.PI, 12),
    elevation: expect.closeTo(Math.PI / 3, 12),
  });
  expect(await chosen(set('camera', 'lens', 'cube-strip'))).toEqual({ kind: 'cube', layout: '6x1' });
  expect(await chosen(set('camera', 'lens', 'perspective'), set('camera', 'fieldOfView', 90))).toEqual({
    kind: 'perspective',
    fovY: expect.closeTo(Math.PI / 2, 12),
  });
});

/** What is the same in every language: a letter, a symbol, a number with its unit. */
const isUniversal = (text: string): boolean => !/\p{L}{3}/u.test(text);
const textsOf = (type: NodeType): LocalizedText[] => [
  type.title,
  type.help,
  ...Object.values(type.params).flatMap((spec) => [
    spec.title,
    ...(spec.help ? [spec.help] : []),
    ...(spec.kind === 'choice' ? spec.options.map((option) => option.title) : []),
    ...(spec.kind === 'number' ? Object.values(spec.as?.cases ?? {}).map(({ title }) => title) : []),
  ]),
  ...[...Object.values(type.inputs), ...Object.values(type.outputs)].flatMap(({ title }) => title ?? []),
];

describe('the library', () => {
  it('and the effects and settings are titled and explained by messages, not in one language', () => {
    const effects = Object.values(EFFECTS).flatMap(({ title, help, args }) => [
      title,
      help,
      ...args.map((arg) => arg.title),
    ]);
    const texts = [...Object.values(nodeLibrary).flatMap(textsOf), ...effects];
    expect(texts.filter((text) => typeof text === 'string' && !isUniversal(text))).toEqual([]);
    expect(texts.map(inEnglish)).not.toContain('');
  });

  it.each(Object.values(nodeLibrary))('$id is fully described', (type) => {
    expect(type.id).toMatch(/^[a-z-]+$/);
    for (const spec of Object.values(type.params)) {
      expect(valueError(spec, spec.default)).toBeUndefined();
      if (spec.onlyWhen) expect(type.params).toHaveProperty(spec.onlyWhen.param);
    }
  });

  it('every node is used by an example project, a flight, or the examples of tests', () => {
    const examples = readdirSync(folder).filter((name) => name.endsWith('.slowlight.json'));
    const projects = examples.map((name) => parseDocument(readFileSync(new URL(name, folder), 'utf8')));
    const levels = [utilityProject(), panoramaProject(), ...projects].flatMap((project) => [
      project,
      ...Object.values(project.groups),
    ]);
    const used = levels.flatMap(({ nodes }) => Object.values(nodes).map(({ type }) => type));
    expect([...new Set(used)].sort()).toEqual(Object.keys(nodeLibrary).sort());
  });

  it("the nodes' defaults are the renderer's", async () => {
    const { picture } = await evaluate({ scene: { ...scene, hints: { speedOfLight: DEFAULT_SETTINGS.speedOfLight } } });
    expect(renderSettings(picture!, 0)).toEqual(DEFAULT_SETTINGS);
  });
});

describe('motion', () => {
  const mesh = box([1, 1, 1]);
  const sampled = {
    kind: 'sampled',
    times: Float64Array.of(0, 1),
    poses: Float64Array.of(0, 0, 0, 0, 0, 0, 1, 20, 0, 0, 0, 0, 0, 1),
  } as const;
  const car = makeObject({ path: '/Car', mesh, motion: sampled });
  const house = makeObject({ path: '/House', mesh });
  const points = [mesh.positions, mesh.positions.map((x) => x + 28)];
  const cloth = makeObject({
    path: '/Cloth',
    mesh,
    motion: { kind: 'sampled-points', times: Float64Array.of(0, 1), origin: [0, 0, 0], points },
  });
  const loaded: LoadedScene = {
    scene: { ...scene, objects: [car, house, cloth] },
    fastest: { path: '/Cloth', time: 0.2, speed: 28 },
  };
  const flying = (path: string, ...more: Command[]) =>
    evaluate(loaded, flyCommand(newProject('a.usda'), path, 0), ...more);

  it('an animation retimed above c is rejected, with a remedy that works', async () => {
    const fast = await evaluate(loaded, set('retime', 'speed', 2), set('console', 'speedOfLight', 40));
    const result = fast.evaluation.results.get('console');
    expect(result).toMatchObject({
      problem: { code: 'motion.superluminal', message: saying(/1\.40 c at t = 0\.10/) },
    });
    const later = await evaluate(loaded, set('retime', 'speed', 2), set('retime', 'offset', 3));
    expect(later.picture).toMatchObject({ speedOfLight: 70.1, fastest: { speed: 56, time: 3.1 } });
    expect(later.picture?.scene.endTime).toBe(3.5);
  });

  it('a flight keeps its fraction of c at any c', async () => {
    for (const c of [40, 100]) {
      const { picture } = await flying('/House', set('console', 'speedOfLight', c));
      const house = picture?.scene.objects[1];
      expect(house).toMatchObject({ authoredIn: 'rest', motion: { kind: 'uniform', velocity: [0.8 * c, 0, 0] } });
      expect(picture?.fastest).toMatchObject({ path: '/House', speed: 0.8 * c });
    }
  });

  it('a flight replaces the object’s own motion', async () => {
    const first = { ...loaded, fastest: { path: '/Car', time: 0, speed: 50 } };
    const stop = [flyCommand(newProject('a.usda'), '/Car', 0), set('fly1', 'speed', 0)];
    const { picture } = await evaluate(first, ...stop, set('console', 'speedOfLight', 60));
    expect(picture?.fastest).toMatchObject({ path: '/Cloth', speed: expect.closeTo(28 * Math.sqrt(3), 3) });
  });

  it('a flight of an object that deforms too fast is rejected', async () => {
    const { evaluation } = await flying('/Cloth', set('console', 'speedOfLight', 60));
    const result = evaluation.results.get('fly1');
    expect(result).toMatchObject({ problem: { code: 'motion.superluminal', place: '/Cloth' } });
    const remedy = result?.status === 'failed' ? result.problem.remedy : undefined;
    // The cloth's own 28 √3 m/s leave 0.19 of 60 m/s.
    expect(remedy).toMatchObject({
      node: 'fly1',
      param: 'speed',
      value: expect.closeTo(1 - (28 * Math.sqrt(3)) / 60, 2),
    });
    const along = [1, 1, 1].map((x) => x / Math.sqrt(3));
    const slower = [set('fly1', 'direction', along), set('fly1', 'speed', remedy!.value)];
    expect((await flying('/Cloth', set('console', 'speedOfLight', 60), ...slower)).picture).toBeDefined();
  });

  it('a missing object and a zero direction are rejected', async () => {
    expect((await flying('/Gone')).evaluation.results.get('fly1')).toMatchObject({ problem: { code: 'fly.missing' } });
    const nowhere = await flying('/House', set('fly1', 'direction', [0, 0, 0]));
    expect(nowhere.evaluation.results.get('fly1')).toMatchObject({ problem: { code: 'fly.direction' } });
  });

  it('flights are chained, and each can be removed', () => {
    const empty = newProject('a.usda');
    const one = applyCommand(empty, flyCommand(empty, '/a', 0)).document;
    const two = applyCommand(one, flyCommand(one, '/b', 2)).document;
    expect(flyNodesIn(two)).toEqual(['fly1', 'fly2']);
    expect(validateDocument(two, nodeLibrary)).toEqual([]);
    expect(parseDocument(serializeDocument(two))).toEqual(two);
    const left = applyCommand(two, removeFlightCommand(two, 'fly1')).document;
    expect(flyNodesIn(left)).toEqual(['fly2']);
    expect(validateDocument(left, nodeLibrary)).toEqual([]);
    expect(applyCommand(left, removeFlightCommand(left, 'fly2')).document).toEqual(empty);
    expect(flyNodesIn(applyCommand(two, openFileCommand(two, 'b.usda')!).document)).toEqual([]);
  });

  it('variants are passed to the reader, and are part of the document', async () => {
    let asked: ReadonlyMap<string, string> | undefined;
    const services: Services = {
      ...workerServices,
      readScene: async (_, { variants }) => {
        asked = variants;
        return { scene };
      },
    };
    const choose: Command = { kind: 'set-param', node: 'read', param: 'variants', value: ['/Car{paint}=red', 'a=b=c'] };
    const { document } = applyCommand(newProject('a.usda'), choose);
    expect(parseDocument(serializeDocument(document))).toEqual(document);
    await new Evaluator(nodeLibrary).evaluate(document, 'output', services);
    expect([...(asked ?? [])]).toEqual([
      ['/Car{paint}', 'red'],
      ['a', 'b=c'],
    ]);
  });
});

describe('a material', () => {
  const painted = async (readFile: Services['readFile']) => {
    const { document } = applyCommand(newProject('a.usda'), {
      kind: 'batch',
      commands: [
        { kind: 'add-node', node: 'paint', type: 'material', at: [0, 0], params: { reflectance: 'leaf.csv' } },
        {
          kind: 'connect',
          edge: { from: { node: 'read', output: 'geometry' }, to: { node: 'paint', input: 'geometry' } },
        },
      ],
    });
    const loaded = { scene: { ...scene, objects: [makeObject({ path: '/leaf', mesh: box([1, 1, 1]) })] } };
    const services = { ...serving(loaded), readFile };
    return (await new Evaluator(nodeLibrary).evaluate(document, 'paint', services)).target;
  };

  it('takes its reflectance from a table, and its colour from the reflectance', async () => {
    const asked: string[] = [];
    const made = await painted(async (source) => {
      asked.push(source);
      return new TextEncoder().encode('nm, share\n300, 0.3\n900, 0.3\n');
    });
    expect(asked).toEqual(['leaf.csv']);
    const { materials } = (made as unknown as { outputs: { geometry: LoadedScene } }).outputs.geometry.scene;
    const material = materials.find(({ reflectance }) => reflectance)!;
    expect(material.reflectance?.values).toEqual([0.3, 0.3]);
    [...material.baseColor, material.ir].forEach((share) => {
      expect(share).toBeCloseTo(0.3, 6);
    });
  });

  it('reports a table that is missing or invalid', async () => {
    const missing = new InputError({ severity: 'error', code: 'file.missing', place: 'leaf.csv', message: msg`no` });
    expect(await painted(() => Promise.reject(missing))).toMatchObject({
      status: 'failed',
      problem: { code: 'file.missing', place: 'leaf.csv' },
    });
    expect(await painted(async () => new TextEncoder().encode('400, 40\n500, 60\n'))).toMatchObject({
      problem: { code: 'spectrum.csv' },
    });
  });
});

describe('the project', () => {
  it('is a valid document that round-trips through a file', () => {
    const project = newProject('a.usda');
    expect(validateDocument(project, nodeLibrary)).toEqual([]);
    expect(parseDocument(serializeDocument(project))).toEqual(project);
  });

  it('takes the speed of light from the user, else from the file, else from the scene’s speeds', async () => {
    const hinted = { scene: { ...scene, hints: { speedOfLight: 12 } } };
    const fast = { scene, fastest: { path: '/a', time: 1, speed: 400 } };
    expect((await evaluate(hinted)).picture?.speedOfLight).toBe(12);
    expect((await evaluate(hinted, set('console', 'speedOfLight', 50))).picture?.speedOfLight).toBe(50);
    expect((await evaluate({ scene })).picture?.speedOfLight).toBe(30);
    expect((await evaluate(fast)).picture?.speedOfLight).toBe(501);
  });

  it('rejects motion faster than light at its node, with a remedy that works', async () => {
    const loaded = { scene, fastest: { path: '/World/Cube', time: 2, speed: 13.1 } };
    const { evaluation, picture } = await evaluate(loaded, set('console', 'speedOfLight', 10));
    expect(picture).toBeUndefined();
    const result = evaluation.results.get('console');
    expect(result).toMatchObject({
      status: 'failed',
      problem: {
        code: 'motion.superluminal',
        place: '/World/Cube',
        message: saying('1.31 c at t = 2'),
      },
    });
    const remedy = result?.status === 'failed' ? result.problem.remedy! : undefined;
    const repaired = await evaluate(loaded, set('console', 'speedOfLight', 10), { kind: 'set-param', ...remedy! });
    expect(repaired.picture?.speedOfLight).toBe(13.2);
  });

  it('rejects a body that extends behind its own horizon', async () => {
    const mesh = box([200, 1, 1]);
    const motion = { ...restingAt([0, 0, 0]), kind: 'hyperbolic', properAcceleration: [9, 0, 0], t0: 0 } as const;
    const rocket = makeObject({ path: '/rocket', mesh, motion, authoredIn: 'rest' });
    const { evaluation } = await evaluate(
      { scene: { ...scene, objects: [rocket] } },
      set('console', 'speedOfLight', 20),
    );
    expect(evaluation.results.get('console')).toMatchObject({ problem: { code: 'motion.horizon' } });
  });

  it('provides a camera if the file has none', async () => {
    const { picture } = await evaluate({ scene: { ...scene, cameras: [] } });
    expect(picture?.scene.cameras.map(({ path }) => path)).toEqual(['/FramingCamera']);
  });

  it('rejects a missing camera', async () => {
    const { evaluation } = await evaluate({ scene }, set('camera', 'camera', '/gone'));
    expect(evaluation.results.get('camera')).toMatchObject({ problem: { message: saying('/cam') } });
  });

  it('passes on a reader’s diagnostic unchanged, and blocks downstream nodes', async () => {
    const services: Services = {
      ...workerServices,
      readScene: async () => {
        throw new InputError({
          severity: 'error',
          code: 'file.empty',
          place: 'a.usda',
          message: msg`the file is empty`,
        });
      },
    };
    const evaluation = await new Evaluator(nodeLibrary).evaluate(newProject('a.usda'), 'output', services);
    expect(evaluation.results.get('read')).toMatchObject({ problem: { code: 'file.empty', place: 'a.usda' } });
    expect(evaluation.target.status).toBe('blocked');
  });

  it('opening another file resets to that file’s suggestions', () => {
    const before = applyCommand(newProject('a.usda'), set('console', 'speedOfLight', 5)).document;
    const { document } = applyCommand(before, openFileCommand(before, 'b.usda')!);
    expect(
      resolveParams(nodeLibrary['relativity-console']!, document.nodes.console!.params).speedOfLight,
    ).toBeUndefined();
    expect(document.nodes.read!.params.source).toBe('b.usda');
  });
});
