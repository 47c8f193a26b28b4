import { basename, dirname, resolve } from 'node:path';
import { dotted, extensionOf } from '../../formats/files/fileSource.ts';
import { saveScene, writtenExtensions } from '../../formats/save.ts';
import { msg } from '../../messages/message.ts';
import { writeExportedFiles } from '../files/exportScene.ts';
import { checkWritable } from '../files/outputFile.ts';
import { openSceneWithFlags } from '../flags/openScene.ts';
import { reportDiagnostics } from '../terminal/diagnostics.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import type { ConvertFlags } from './convertFlags.ts';

export async function convert(from: string, to: string, flags: ConvertFlags): Promise<void> {
  const extension = extensionOf(to);
  if (!writtenExtensions.includes(extension))
    throw usageError(msg`${to}: a scene is written as ${dotted(writtenExtensions)}, not as .${extension}`);
  checkWritable(to);
  if (resolve(from) === resolve(to)) throw usageError(msg`${to} would be written over itself; name another file`);
  const scene = await openSceneWithFlags(from, flags);
  const written = await saveScene(scene, basename(to));
  const diagnostics = [...scene.diagnostics, ...written.diagnostics];
  reportDiagnostics(diagnostics);
  const files = writeExportedFiles(dirname(resolve(to)), written);
  console.log(flags.json ? toJson({ files, diagnostics }) : files.join('\n'));
}
