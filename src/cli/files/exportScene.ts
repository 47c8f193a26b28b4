import { existsSync, mkdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import type { ExportedScene } from '../../formats/write/exportMotion.ts';
import { msg } from '../../messages/message.ts';
import { inputProblem } from '../terminal/exitCodes.ts';
import { writeFileAtomically } from './outputFile.ts';

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
    throw inputProblem(msg`${path} is there already and is another file; write into a folder of its own`);
}
