import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { add, connect, edited, set } from '../../../tests/support/graphKit.ts';
import { saying } from '../../../tests/support/inWords.ts';
import type { ParamValue } from '../../graph/document/document.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { observerPathFrom } from '../../scene/view/observerPath.ts';
import { nodeLibrary } from '../library.ts';
import { evaluatedPicture, initialBeta, pictureCamera } from '../pictures/renderSettings.ts';
import { newProject } from '../project/projectCommands.ts';
import { workerServices } from '../services.ts';

const C = 10;

/** A project without a file: a camera at (3, 2, 6) that looks along −Z, moved by a node of a type, and ridden. */
async function ridden(
  type: string,
  params: Readonly<Record<string, ParamValue>>,
  which = '',
  twice = false,
  smooth = true,
) {
  const setAll = (node: string, values: Readonly<Record<string, ParamValue>>) =>
    Object.entries(values).map(([param, value]) => ({ kind: 'set-param', node, param, value }) as const);
  const project = edited(
    newProject(),
    { kind: 'remove-nodes', nodes: ['read', 'retime'] },
    add('eye', 'camera'),
    add('course', type),
    add('mover', 'move'),
    ...setAll('eye', { target: [3, 2, 0] }),
    ...setAll('course', params),
    ...setAll('console', { speedOfLight: C }),
    ...setAll('camera', { ride: true, smooth }),
    connect('eye.geometry', 'mover.geometry'),
    connect('course.motion', 'mover.motion'),
    set('mover', 'which', which),
    ...(twice
      ? [
          add('again', 'move'),
          connect('mover.geometry', 'again.geometry'),
          connect('course.motion', 'again.motion'),
          connect('again.geometry', 'scene.geometry'),
        ]
      : [connect('mover.geometry', 'scene.geometry')]),
  );
  const evaluation = await new Evaluator(nodeLibrary).evaluate(project, 'output', workerServices);
  const picture = evaluatedPicture(evaluation);
  if (!picture) return { evaluation };
  const beta = initialBeta(picture, true);
  const setup = { camera: pictureCamera(picture), ...(beta && { beta }) };
  return { evaluation, picture, path: observerPathFrom(setup, C, 0) };
}

const coordinate = fc.double({ min: -5, max: 5, noNaN: true });
const vector = fc.tuple(coordinate, coordinate, coordinate);

describe('a camera in a Motion node, ridden', () => {
  it('has the proper velocity at/c of hyperbolic motion, and its place', async () => {
    await fc.assert(
      fc.asyncProperty(vector, fc.double({ min: -20, max: 20, noNaN: true }), async (a, t) => {
        const { path } = await ridden('motion-hyperbolic', { acceleration: a });
        const { position, u } = path!(t);
        const size = Math.hypot(...a);
        // x = (c²/a)(cosh(aτ/c) − 1), where sinh(aτ/c) = at/c.
        const along = size === 0 ? 0 : (C * C * (Math.cosh(Math.asinh((size * t) / C)) - 1)) / size;
        [3, 2, 6].forEach((x, k) => {
          expect(position[k]).toBeCloseTo(x + (size === 0 ? 0 : (along * a[k]!) / size), 6);
          expect(u[k]).toBeCloseTo((a[k]! * t) / C, 9);
        });
      }),
      { numRuns: 20 },
    );
  });

  it('moves uniformly', async () => {
    const { path } = await ridden('motion-uniform', { velocity: [0, 0, -6] });
    expect(path!(2)).toMatchObject({ position: [3, 2, -6], u: [0, 0, expect.closeTo(-0.75, 12)] });
  });

  it('is carried around, with the speed of its circle', async () => {
    const { path, picture } = await ridden('motion-circular', { radius: 4, speed: 6, to: 6, facing: false });
    expect(picture!.scene).toMatchObject({ startTime: 0, endTime: 6 });
    for (const t of [0.01, 2.345, 5.9]) {
      expect(Math.hypot(...path!(t).u)).toBeCloseTo(0.75, 3);
      expect(path!(t).position[1]).toBeCloseTo(2, 9);
    }
  });

  it('does not jump from sample to sample of its circle, unless that is asked for', async () => {
    const circle = { radius: 4, speed: 6, to: 6, facing: false };
    const turn = async (smooth: boolean): Promise<readonly number[]> => {
      const { path } = await ridden('motion-circular', circle, '', false, smooth);
      // The direction of motion turns by 1.5 rad/s.
      return Array.from({ length: 400 }, (_, i) => {
        const [a, b] = [path!(2 + 0.002 * i).u, path!(2 + 0.002 * (i + 1)).u];
        return Math.atan2(a[2] * b[0] - a[0] * b[2], a[0] * b[0] + a[2] * b[2]);
      });
    };
    for (const angle of await turn(true)) expect(Math.abs(angle)).toBeCloseTo(0.003, 4);
    expect(Math.max(...(await turn(false)).map(Math.abs))).toBeGreaterThan(0.006);
  });

  it('named alone works; a second motion is told', async () => {
    expect((await ridden('motion-uniform', {}, '/Camera')).path!(1).position[0]).toBeCloseTo(4, 12);
    const { picture } = await ridden('motion-uniform', {}, '', true);
    expect(picture!.scene.diagnostics).toMatchObject([
      { severity: 'warning', code: 'move.camera', message: saying(/keeps its own motion/) },
    ]);
    expect((await ridden('motion-uniform', {}, '/Nothing')).evaluation.results.get('mover')).toMatchObject({
      problem: { code: 'geometry.path' },
    });
  });

  it('is refused faster than light', async () => {
    const { picture, evaluation } = await ridden('motion-uniform', { velocity: [0, 0, 10.5] });
    expect(picture).toBeUndefined();
    expect(evaluation.results.get('camera')).toMatchObject({ problem: { place: saying('motion of /Camera') } });
  });
});
