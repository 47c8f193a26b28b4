import { Command } from 'commander';
import { parseNumber, parsePixel, sizeOption } from '../flags/parse.ts';
import { addSceneFlags, SCENE_ARGUMENT } from '../flags/sceneFlags.ts';
import { addObserverFlags, settingOption } from '../flags/viewFlags.ts';
import type { ProbeFlags } from './probeFlags.ts';

const examples = `
Examples:
  slowlight probe dice.usda --prim /World/Die --time 1.5 --json
  slowlight probe dice.usda --pixel 640,360 --size 1280x720 --beta 0,0,-0.9`;

export function probeCommand(): Command {
  const command = new Command('probe')
    .description('Computes in double precision what the observer sees of each vertex of an object, or at a pixel.')
    .argument('<scene>', SCENE_ARGUMENT)
    .option(
      '--prim <path>',
      'prim path of an object: emission time, apparent position and Doppler factor of each vertex',
      String,
    )
    .option('--pixel <x,y>', 'pixel to probe, from the top left; 0,0 is the centre of the first pixel', parsePixel)
    .addOption(sizeOption('size of the picture that contains the pixel'))
    .option(
      '--time <s>',
      "world time of the observer's event [s] (default: suggested by the scene, else its start)",
      parseNumber,
    );
  return addSceneFlags(addObserverFlags(command))
    .addOption(settingOption('view'))
    .option('--json', 'print as JSON')
    .addHelpText('after', examples)
    .action(async (scene: string, flags: ProbeFlags) => (await import('./probeAction.ts')).probe(scene, flags));
}
