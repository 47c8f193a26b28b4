import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, it } from 'vitest';
import { type BakedStage, expectBaked } from './fixtures/expectBaked.ts';

const expected: BakedStage[] = JSON.parse(
  readFileSync(fileURLToPath(new URL('./fixtures/expected.json', import.meta.url)), 'utf8'),
);

describe('random skeletons', () => {
  it.each(expected)('agree with points and normals baked by usd-core (seed $seed)', async (stage) => {
    await expectBaked(stage);
  });
  it.each(expected)('agree where points are baked, for cubic interpolation (seed $seed)', async (stage) => {
    await expectBaked(stage, 'cubic');
  });
});
