import { Command } from 'commander';
import type { SimulateFlags } from './simulateFlags.ts';

const examples = `
Examples:
  slowlight simulate cloth.slowlight.json -o cloth.usda --csv energy.csv
  slowlight simulate cloth.slowlight.json --csv energy.csv --set run.method=leapfrog
  slowlight simulate cloth.slowlight.json -o cloth.usda --checkpoint cloth.run
  slowlight simulate cloth.slowlight.json -o cloth.usda --checkpoint cloth.run --resume`;

export const simulateCommand = (): Command =>
  new Command('simulate')
    .description('Runs a simulation of a project, and writes the resulting motion and energies.')
    .argument('<project>', 'a .slowlight.json project, or an archive with one')
    .option('-o, --output <file>', 'output scene: .usda, .usdz, .usdc, .glb …')
    .option('--csv <file>', 'table of energies, momenta and speeds per frame')
    .option('--node <id>', 'id of the Simulate node, if the project has several')
    .option('--checkpoint <file>', 'file that every frame is appended to as soon as it is computed')
    .option('--resume', 'continue from the --checkpoint; the duration may differ')
    .option(
      '--set <node.param=value>',
      'set a parameter of a node; repeatable; vectors as x,y,z',
      (text: string, before: readonly string[] = []) => [...before, text],
    )
    .option('--json', 'print the result as JSON')
    .addHelpText('after', examples)
    .action(async (project: string, flags: SimulateFlags) =>
      (await import('./simulateAction.ts')).simulate(project, flags),
    );
