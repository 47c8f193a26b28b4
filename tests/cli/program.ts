import { type ChildProcess, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll } from 'vitest';

const bin = fileURLToPath(new URL('../../bin/slowlight.js', import.meta.url));
const scenes = fileURLToPath(new URL('scenes/', import.meta.url));

// Its texts are those that tests expect, whatever the language of the machine.
process.env.LC_ALL = 'C.UTF-8';

export const scene = (name: string): string => join(scenes, name);

export interface ProgramResult {
  /** Exit code; null if it was ended by a signal. */
  readonly code: number | null;
  readonly out: string;
  readonly err: string;
}

/** Starts the built program as a user would. */
export const start = (...args: string[]): ChildProcess => startIn(process.env, ...args);

/** Starts it with additional environment variables. */
export const startIn = (env: NodeJS.ProcessEnv, ...args: string[]): ChildProcess =>
  spawn(process.execPath, [bin, ...args], { stdio: ['ignore', 'pipe', 'pipe'], env });

/** Resolves with the exit code and all output of a started program. */
export function programResult(child: ChildProcess): Promise<ProgramResult> {
  let out = '';
  let err = '';
  child.stdout?.on('data', (chunk) => (out += chunk));
  child.stderr?.on('data', (chunk) => (err += chunk));
  return new Promise((resolve, reject) => {
    child.on('error', reject);
    child.on('close', (code) => resolve({ code, out, err }));
  });
}

/** Processor time that a program has taken so far [s]. */
export function processorSeconds({ pid, exitCode }: ChildProcess): number {
  if (exitCode !== null) throw new Error(`it ended with ${exitCode}`);
  const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ')[1]!.split(' ');
  // User and system time, in hundredths of a second.
  return (Number(fields[11]) + Number(fields[12])) / 100;
}

export const slowlight = (...args: string[]): Promise<ProgramResult> => programResult(start(...args));

/** Runs it, expects success and reads its JSON. */
export async function slowlightJson<T>(...args: string[]): Promise<T> {
  const { code, out, err } = await slowlight(...args, '--json');
  if (code !== 0) throw new Error(`slowlight ${args.join(' ')} ended with ${code}: ${err}`);
  return JSON.parse(out) as T;
}

/** A temporary folder for a test file's output, removed after its tests. */
export function outputFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), 'slowlight-cli-'));
  afterAll(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** Runs any other program and returns its output. */
export async function ask(command: string, ...args: string[]): Promise<string> {
  const { code, out, err } = await programResult(spawn(command, args, { stdio: ['ignore', 'pipe', 'pipe'] }));
  if (code !== 0) throw new Error(`${command} ${args.join(' ')} ended with ${code}: ${err}`);
  return out;
}
