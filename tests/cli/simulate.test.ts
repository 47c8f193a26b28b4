import { readFileSync, statSync, truncateSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { add, build, connect, set } from '../support/graphKit.ts';
import { hasUsdCore, python } from '../support/pythonOracles.ts';
import { outputFolder, programResult, slowlight, slowlightJson, start } from './program.ts';

const folder = outputFolder();
const at = (name: string): string => join(folder, name);
const project = at('cloth.slowlight.json');
const cloth = build(
  ...[add('sheet', 'grid'), add('cloth', 'mass-spring'), add('weight', 'field'), add('run', 'simulate')],
  ...[set('sheet', 'width', 1), set('sheet', 'length', 1), set('cloth', 'pins', 'corners')],
  ...[set('run', 'duration', 0.5), set('run', 'method', 'leapfrog')],
  ...[connect('sheet.geometry', 'cloth.geometry'), connect('cloth.matter', 'run.matter.1')],
  connect('weight.matter', 'run.matter.2'),
);
writeFileSync(project, serializeDocument(cloth));

test('a simulation is written as USD readable by usd-core, and as a table of energies', async () => {
  const made = await slowlightJson<{ files: string[]; frames: number; energyChange: number; fastest: number }>(
    ...['simulate', project, '-o', at('cloth.usda'), '--csv', at('energy.csv')],
  );
  expect(made).toMatchObject({ files: [at('cloth.usda'), at('energy.csv')], frames: 13, method: 'leapfrog' });
  expect(made.energyChange).toBeLessThan(1e-3);
  const rows = readFileSync(at('energy.csv'), 'utf8').trim().split('\n');
  expect(rows).toHaveLength(14);
  expect(rows[0]).toMatch(/^time \[s\],steps,kinetic energy \[J\]/);
  const read = await slowlightJson<{ objects: { path: string }[] }>('inspect', at('cloth.usda'));
  expect(JSON.stringify(read)).toContain('/Grid');
  if (!hasUsdCore()) return;
  const [times, low, fast] = JSON.parse(
    python(
      '-c',
      `
import json
from pxr import Usd, UsdGeom
stage = Usd.Stage.Open(r'${at('cloth.usda')}')
mesh = UsdGeom.Mesh(next(p for p in stage.Traverse() if p.IsA(UsdGeom.Mesh)))
points, velocities = mesh.GetPointsAttr(), mesh.GetVelocitiesAttr()
codes = points.GetTimeSamples()
world = UsdGeom.Xformable(mesh).ComputeLocalToWorldTransform(codes[-1])
print(json.dumps([codes, min(world.Transform(p)[1] for p in points.Get(codes[-1])), max(v.GetLength() for v in velocities.Get(codes[-1]))]))`,
    ),
  ) as [number[], number, number];
  expect(times).toEqual(Array.from({ length: 13 }, (_, k) => k));
  expect(low).toBeLessThan(-0.02);
  expect(fast).toBeCloseTo(Number(rows.at(-1)!.split(',').at(-2)), 4);
});

test('what drag takes is told apart from what the method loses, and energy that went wrong is told', async () => {
  const figures = async (...more: string[]) =>
    slowlightJson<{ energyChange: number; energyDrift: number; dragLoss: number; corrected?: number }>(
      ...['simulate', project, '--csv', at('drag.csv'), ...more.flatMap((each) => ['--set', each])],
    );
  const damped = await figures('weight.drag=3', 'run.method=discrete-gradient');
  expect(damped.energyChange).toBeGreaterThan(0.3);
  expect(damped.energyDrift).toBeLessThan(1e-12);
  expect(Number(readFileSync(at('drag.csv'), 'utf8').trim().split(',').at(-1))).toBe(damped.dragLoss);
  expect(damped).not.toHaveProperty('energyFault');
  const implicit = ['run.method=linearly-implicit', 'run.step=0.01', 'run.duration=2'];
  const fading = await figures(...implicit, 'run.correction=2');
  expect(fading).toMatchObject({
    ...{ corrected: 0, dragLoss: 0 },
    energyFault: { kind: 'lost', message: expect.stringMatching(/energy is missing .* an error of the method/) },
  });
  const kept = await figures(...implicit, 'run.correction=3');
  expect(kept.energyDrift).toBeLessThan(1e-11);
  // 48 frames of 5 steps.
  expect(kept.corrected).toBe(240);
});

test('a GPU computes a simulation, also one that a project’s picture needs', async () => {
  const figures = async (...more: string[]) =>
    slowlightJson<{ onGpu: boolean; fastest: number; until: number }>(
      ...['simulate', project, '--csv', at('gpu.csv'), '--set', 'run.duration=0.25', ...more],
    );
  const [gpu, processor] = [await figures('--set', 'run.onGpu=true'), await figures()];
  expect([gpu.onGpu, processor.onGpu]).toEqual([true, false]);
  expect(gpu.until).toBe(0.25);
  expect(gpu.fastest).not.toBe(processor.fastest);
  expect(Math.abs(gpu.fastest / processor.fastest - 1)).toBeLessThan(1e-5);
  const seen = ['examples/hanging-cloth.slowlight.json', '-o', at('seen.png'), '--size', '80x60'];
  const drawn = await slowlight('render', ...seen, '--set', 'swing.onGpu=true', '--set', 'swing.duration=0.1');
  expect(drawn.code, drawn.err).toBe(0);
  expect(statSync(at('seen.png')).size).toBeGreaterThan(1000);
});

test('a stopped run resumes from its checkpoint, to the same bits', async () => {
  const args = ['simulate', project, '--set', 'run.duration=2', '--set', 'run.method=discrete-gradient', '--csv'];
  await slowlight(...args, at('whole.csv'));
  const child = start(...args, at('part.csv'), '--checkpoint', at('cloth.run'));
  const ended = programResult(child);
  for (let size = 0; size < 100_000; size = statSync(at('cloth.run'), { throwIfNoEntry: false })?.size ?? 0)
    await new Promise((resolve) => setTimeout(resolve, 20));
  child.kill('SIGINT');
  const { code, err } = await ended;
  expect(code, err).toBe(130);
  expect(err).toMatch(/stopped after \d+ of 49 frames; --resume goes on from/);
  // A partially written frame is computed again.
  truncateSync(at('cloth.run'), statSync(at('cloth.run')).size - 7);
  const rest = await slowlight(...args, at('part.csv'), '--checkpoint', at('cloth.run'), '--resume');
  expect(rest.code, rest.err).toBe(0);
  expect(readFileSync(at('part.csv'), 'utf8')).toBe(readFileSync(at('whole.csv'), 'utf8'));
  const other = [...args, at('part.csv'), '--checkpoint', at('cloth.run'), '--resume', '--set', 'cloth.mass=2'];
  const { code: refused, err: why } = await slowlight(...other);
  expect(refused).toBe(3);
  expect(why).toMatch(/another simulation/);
});

test('a run with adaptive steps resumes to the same bits too, and can be extended', async () => {
  const args = ['simulate', project, '--set', 'run.tolerance=0.01', '--csv'];
  const short = await slowlight(...args, at('long.csv'), '--checkpoint', at('adaptive.run'));
  expect(short.code, short.err).toBe(0);
  const longer = ['--set', 'run.duration=1'];
  await slowlight(...args, at('whole.csv'), ...longer);
  const rest = await slowlight(...args, at('long.csv'), ...longer, '--checkpoint', at('adaptive.run'), '--resume');
  expect(rest.code, rest.err).toBe(0);
  const rows = readFileSync(at('long.csv'), 'utf8');
  expect(rows).toBe(readFileSync(at('whole.csv'), 'utf8'));
  expect(rows.trim().split('\n')).toHaveLength(26);
});

test('a run that stops early is written up to its last valid frame, with its own exit code', async () => {
  const steps = [
    '--set',
    'run.method=semi-implicit-euler',
    '--set',
    'run.step=0.02',
    '--set',
    'run.speedOfLight=1',
    '--set',
    'run.duration=2',
  ];
  const { code, out, err } = await slowlight('simulate', project, '--csv', at('ended.csv'), '--json', ...steps);
  expect(code, err).toBe(6);
  const { stop, frames } = JSON.parse(out);
  expect(stop).toMatchObject({ reason: expect.any(String), message: expect.any(String) });
  expect(err).toContain('it ended at t = ');
  expect(readFileSync(at('ended.csv'), 'utf8').trim().split('\n')).toHaveLength(frames + 1);
});

test.each([
  ['nothing to write', [], 2, /-o.*--csv/],
  ['no checkpoint to resume from', ['--csv', at('x.csv'), '--resume'], 2, /--checkpoint/],
  ['a checkpoint that is none', ['--csv', at('x.csv'), '--checkpoint', project, '--resume'], 3, /no checkpoint/],
  ['another kind of file', ['-o', at('x.png')], 2, /\.usda/],
  ['no such node', ['--csv', at('x.csv'), '--node', 'cloth'], 2, /there is run/],
  ['no folder', ['--csv', at('nowhere/x.csv')], 3, /there is no folder/],
  ['what a node refuses', ['--csv', at('x.csv'), '--set', 'cloth.which=/Gone'], 3, /cloth\.which: there is nothing at/],
])('nothing is written: %s', async (_, args, expectedCode, message) => {
  const { code, err } = await slowlight('simulate', project, ...args);
  expect(code, err).toBe(expectedCode);
  expect(err).toMatch(message);
});
