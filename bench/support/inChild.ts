import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

const child = fileURLToPath(new URL('./child.js', import.meta.url));

/** Runs a task of child.ts in a child process and returns its result. */
export function inChild<T>(task: string, argument: string): T {
  const done = spawnSync(process.execPath, ['--expose-gc', child, task, argument], { encoding: 'utf8' });
  if (done.status !== 0)
    throw new Error(`${task} ${argument} ended with ${done.status ?? done.signal}: ${done.stderr}`);
  return JSON.parse(done.stdout) as T;
}
