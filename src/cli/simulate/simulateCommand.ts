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
    .description('Runs a simulation of a project, and writes how its things move and what became of their energy.')
    .argument('<project>', 'a project, .slowlight.json, or an archive with one')
    .option('-o, --output <file>', 'scene to write: .usda, .usdz, .usdc, .glb …')
    .option('--csv <file>', 'energies, momenta and speeds to write, frame by frame')
    .option('--node <id>', 'which Simulate node, where the project has several')
    .option('--checkpoint <file>', 'keep every frame in a file as soon as it is computed')
    .option('--resume', 'go on from what is in the --checkpoint; the duration may be another')
    .option(
      '--set <node.param=value>',
      'a parameter of a node; several times for several; vectors as x,y,z',
      (text: string, before: readonly string[] = []) => [...before, text],
    )
    .option('--json', 'print what came out as JSON')
    .addHelpText('after', examples)
    .action(async (project: string, flags: SimulateFlags) =>
      (await import('./simulateAction.ts')).simulate(project, flags),
    );
