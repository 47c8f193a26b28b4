import { expect, it } from 'vitest';
import { random } from '../../math/random.ts';
import { makeScene } from '../../scene/defaults.ts';
import { prepareScene } from '../intersection/tracedScene.ts';
import { TracerPool, type TracerThread } from '../tracerPool.ts';
import { serveTracer, type TracerMessage } from '../tracerServer.ts';
import { denoiseTile } from './denoiseTile.ts';
import { denoiseWithPool, type NoisyPicture } from './denoiseWithPool.ts';

/** A tracer in this thread. */
function localThread(): TracerThread {
  let onMessage: (message: TracerMessage) => void = () => {};
  return {
    send: (message) => onMessage(message),
    listen: (hear) => {
      const listen = (to: typeof onMessage): void => {
        onMessage = to;
      };
      serveTracer({ listen, post: hear });
    },
    terminate: () => undefined,
  };
}

const pool = (threads: number): TracerPool =>
  new TracerPool(Array.from({ length: threads }, localThread), {
    kind: 'scene',
    ground: prepareScene(makeScene({ name: 'empty' }), 1),
    shapes: 0,
  });

/** Noise of mean luminance 0.18 in each cell of the exposure, so that its gain is nearly 1; no surface in the left half. */
function noisy(width: number, height: number): NoisyPicture {
  const next = random(1);
  const values = new Float32Array(9 * width * height).fill(0.5);
  for (let i = 0; i < width * height; i++) {
    values.fill(0.36 * next(), 9 * i, 9 * i + 3);
    values.set(i % width < width / 2 ? [0, 0, 0] : [1, 0, 0], 9 * i + 6);
  }
  return { values, hasStars: false };
}

it('has no seams between tiles, and the same bits by any number of threads', async () => {
  const size = { width: 500, height: 16 };
  const picture = noisy(size.width, size.height);
  const window = { x0: 0, y0: 0, x1: size.width, y1: size.height };
  const parts: number[] = [];
  const clean = await denoiseWithPool(pool(1), picture, size, (part) => parts.push(part));
  expect(parts).toEqual([0.5, 1]);
  expect(await denoiseWithPool(pool(3), picture, size)).toEqual(clean);
  // The gain is that of the picture: 1 within a tenth, as the logarithm of cells that are cut differs.
  const whole = denoiseTile(window, { window, ...picture, gain: 1 });
  const difference = Math.max(...whole.map((value, i) => Math.abs(value - clean[i]!)));
  expect(difference).toBeLessThan(0.01);
});

it('leaves a sky with stars as it is', async () => {
  const size = { width: 48, height: 32 };
  const picture = noisy(size.width, size.height);
  const clean = await denoiseWithPool(pool(1), { ...picture, hasStars: true }, size);
  const same = (x: number): boolean => clean[3 * (16 * size.width + x)] === picture.values[9 * (16 * size.width + x)];
  expect([0, 10, 22].map(same)).toEqual([true, true, true]);
  // Beside a surface, and on it.
  expect([23, 24, 40].map(same)).toEqual([false, false, false]);
});
