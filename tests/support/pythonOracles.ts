import { execFileSync } from 'node:child_process';

/** Runs Python, quietly, and returns what it prints. */
export const python = (...args: string[]): string =>
  execFileSync('python3', args, { encoding: 'utf8', maxBuffer: 2 ** 29, stdio: ['ignore', 'pipe', 'ignore'] });

/** Whether Python has a judge's module; says so where it has not. */
function has(module: string, packageName: string): boolean {
  try {
    python('-c', `import ${module}`);
    return true;
  } catch {
    console.warn(
      `${packageName} is not installed (pip install ${packageName}): its comparison with fresh values is skipped`,
    );
    return false;
  }
}

/** Whether Pixar's own USD is there to be asked. */
export const hasUsdCore = (): boolean => has('pxr.Usd', 'usd-core');
/** Whether colour-science is there to be asked. */
export const hasColorScience = (): boolean => has('colour', 'colour-science');
