import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { AT_REST } from '../../../tests/support/flightFixtures.ts';
import { edited, set } from '../../../tests/support/graphKit.ts';
import { saying } from '../../../tests/support/inWords.ts';
import { savingProject } from '../../../tests/support/savingGraph.ts';
import { flightOf } from '../../flight/flightState.ts';
import { planTrip } from '../../flight/trip.ts';
import type { Command } from '../../graph/edits/commands.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import type { NodeResult } from '../../graph/evaluation/resultCache.ts';
import { msg } from '../../messages/message.ts';
import { InputError } from '../../scene/types.ts';
import { serializeFlight } from '../flights/flightFile.ts';
import { nodeLibrary } from '../library.ts';
import { evaluatedPicture } from '../pictures/renderSettings.ts';
import { fileNodesIn, requestedFiles } from '../project/fileNodes.ts';
import {
  type FrameTime,
  frameCount,
  frameTimes,
  type RequestedFile,
  type VideoOutput,
} from '../project/outputFiles.ts';
import { workerServices } from '../services.ts';

async function evaluated(...commands: readonly Command[]) {
  const document = edited(savingProject(), ...commands);
  const writers = fileNodesIn(document);
  const evaluation = await new Evaluator(nodeLibrary).evaluate(document, ['output', ...writers.keys()], workerServices);
  return { evaluation, files: requestedFiles(evaluation, writers) };
}
const asked = async (node: string, ...commands: readonly Command[]): Promise<RequestedFile> =>
  (await evaluated(...commands)).files.get(node)!;
const refusalOf = async (node: string, ...commands: readonly Command[]): Promise<NodeResult> =>
  (await evaluated(...commands)).evaluation.results.get(node)!;

