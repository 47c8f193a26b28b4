import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { extensionOf } from '../../formats/files/fileSource.ts';
import { writtenExtensions } from '../../formats/save.ts';
import type { ExportedScene } from '../../formats/write/exportMotion.ts';
import { inputProblem, unavailable } from '../terminal/exitCodes.ts';
import { writeFileAtomically } from './outputFile.ts';

/** Binary USD, which the Python package usd-core writes from the text layer. */
export const USDC = 'usdc';

/** Extensions of the scene files that the command line writes. */
export const SCENE_EXTENSIONS: readonly string[] = [...writtenExtensions, USDC];

/** Exports a scene in the format of `name`; `save` writes the formats other than USDC. */
export async function exportScene(
  name: string,
  save: (name: string) => Promise<ExportedScene>,
): Promise<ExportedScene> {
  return extensionOf(name) === USDC ? convertToUsdc(name, await save('scene.usda')) : save(name);
}

/** Writes the files and returns their paths, the main file first. It is written last, so that it never exists without the files that it refers to. */
export function writeExportedFiles(folder: string, { files }: ExportedScene): string[] {
  const [main, ...others] = files;
  for (const [name, bytes] of others) refuseOverwrite(join(folder, name), bytes);
  for (const [name, bytes] of [...others, main]) {
    const path = join(folder, name);
    mkdirSync(dirname(path), { recursive: true });
    writeFileAtomically(path, bytes);
  }
  return [main, ...others].map(([name]) => join(folder, name));
}

/** Only the named file may be overwritten: a texture of the same name may belong to another scene. */
function refuseOverwrite(path: string, bytes: Uint8Array): void {
  if (existsSync(path) && !readFileSync(path).equals(bytes))
    throw inputProblem(`${path} is there already and is another file; write into a folder of its own`);
}

const pythonProgram = (): string => process.env.SLOWLIGHT_PYTHON || 'python3';

export function checkPython(): void {
  try {
    execFileSync(pythonProgram(), ['-c', 'import pxr.Sdf'], { stdio: 'ignore' });
  } catch {
    throw unavailable(
      `.usdc is written by Pixar's own USD, which ${pythonProgram()} does not have: install it (pip install usd-core), name a Python that has it in SLOWLIGHT_PYTHON, or write .usda or .usdz`,
    );
  }
}

const USDA_TO_USDC = 'import sys; from pxr import Sdf; Sdf.Layer.FindOrOpen(sys.argv[1]).Export(sys.argv[2])';

/** Converts the text layer with usd-core; textures stay beside it. */
function convertToUsdc(name: string, { files, diagnostics }: ExportedScene): ExportedScene {
  const [[, text], ...others] = files;
  const folder = mkdtempSync(join(tmpdir(), 'slowlight-usdc-'));
  try {
    const [from, to] = [join(folder, 'scene.usda'), join(folder, 'scene.usdc')];
    writeFileSync(from, text);
    execFileSync(pythonProgram(), ['-c', USDA_TO_USDC, from, to], { stdio: ['ignore', 'ignore', 'pipe'] });
    return { files: new Map([[name, new Uint8Array(readFileSync(to))], ...others]), diagnostics };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
