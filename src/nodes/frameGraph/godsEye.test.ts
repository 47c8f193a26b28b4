import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { readFont } from '../../cli/files/fonts.ts';
import { parseDocument } from '../../graph/document/parse.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { nodeLibrary } from '../library.ts';
import { evaluatedPicture } from '../pictures/renderSettings.ts';
import { workerServices } from '../services.ts';

const file = new URL('../../../examples/gods-eye.slowlight.json', import.meta.url);

it('the preset shows the world now from outside, in which the passing train is contracted by its γ, and what the observer sees', async () => {
  const document = parseDocument(readFileSync(file, 'utf8'));
  const evaluation = await new Evaluator(nodeLibrary).evaluate(document, 'output', {
    ...workerServices,
    readFont,
    readScene: () => Promise.reject(new Error('it reads no scene')),
  });
  const picture = evaluatedPicture(evaluation)!;
  expect(picture).toMatchObject({ view: 'light-cone', speedOfLight: 10 });
  expect(picture).not.toHaveProperty('outside');
  expect(picture.frameGraph?.extraBuffers).toMatchObject([{ view: 'galilean', outside: { follows: true } }]);
  const { objects, cameras, hints } = picture.scene;
  expect(hints.beta).toBeUndefined();
  expect(cameras.map(({ path }) => path)).toEqual(['/Observer']);

  const places = (name: string) =>
    objects.flatMap(({ path, motion }) =>
      path.startsWith(`/${name}`) && 'pose' in motion ? [motion.pose.position[0]] : [],
    );
  const spacing = (name: string): number => {
    const xs = places(name).sort((a, b) => a - b);
    expect(xs).toHaveLength(5);
    return xs[1]! - xs[0]!;
  };
  const speeds = objects.flatMap(({ motion, authoredIn }) =>
    motion.kind === 'uniform' ? [{ v: Math.hypot(...motion.velocity), authoredIn }] : [],
  );
  expect(speeds).toHaveLength(5);
  for (const { v, authoredIn } of speeds) {
    // Wagons are authored at rest and contract by their motion.
    expect(authoredIn).toBe('rest');
    expect(spacing('Passing')).toBeCloseTo(spacing('Resting') * Math.sqrt(1 - (v / picture.speedOfLight) ** 2), 9);
  }
});