describe('the nodes that save pictures', () => {
  it('request the displayed picture, and pass it on', async () => {
    const { evaluation, files } = await evaluated();
    const picture = evaluatedPicture(evaluation)!;
    expect(picture.speedOfLight).toBe(10);
    const size = { width: 64, height: 48 };
    expect(files.get('still')).toEqual({ kind: 'image', name: 'picture.png', picture, ...size, samples: 2, time: 0.5 });
    const span = { from: 0.25, to: 0.75, fps: 8, spacing: 'world', stayInPlace: false };
    expect(files.get('film')).toEqual({ kind: 'video', name: 'film.mp4', picture, ...size, samples: 1, ...span });
  });

  it('default to the scene’s time', async () => {
    const unset = ['from', 'to', 'fps'].map((param) => set('film', param));
    const clock = [
      { kind: 'add-node', node: 'clock', type: 'time', at: [0, 0] },
      { kind: 'connect', edge: { from: { node: 'clock', output: 'time' }, to: { node: 'scene', input: 'time' } } },
      ...[set('clock', 'from', 1), set('clock', 'to', 4), set('clock', 'openAt', 2)],
    ] as const;
    expect(await asked('film', ...unset, ...clock)).toMatchObject({ from: 1, to: 4, fps: 24 });
    expect(await asked('still', set('still', 'time'), ...clock)).toMatchObject({ time: 2 });
  });

  it.each([
    ['still', 'name', 'a.mp4', 'file.name', { param: 'name', value: 'a.png' }],
    ['still', 'name', '../a.png', 'file.name', { param: 'name', value: 'a.png' }],
    ['still', 'name', 'a.####.png', 'file.frame', { param: 'name', value: 'a.png' }],
    ['still', 'name', '##.png', 'file.frame', { param: 'name', value: 'picture.png' }],
    ['film', 'name', 'a.png', 'file.frame', { param: 'name', value: 'a.####.png' }],
    ['film', 'name', 'a.avi', 'file.name', { param: 'name', value: 'a.mp4' }],
    ['film', 'width', 65, 'file.even', { param: 'width', value: 66 }],
    ['film', 'to', 0, 'file.span', { param: 'to', value: 0.25 }],
    ['film', 'to', 1e9, 'file.frames', { param: 'to', value: 0.25 + 65_535 / 8 }],
  ])('%s.%s = %s is rejected, with a remedy that works', async (node, param, value, code, remedy) => {
    const bad = set(node, param, value);
    expect(await refusalOf(node, bad)).toMatchObject({
      status: 'failed',
      problem: { code, remedy: { node, ...remedy } },
    });
    expect(await refusalOf(node, bad, set(node, remedy.param, remedy.value))).toMatchObject({ status: 'done' });
  });

  it.each([
    ['fps', 60, 'file.rate', 50],
    ['fps', 0.001, 'file.rate', 0.002],
    ['width', 5000, 'file.size', 4096],
  ])('a GIF of %s %s is rejected, with a remedy that works', async (param, value, code, remedy) => {
    const gif = [set('film', 'name', 'a.gif'), set('film', 'width', 65)];
    expect(await asked('film', ...gif)).toMatchObject({ kind: 'video', name: 'a.gif', width: 65 });
    const bad = set('film', param, value);
    expect(await refusalOf('film', ...gif, bad)).toMatchObject({
      problem: { code, remedy: { node: 'film', param, value: remedy } },
    });
    expect(await refusalOf('film', ...gif, bad, set('film', param, remedy))).toMatchObject({ status: 'done' });
  });

  it('film all of a flight, whose clock and speed of light are its own', async () => {
    // 20 m from rest to rest with 5 m/s²: τ = (2c/a) acosh(1 + ad/2c²), t = √((d/c)² + 4d/a).
    const [d, a] = [20, 5];
    const flightAt = (c: number): string => {
      const start = flightOf(AT_REST);
      const arcs = planTrip(start, [d, 0, 0], { c, acceleration: a, limit: 10 });
      return serializeFlight({ legs: [{ conditions: { c, lock: 'free', playing: true }, start, arcs }] });
    };
    const film = async (text: string, ...commands: readonly Command[]): Promise<NodeResult> => {
      const readFile = async (name: string) => {
        if (name === 'a.flight.json') return new TextEncoder().encode(text);
        throw new InputError({ severity: 'error', code: 'file.missing', place: name, message: msg`it does not exist` });
      };
      const document = edited(savingProject(), set('film', 'flight', 'a.flight.json'), ...commands);
      const evaluator = new Evaluator(nodeLibrary);
      const evaluation = await evaluator.evaluate(document, ['film'], { ...workerServices, readFile });
      return evaluation.results.get('film')!;
    };
    const fileOf = (result: NodeResult) =>
      result.status === 'done' ? (result.outputs.file as VideoOutput) : undefined;
    const world = fileOf(await film(flightAt(10)))!;
    expect(world.from).toBe(0);
    expect(world.to).toBeCloseTo(Math.sqrt((d / 10) ** 2 + (4 * d) / a), 9);
    const proper = fileOf(await film(flightAt(10), set('film', 'spacing', 'proper')))!;
    expect(proper.to).toBeCloseTo((20 / a) * Math.acosh(1 + (a * d) / 200), 9);
    expect(await film(flightAt(20))).toMatchObject({
      problem: { code: 'file.flight', message: saying(/flown at 20 m\/s/) },
    });
    expect(await film('{}')).toMatchObject({ problem: { message: saying(/a\.flight\.json: slowlight/) } });
    expect(await film('{}', set('film', 'flight', 'b.flight.json'))).toMatchObject({
      problem: { place: 'b.flight.json', remedy: { param: 'flight', value: '' } },
    });
  });

  it('false colours cannot be saved as light', async () => {
    const light = set('still', 'name', 'a.exr');
    expect(await refusalOf('still', light)).toMatchObject({ status: 'done' });
    const falsely = [
      { kind: 'add-node', node: 'false', type: 'false-colour', at: [0, 0] },
      set('false', 'of', 'doppler'),
      { kind: 'connect', edge: { from: { node: 'tone', output: 'image' }, to: { node: 'false', input: 'image' } } },
      { kind: 'connect', edge: { from: { node: 'false', output: 'image' }, to: { node: 'still', input: 'image' } } },
    ] as const;
    expect(await refusalOf('still', light, ...falsely)).toMatchObject({
      problem: { code: 'file.falseColour', remedy: { value: 'a.png' } },
    });
  });
});

describe('the frames of a film', () => {
  const frames = (from: number, to: number, fps: number): readonly FrameTime[] =>
    frameTimes({ kind: 'video', from, to, fps } as VideoOutput);

  it('are numbered as by the command line: frame n at n/fps', () => {
    expect(frames(0, 0.1, 24)).toEqual([0, 1, 2].map((number) => ({ number, t: number / 24 })));
    expect(frames(2, 2, 24)).toEqual([{ number: 48, t: 2 }]);
    expect(frames(0.1, 0.3, 10)).toEqual([1, 2, 3].map((number) => ({ number, t: number / 10 })));
    expect(frames(-0.1, 0, 10).map(({ number }) => number)).toEqual([-1, 0]);
  });

  it('start at the first time, and include every frame up to the last time', () => {
    const numbers = {
      from: fc.double({ min: -100, max: 100, noNaN: true }),
      length: fc.double({ min: 0, max: 20, noNaN: true }),
    };
    fc.assert(
      fc.property(
        fc.record({ ...numbers, fps: fc.double({ min: 0.5, max: 120, noNaN: true }) }),
        ({ from, length, fps }) => {
          const all = frames(from, from + length, fps);
          expect(all).toHaveLength(frameCount({ from, to: from + length, fps }));
          expect(all[0]!.t).toBeCloseTo(from, 5);
          expect(all.at(-1)!.t).toBeLessThanOrEqual(from + length + 1e-5 / fps + 1e-5);
          expect(all.at(-1)!.t + 1 / fps).toBeGreaterThan(from + length - 1e-5);
        },
      ),
    );
  });
});
