import { existsSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { CliError, EXIT, inputProblem } from '../terminal/exitCodes.ts';

/**
 * A file that appears under its name only when it is whole: it is written beside and then renamed. Ctrl-C and failures
 * remove what was begun.
 */
export class OutputFile {
  readonly path: string;
  /** Write here, then `commit`. */
  readonly temporary: string;

  constructor(path: string) {
    this.path = resolve(path);
    this.temporary = join(dirname(this.path), `.${basename(this.path)}.${process.pid}.partial`);
    checkWritable(this.path);
    handleSignals();
    openOutputs.add(this);
  }

  write(bytes: Uint8Array): void {
    writeFileSync(this.temporary, bytes);
  }

  commit(): void {
    renameSync(this.temporary, this.path);
    openOutputs.delete(this);
  }

  discard(): void {
    rmSync(this.temporary, { force: true });
    openOutputs.delete(this);
  }
}

/** Writes one whole file. */
export function writeFileAtomically(path: string, bytes: Uint8Array): void {
  const file = new OutputFile(path);
  try {
    file.write(bytes);
    file.commit();
  } finally {
    file.discard();
  }
}

/** Said before the work begins, not after hours of it. */
export function checkWritable(path: string): void {
  const folder = dirname(resolve(path));
  if (!existsSync(folder)) throw inputProblem(`${path}: there is no folder ${folder} to write into; make it first`);
  if (existsSync(path) && statSync(path).isDirectory()) throw inputProblem(`${path} is a folder; name a file`);
}

const openOutputs = new Set<OutputFile>();
/** Programs that were started for the output, as ffmpeg. */
const childProcesses = new Set<{ kill(signal: NodeJS.Signals): unknown }>();

/** Stops `helper` too when this program is stopped; returns how to forget it. */
export function killWhenStopped(helper: { kill(signal: NodeJS.Signals): unknown }): () => void {
  handleSignals();
  childProcesses.add(helper);
  return () => childProcesses.delete(helper);
}

let handlersInstalled = false;
/** The exit code that a signal asked for. */
let requestedCode: number | undefined;

/** With which code to end, where a signal has asked for that. */
export const requestedExitCode = (): number | undefined => requestedCode;

/** Call between the steps of long work: ends it where a signal has asked for that. */
export function throwIfStopped(): void {
  if (requestedCode !== undefined) throw new CliError(requestedCode, 'stopped');
}

/** From here on signals are heard: work that has begun no file asks `requestedExitCode` whether it is to end. */
export function handleSignals(): void {
  if (handlersInstalled) return;
  handlersInstalled = true;
  process.on('SIGINT', () => stop(EXIT.cancelled));
  process.on('SIGTERM', () => stop(143));
}

/**
 * Removes what was begun at once; the GPU is let finish its frame, since a process that ends in the midst of it can
 * crash. Whoever asks twice does not wait for that.
 */
function stop(exitCode: number): void {
  if (requestedCode !== undefined) process.exit(exitCode);
  requestedCode = exitCode;
  for (const helper of childProcesses) helper.kill('SIGKILL');
  for (const file of [...openOutputs]) file.discard();
}
