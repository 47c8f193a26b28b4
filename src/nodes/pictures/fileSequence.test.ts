import { describe, expect, it } from 'vitest';
import { add, connect, edited, set } from '../../../tests/support/graphKit.ts';
import { savingProject } from '../../../tests/support/savingGraph.ts';
import type { Command } from '../../graph/edits/commands.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { velocity } from '../../physics/lorentz/boost.ts';
import { perspectiveOf } from '../../scene/view/lenses/lenses.ts';
import { nodeLibrary } from '../library.ts';
import { fileNodesIn, requestedFiles } from '../project/fileNodes.ts';
import { workerServices } from '../services.ts';
import { pictureSequence } from './fileSequence.ts';
import type { PictureSequence } from './sequence.ts';

async function sequence(node: string, ...commands: readonly Command[]): Promise<PictureSequence> {
  const document = edited(savingProject(), ...commands);
  const writers = fileNodesIn(document);
  const evaluation = await new Evaluator(nodeLibrary).evaluate(document, [...writers.keys()], workerServices);
  const file = requestedFiles(evaluation, writers).get(node);
  if (!file || file.kind === 'scene') throw new Error(`${node} asks for no picture`);
  return pictureSequence(file);
}

/** The observer moves at 0.6 c = 6 m/s along −z. */
const fast: readonly Command[] = [
  add('start', 'observer'),
  { kind: 'set-param', node: 'start', param: 'beta', value: [0, 0, -0.6] },
  connect('start.observer', 'scene.observer'),
];

describe('pictures for a file', () => {
  it('have its size, time and samples, and the settings of its picture', async () => {
    const still = await sequence('still', set('console', 'lightDelay', false), set('camera', 'fieldOfView', 90));
    expect(still).toMatchObject({ size: { width: 64, height: 48 }, samples: 2, aovs: [], frames: [{ t: 0.5 }] });
    expect(still.settings).toMatchObject({ speedOfLight: 10, lightDelay: false });
    expect(still.views(0.5)[0]).toMatchObject({ t: 0.5, position: [0, 1, 6], u: [0, 0, 0] });
    expect(perspectiveOf(still.views(0.5)[0].lens).fovY).toBeCloseTo(Math.PI / 2, 12);
  });

  it('have one sample without antialiasing, and light if requested', async () => {
    expect(await sequence('still', set('rasterize', 'antialiasing', false))).toMatchObject({ samples: 1 });
    expect(await sequence('still', set('still', 'name', 'a.exr'))).toMatchObject({ aovs: ['beauty'] });
  });

  it('are seen by an observer who coasts from the first frame on, unless he stays in place', async () => {
    const isFilm = await sequence('film', ...fast);
    expect(isFilm.frames.map(({ t }) => t)).toEqual([0.25, 0.375, 0.5, 0.625, 0.75]);
    expect(isFilm.views(0.25)[0].position).toEqual([0, 1, 6]);
    expect(isFilm.views(0.75)[0].position[2]).toBeCloseTo(3, 12);
    const staying = await sequence('film', ...fast, set('film', 'stayInPlace', true));
    expect(staying.views(0.75)[0].position).toEqual([0, 1, 6]);
    expect(velocity(staying.views(0.75)[0].u)[2]).toBeCloseTo(-0.6, 12);
  });
});
