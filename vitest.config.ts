import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

/** Builds the program and the page where they are not up to date. */
const built = 'scripts/vitest-built.mjs';

/** What Playwright and polls wait for before they give up [ms]: a defect, on however slow a machine. */
const PATIENCE = 180_000;

const seeded = ['tests/seed.ts'];

/** Examples of the documentation import the library as its users do. */
const alias = [{ find: /^slowlight\/(\w+)$/, replacement: fileURLToPath(new URL('src/$1/index.ts', import.meta.url)) }];

/**
 * Unit tests sit beside the code; tests that need a GPU, a browser or the built program live in tests/. Timeouts
 * end what hangs; they are far beyond what anything takes, since tests say nothing about speed.
 */
export default defineConfig({
  test: {
    projects: [
      {
        resolve: { alias },
        test: {
          name: 'unit',
          include: [
            'src/**/*.test.{ts,tsx}',
            'tests/examples/**/*.test.ts',
            'tests/formats/**/*.test.ts',
            'tests/lessons/**/*.test.ts',
            'tests/docs/**/*.test.ts',
          ],
          exclude: ['**/*.oracle.test.ts'],
          setupFiles: seeded,
          maxWorkers: 2,
          testTimeout: 120_000,
          expect: { poll: { timeout: 60_000 } },
        },
      },
      {
        test: {
          name: 'oracle',
          include: ['src/**/*.oracle.test.ts', 'tests/formats/**/*.oracle.test.ts'],
          setupFiles: seeded,
          maxWorkers: 2,
          testTimeout: 600_000,
        },
      },
      {
        test: {
          name: 'fuzz',
          include: ['tests/fuzz/**/*.test.ts'],
          globalSetup: built,
          pool: 'forks',
          maxWorkers: 2,
          testTimeout: 1_200_000,
        },
      },
      {
        test: {
          name: 'gpu',
          include: ['tests/gpu/**/*.test.ts'],
          setupFiles: seeded,
          pool: 'forks',
          maxWorkers: 2,
          testTimeout: 900_000,
          hookTimeout: 300_000,
        },
      },
      {
        test: {
          name: 'visual',
          include: ['tests/visual/**/*.test.ts'],
          pool: 'forks',
          maxWorkers: 2,
          testTimeout: 900_000,
          hookTimeout: 300_000,
        },
      },
      {
        test: {
          name: 'cli',
          include: ['tests/cli/**/*.test.ts'],
          globalSetup: built,
          pool: 'forks',
          maxWorkers: 2,
          testTimeout: 900_000,
        },
      },
      {
        test: {
          name: 'e2e',
          include: ['tests/e2e/**/*.test.ts'],
          globalSetup: built,
          pool: 'forks',
          maxWorkers: 2,
          testTimeout: 900_000,
          hookTimeout: 300_000,
          expect: { poll: { timeout: PATIENCE } },
        },
      },
    ],
  },
});
