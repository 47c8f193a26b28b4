import { Command } from 'commander';
import { msg } from '../../messages/message.ts';
import { addText } from '../flags/parse.ts';
import { examples } from '../terminal/help.ts';
import { localized } from '../terminal/language.ts';
import type { SimulateFlags } from './simulateFlags.ts';

const EXAMPLES = [
  'slowlight simulate cloth.slowlight.json -o cloth.usda --csv energy.csv',
  'slowlight simulate cloth.slowlight.json --csv energy.csv --set run.method=leapfrog',
  'slowlight simulate cloth.slowlight.json -o cloth.usda --checkpoint cloth.run',
  'slowlight simulate cloth.slowlight.json -o cloth.usda --checkpoint cloth.run --resume',
];

export const simulateCommand = (): Command =>
  new Command('simulate')
    .description(localized(msg`Runs a simulation of a project, and writes the resulting motion and energies.`))
    .argument('<project>', localized(msg`a .slowlight.json project, or an archive with one`))
    .option('-o, --output <file>', localized(msg`output scene: .usda, .usdz, .usdc, .glb …`))
    .option('--csv <file>', localized(msg`table of energies, momenta and speeds per frame`))
    .option('--node <id>', localized(msg`id of the Simulate node, if the project has several`))
    .option('--checkpoint <file>', localized(msg`file that every frame is appended to as soon as it is computed`))
    .option('--resume', localized(msg`continue from the --checkpoint; the duration may differ`))
    .option(
      '--set <node.param=value>',
      localized(msg`set a parameter of a node; repeatable; vectors as x,y,z`),
      addText,
    )
    .option('--json', localized(msg`print the result as JSON`))
    .addHelpText('after', examples(EXAMPLES))
    .action(async (project: string, flags: SimulateFlags) =>
      (await import('./simulateAction.ts')).simulate(project, flags),
    );
