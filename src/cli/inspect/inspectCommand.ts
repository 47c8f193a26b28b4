import { Command } from 'commander';
import { msg } from '../../messages/message.ts';
import { addSceneFlags, SCENE_ARGUMENT } from '../flags/sceneFlags.ts';
import { speedOfLightOption } from '../flags/viewFlags.ts';
import { localized } from '../terminal/language.ts';
import type { InspectFlags } from './inspectFlags.ts';

export const inspectCommand = (): Command =>
  addSceneFlags(
    new Command('inspect')
      .description(localized(msg`Reports the contents of a scene file, its speeds, and its errors.`))
      .argument('<file>', localized(SCENE_ARGUMENT)),
  )
    .addOption(speedOfLightOption())
    .option('--json', localized(msg`print as JSON`))
    .action(async (path: string, flags: InspectFlags) => (await import('./inspectAction.ts')).inspect(path, flags));
