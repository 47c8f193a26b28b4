import { appendFileSync, existsSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { msg } from '../../messages/message.ts';
import { CliError, EXIT, inputProblem } from '../terminal/exitCodes.ts';

/** A file that is written under a temporary name in the same folder and renamed when complete. Ctrl-C and errors remove the temporary file. */
export class OutputFile {
  readonly path: string;
  /** Path to write to before `commit`. */
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

  append(bytes: Uint8Array): void {
    appendFileSync(this.temporary, bytes);
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

export function writeFileAtomically(path: string, bytes: Uint8Array): void {
  const file = new OutputFile(path);
  try {
    file.write(bytes);
    file.commit();
  } finally {
    file.discard();
  }
}

/** Throws if the file cannot be written; called before long work begins. */
export function checkWritable(path: string): void {
  const folder = dirname(resolve(path));
  if (!existsSync(folder)) throw inputProblem(msg`${path}: there is no folder ${folder} to write into; make it first`);
  if (existsSync(path) && statSync(path).isDirectory()) throw inputProblem(msg`${path} is a folder; name a file`);
}

const openOutputs = new Set<OutputFile>();
/** Child processes that are killed on a signal, such as ffmpeg. */
const childProcesses = new Set<{ kill(signal: NodeJS.Signals): unknown }>();

/** Kills `helper` when this program is stopped; returns a function that unregisters it. */
export function killWhenStopped(helper: { kill(signal: NodeJS.Signals): unknown }): () => void {
  handleSignals();
  childProcesses.add(helper);
  return () => childProcesses.delete(helper);
}

let handlersInstalled = false;
let requestedCode: number | undefined;

/** The exit code that a signal has requested; undefined if none has. */
export const requestedExitCode = (): number | undefined => requestedCode;

/** Throws if a signal has requested the end; call between the steps of long work. */
export function throwIfStopped(): void {
  if (requestedCode !== undefined) throw new CliError(requestedCode, msg`stopped`);
}

/** Installs the signal handlers. Work without an open OutputFile must poll `requestedExitCode` afterwards. */
export function handleSignals(): void {
  if (handlersInstalled) return;
  handlersInstalled = true;
  process.on('SIGINT', () => stop(EXIT.cancelled));
  process.on('SIGTERM', () => stop(143));
}

/** Removes unfinished files at once. The process continues until its GPU frame is finished, because exiting in the middle can crash; a second signal exits immediately. */
function stop(exitCode: number): void {
  if (requestedCode !== undefined) process.exit(exitCode);
  requestedCode = exitCode;
  for (const helper of childProcesses) helper.kill('SIGKILL');
  for (const file of [...openOutputs]) file.discard();
}
