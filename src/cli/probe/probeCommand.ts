import { Command } from 'commander';
import { msg } from '../../messages/message.ts';
import { parsePixel, sizeOption } from '../flags/parse.ts';
import { addSceneFlags, SCENE_ARGUMENT } from '../flags/sceneFlags.ts';
import { addObserverFlags, observerTimeOption, settingOption } from '../flags/viewFlags.ts';
import { examples } from '../terminal/help.ts';
import { localized } from '../terminal/language.ts';
import { PROBE_SETTINGS, type ProbeFlags } from './probeFlags.ts';

const EXAMPLES = [
  'slowlight probe dice.usdc --prim /World/Die --time 1.5 --json',
  'slowlight probe dice.usdc --pixel 640,360 --size 1280x720 --beta 0,0,-0.9',
];

export function probeCommand(): Command {
  const command = new Command('probe')
    .description(
      localized(msg`Computes in double precision what the observer sees of each vertex of an object, or at a pixel.`),
    )
    .argument('<scene>', localized(SCENE_ARGUMENT))
    .option(
      '--prim <path>',
      localized(msg`prim path of an object: emission time, apparent position and Doppler factor of each vertex`),
      String,
    )
    .option(
      '--pixel <x,y>',
      localized(msg`pixel to probe, from the top left; 0,0 is the centre of the first pixel`),
      parsePixel,
    )
    .addOption(sizeOption(msg`size of the picture that contains the pixel`))
    .addOption(observerTimeOption());
  addSceneFlags(addObserverFlags(command));
  for (const name of PROBE_SETTINGS) command.addOption(settingOption(name));
  return command
    .option('--json', localized(msg`print as JSON`))
    .addHelpText('after', examples(EXAMPLES))
    .action(async (scene: string, flags: ProbeFlags) => (await import('./probeAction.ts')).probe(scene, flags));
}
