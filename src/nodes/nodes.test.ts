import { describe, expect, it } from 'vitest';
import { applyCommand, type Command } from '../graph/commands.ts';
import { parseDocument, serializeDocument } from '../graph/document.ts';
import { Evaluator } from '../graph/evaluate.ts';
import { refuseValue, resolveParams } from '../graph/nodeType.ts';
import { validateDocument } from '../graph/validate.ts';
import { makeMaterial, makeObject, restingAt } from '../scene/defaults.ts';
import { box } from '../scene/primitives.ts';
import { InputError, type Scene } from '../scene/types.ts';
import { DEFAULT_SETTINGS, type ViewPoint } from '../scene/view.ts';
import { nodeLibrary } from './library.ts';
import { stopsOfMotion } from './metering.ts';
import { pictureOf, renderSettings } from './picture.ts';
import { newProject, openCommand } from './project.ts';
import type { LoadedScene, Services } from './services.ts';

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
const atRest: ViewPoint = { t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: [0, 0, 0, 1], fovY: 1 };
const serving = (loaded: LoadedScene): Services => ({ readScene: async () => loaded });
const set = (node: string, param: string, value: string | number | boolean): Command => ({
  kind: 'set-param',
  node,
  param,
  value,
});

async function evaluate(loaded: LoadedScene, ...commands: Command[]) {
  const { document } = applyCommand(newProject('a.usda'), { kind: 'batch', commands });
  const evaluation = await new Evaluator(nodeLibrary).evaluate(document, 'output', serving(loaded));
  return { picture: pictureOf(evaluation), evaluation };
}

describe('the library', () => {
  it.each(Object.values(nodeLibrary))('$id describes itself fully', (type) => {
    expect(type.id).toMatch(/^[a-z-]+$/);
    for (const spec of Object.values(type.params)) {
      expect(refuseValue(spec, spec.default)).toBeUndefined();
      if (spec.onlyWhen) expect(type.params).toHaveProperty(spec.onlyWhen.param);
    }
  });

  it('every node is exercised by the project that the page opens with', () => {
    const used = new Set(Object.values(newProject().nodes).map((node) => node.type));
    expect([...used].sort()).toEqual(Object.keys(nodeLibrary).sort());
  });

  it("the nodes' defaults are the renderer's", async () => {
    const { picture } = await evaluate({ scene: { ...scene, hints: { speedOfLight: DEFAULT_SETTINGS.speedOfLight } } });
    expect(renderSettings(picture!, atRest, 1.5)).toEqual(DEFAULT_SETTINGS);
  });
});

describe('the exposure', () => {
  const fast: ViewPoint = { ...atRest, u: [0, 0, -2] };

  it('follows the brightness that the velocity gives, where asked to', async () => {
    const { picture } = await evaluate({ scene });
    const still = await evaluate({ scene }, set('toneMap', 'adapt', false));
    expect(renderSettings(picture!, fast, 1.5).exposure).toBeLessThan(-2);
    expect(renderSettings(picture!, { ...fast, u: [0, 0, 2] }, 1.5).exposure).toBeGreaterThan(2);
    expect(renderSettings(still.picture!, fast, 1.5).exposure).toBe(0);
  });

  it('is that of the brightness straight ahead in a narrow picture: D = γ(1 + β) = e^ζ', () => {
    const narrow = { ...fast, fovY: 1e-6 };
    expect(stopsOfMotion(narrow, 1, true)).toBeCloseTo((4 * Math.asinh(2)) / Math.LN2, 6);
    expect(stopsOfMotion(narrow, 1, false)).toBeCloseTo((4 * Math.asinh(2)) / Math.LN2, 6);
  });
});

describe('the project', () => {
  it('is a whole document that comes back from its file', () => {
    const project = newProject('a.usda');
    expect(validateDocument(project, nodeLibrary)).toEqual([]);
    expect(parseDocument(serializeDocument(project))).toEqual(project);
  });

  it('takes the speed of light from the person, else the file, else what fits', async () => {
    const hinted = { scene: { ...scene, hints: { speedOfLight: 12 } } };
    const fast = { scene, fastest: { path: '/a', time: 1, speed: 400 } };
    expect((await evaluate(hinted)).picture?.speedOfLight).toBe(12);
    expect((await evaluate(hinted, set('console', 'speedOfLight', 50))).picture?.speedOfLight).toBe(50);
    expect((await evaluate({ scene })).picture?.speedOfLight).toBe(30);
    expect((await evaluate(fast)).picture?.speedOfLight).toBe(501);
  });

  it('refuses what is faster than light at its place, with a remedy that works', async () => {
    const loaded = { scene, fastest: { path: '/World/Cube', time: 2, speed: 13.1 } };
    const { evaluation, picture } = await evaluate(loaded, set('console', 'speedOfLight', 10));
    expect(picture).toBeUndefined();
    const result = evaluation.results.get('console');
    expect(result).toMatchObject({
      status: 'failed',
      problem: {
        code: 'motion.superluminal',
        place: '/World/Cube',
        message: expect.stringContaining('1.31 c at t = 2'),
      },
    });
    const remedy = result?.status === 'failed' ? result.problem.remedy! : undefined;
    const repaired = await evaluate(loaded, set('console', 'speedOfLight', 10), { kind: 'set-param', ...remedy! });
    expect(repaired.picture?.speedOfLight).toBe(13.2);
  });

  it('refuses a body that would reach behind its own horizon', async () => {
    const mesh = box([200, 1, 1]);
    const motion = { ...restingAt([0, 0, 0]), kind: 'hyperbolic', properAcceleration: [9, 0, 0], t0: 0 } as const;
    const rocket = makeObject({ path: '/rocket', mesh, motion, authoredIn: 'rest' });
    const { evaluation } = await evaluate(
      { scene: { ...scene, objects: [rocket] } },
      set('console', 'speedOfLight', 20),
    );
    expect(evaluation.results.get('console')).toMatchObject({ problem: { code: 'motion.horizon' } });
  });

  it('brings a camera where the file has none', async () => {
    const { picture } = await evaluate({ scene: { ...scene, cameras: [] } });
    expect(picture?.scene.cameras.map(({ path }) => path)).toEqual(['/FramingCamera']);
  });

  it('refuses a camera that is not there', async () => {
    const { evaluation } = await evaluate({ scene }, set('camera', 'camera', '/gone'));
    expect(evaluation.results.get('camera')).toMatchObject({ problem: { message: expect.stringContaining('/cam') } });
  });

  it('keeps a reader’s diagnostic as it is, and blocks what follows', async () => {
    const services: Services = {
      readScene: async () => {
        throw new InputError({ severity: 'error', code: 'file.empty', place: 'a.usda', message: 'the file is empty' });
      },
    };
    const evaluation = await new Evaluator(nodeLibrary).evaluate(newProject('a.usda'), 'output', services);
    expect(evaluation.results.get('read')).toMatchObject({ problem: { code: 'file.empty', place: 'a.usda' } });
    expect(evaluation.target.status).toBe('blocked');
  });

  it('opening another file gives way to its own suggestions', () => {
    const before = applyCommand(newProject('a.usda'), set('console', 'speedOfLight', 5)).document;
    const { document } = applyCommand(before, openCommand('b.usda'));
    expect(
      resolveParams(nodeLibrary['relativity-console']!, document.nodes.console!.params).speedOfLight,
    ).toBeUndefined();
    expect(document.nodes.read!.params.source).toBe('b.usda');
  });
});
