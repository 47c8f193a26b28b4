import { expect, it } from 'vitest';
import { CancelledError } from '../../graph/evaluation/evaluator.ts';
import { coalesce } from './coalesce.ts';

it('processes one value at a time, then only the latest; being stopped is no error', async () => {
  const looks: { readonly end: (error?: Error) => void }[] = [];
  let atOnce = 0;
  let most = 0;
  const news = coalesce(async () => {
    most = Math.max(most, ++atOnce);
    await new Promise<void>((done, fail) => looks.push({ end: (error) => (error ? fail(error) : done()) }));
  });
  const end = (error?: Error): void => {
    atOnce--;
    looks.at(-1)!.end(error);
  };
  for (let i = 0; i < 5; i++) news();
  expect(looks).toHaveLength(1);
  end();
  await expect.poll(() => looks).toHaveLength(2);
  news();
  end(new CancelledError());
  await expect.poll(() => looks).toHaveLength(3);
  end();
  await new Promise((done) => setTimeout(done, 30));
  expect(looks).toHaveLength(3);
  news();
  await expect.poll(() => looks).toHaveLength(4);
  expect(most).toBe(1);
});
