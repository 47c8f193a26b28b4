import { execFileSync } from 'node:child_process';

/** Runs Python and returns its standard output; standard error is discarded. */
export const python = (...args: string[]): string =>
  execFileSync('python3', args, { encoding: 'utf8', maxBuffer: 2 ** 29, stdio: ['ignore', 'pipe', 'ignore'] });

/** Whether Python has the module of an oracle; warns if not. */
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

/** Whether Pixar's USD is installed. */
export const hasUsdCore = (): boolean => has('pxr.Usd', 'usd-core');
/** Whether colour-science is installed. */
export const hasColorScience = (): boolean => has('colour', 'colour-science');
/** Whether MaterialX is installed. */
export const hasMaterialX = (): boolean => has('MaterialX', 'MaterialX');
