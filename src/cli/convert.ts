import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join, resolve } from 'node:path';
import { Command } from 'commander';
import { saveScene, writtenExtensions } from '../formats/save.ts';
import { extensionOf } from '../formats/source.ts';
import type { Written } from '../formats/written.ts';
import type { Scene } from '../scene/types.ts';
import { reportDiagnostics } from './diagnostics.ts';
import { inputProblem, unavailable, usageError } from './exit.ts';
import { checkWritable, writeWhole } from './output.ts';
import { addSceneFlags, openChangedScene, SCENE_ARGUMENT, type SceneFlags } from './scene.ts';

/** Written by Pixar's own USD, from the text layer. */
const BINARY = 'usdc';
const EXTENSIONS = [...writtenExtensions, BINARY];

export const convertCommand = (): Command =>
  addSceneFlags(
    new Command('convert')
      .description('Writes a scene as another kind of file, and tells what that cannot hold.')
      .argument('<in>', SCENE_ARGUMENT)
      .argument('<out>', `file to write: ${EXTENSIONS.map((e) => `.${e}`).join(', ')}`),
  )
    .option('--json', 'print what was written, and what was lost, as JSON')
    .action(convert);

async function convert(from: string, to: string, flags: SceneFlags & { json?: boolean }): Promise<void> {
  const extension = extensionOf(to);
  if (!EXTENSIONS.includes(extension))
    throw usageError(`${to}: a scene is written as ${EXTENSIONS.map((e) => `.${e}`).join(', ')}, not as .${extension}`);
  checkWritable(to);
  if (resolve(from) === resolve(to)) throw usageError(`${to} would be written over itself; name another file`);
  if (extension === BINARY) checkPython();
  const scene = await openChangedScene(from, flags);
  const written = extension === BINARY ? await binaryUsd(scene, basename(to)) : await saveScene(scene, basename(to));
  const diagnostics = [...scene.diagnostics, ...written.diagnostics];
  reportDiagnostics(diagnostics);
  const files = writeAll(dirname(resolve(to)), written);
  console.log(flags.json ? JSON.stringify({ files, diagnostics }, null, 2) : files.join('\n'));
}

/** The main file last, so that it is there only when all it needs is. */
function writeAll(folder: string, { files }: Written): string[] {
  const [main, ...others] = files;
  for (const [name, bytes] of others) checkOthers(join(folder, name), bytes);
  for (const [name, bytes] of [...others, main]) {
    const path = join(folder, name);
    mkdirSync(dirname(path), { recursive: true });
    writeWhole(path, bytes);
  }
  return [main, ...others].map(([name]) => join(folder, name));
}

/** Only the file that was named may be written over: a texture of the same name may belong to another scene. */
function checkOthers(path: string, bytes: Uint8Array): void {
  if (existsSync(path) && !readFileSync(path).equals(bytes))
    throw inputProblem(`${path} is there already and is another file; write into a folder of its own`);
}

const pythonProgram = (): string => process.env.SLOWLIGHT_PYTHON || 'python3';

function checkPython(): void {
  try {
    execFileSync(pythonProgram(), ['-c', 'import pxr.Sdf'], { stdio: 'ignore' });
  } catch {
    throw unavailable(
      `.usdc is written by Pixar's own USD, which ${pythonProgram()} does not have: install it (pip install usd-core), name a Python that has it in SLOWLIGHT_PYTHON, or write .usda or .usdz`,
    );
  }
}

const TO_BINARY = 'import sys; from pxr import Sdf; Sdf.Layer.FindOrOpen(sys.argv[1]).Export(sys.argv[2])';

/** The text layer as Pixar's USD packs it; textures stay beside it. */
async function binaryUsd(scene: Scene, name: string): Promise<Written> {
  const { files, diagnostics } = await saveScene(scene, 'scene.usda');
  const [[, text], ...others] = files;
  const folder = mkdtempSync(join(tmpdir(), 'slowlight-usdc-'));
  try {
    const [from, to] = [join(folder, 'scene.usda'), join(folder, 'scene.usdc')];
    writeFileSync(from, text);
    execFileSync(pythonProgram(), ['-c', TO_BINARY, from, to], { stdio: ['ignore', 'ignore', 'pipe'] });
    return { files: new Map([[name, new Uint8Array(readFileSync(to))], ...others]), diagnostics };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
