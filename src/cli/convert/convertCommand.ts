import { Command } from 'commander';
import { dotted } from '../../formats/files/fileSource.ts';
import { writtenExtensions } from '../../formats/save.ts';
import { msg } from '../../messages/message.ts';
import { addSceneFlags, SCENE_ARGUMENT } from '../flags/sceneFlags.ts';
import { localized } from '../terminal/language.ts';
import type { ConvertFlags } from './convertFlags.ts';

export const convertCommand = (): Command =>
  addSceneFlags(
    new Command('convert')
      .description(localized(msg`Converts a scene to another format, and reports what that cannot represent.`))
      .argument('<in>', localized(SCENE_ARGUMENT))
      .argument('<out>', localized(msg`output file: ${dotted(writtenExtensions)}`)),
  )
    .option('--json', localized(msg`print a report of what was written and what was lost as JSON`))
    .action(async (from: string, to: string, flags: ConvertFlags) =>
      (await import('./convertAction.ts')).convert(from, to, flags),
    );
