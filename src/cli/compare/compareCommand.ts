import { Command, Option } from 'commander';
import { parseFraction, parseNotNegative, parseNumber, parsePositive } from '../flags/parse.ts';
import type { CompareFlags, Metric } from './compareFlags.ts';

const metrics: readonly Metric[] = ['flip', 'pixels', 'aov'];

const notes = `
Metrics:
  flip     perceived difference when alternating between the pictures (FLIP), 0 … 1; for .exr over all relevant exposures
  pixels   absolute differences of sRGB values 0 … 1, for .exr of linear light
  aov      differences of .exr channels, and the displacement of A's points in B in pixels

Examples:
  slowlight compare fast.png exact.png -o error.png
  slowlight compare fast.png exact.png -o error.png --triptych
  slowlight compare fast.exr exact.exr --metric aov -o moved.png
  slowlight compare fast.png exact.png --metric pixels --threshold 0 --fail-above 0 || echo 'not the same'`;

export function compareCommand(): Command {
  return new Command('compare')
    .description('Compares two pictures: statistics and an error map.')
    .argument('<A>', 'test picture: .png, .jpg or .exr')
    .argument('<B>', 'reference picture')
    .addOption(new Option('--metric <name>', 'error metric, see below').choices(metrics).default('flip'))
    .option('-o, --output <file>', 'error map, .png')
    .option('--triptych', 'with -o: A, B and the error side by side')
    .option('--channel <name>', 'with --metric aov: use the differences of this channel for map and fraction')
    .option(
      '--threshold <x>',
      'error above which a pixel counts as different (default: flip 0.1, pixels 0.02, aov 0.5 px)',
      parseNotNegative,
    )
    .option(
      '--fail-above <share>',
      'exit with code 5 if more than this fraction of the pixels, 0 … 1, is different',
      parseFraction,
    )
    .option('--max <x>', 'error shown in the brightest colour of the map', parsePositive)
    .option('--exposure <EV>', 'with --triptych: show .exr pictures 2^EV times as bright', parseNumber, 0)
    .option('--json', 'print as JSON')
    .addHelpText('after', notes)
    .action(async (a: string, b: string, flags: CompareFlags) =>
      (await import('./compareAction.ts')).compare(a, b, flags),
    );
}
