import { execFileSync } from 'node:child_process';

/** Runs Python, quietly, and returns what it prints. */
export const python = (...args: string[]): string =>
  execFileSync('python3', args, { encoding: 'utf8', maxBuffer: 2 ** 29, stdio: ['ignore', 'pipe', 'ignore'] });

/** Whether Pixar's own USD is there to be asked; says so where it is not. */
export function hasUsdCore(): boolean {
  try {
    python('-c', 'import pxr.Usd');
    return true;
  } catch {
    console.warn('usd-core is not installed (pip install usd-core): its comparison with fresh values is skipped');
    return false;
  }
}
