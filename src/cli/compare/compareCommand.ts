import { Command, Option } from 'commander';
import { parseFraction, parseNotNegative, parseNumber, parsePositive } from '../flags/parse.ts';
import type { CompareFlags, Metric } from './compareFlags.ts';

const metrics: readonly Metric[] = ['flip', 'pixels', 'aov'];

const notes = `
Metrics:
  flip     the difference that a person sees who looks at both in turn (FLIP), 0 … 1; of .exr over all exposures that matter
  pixels   plain differences: of sRGB values 0 … 1, of .exr linear light
  aov      .exr channel by channel, and how many pixels A's points are displaced in B

Examples:
  slowlight compare fast.png exact.png -o error.png
  slowlight compare fast.png exact.png -o error.png --triptych
  slowlight compare fast.exr exact.exr --metric aov -o moved.png
  slowlight compare fast.png exact.png --metric pixels --threshold 0 --fail-above 0 || echo 'not the same'`;

export function compareCommand(): Command {
  return new Command('compare')
    .description('Tells how two pictures differ, in figures and as an error map.')
    .argument('<A>', 'the picture that is judged: .png, .jpg or .exr')
    .argument('<B>', 'the picture that it should be')
    .addOption(new Option('--metric <name>', 'what is measured, see below').choices(metrics).default('flip'))
    .option('-o, --output <file>', 'error map to write, .png')
    .option('--triptych', 'with -o: A and B beside the error')
    .option('--channel <name>', 'with --metric aov: map and share of the differences of this channel')
    .option(
      '--threshold <x>',
      'a pixel with a larger error counts as different (default: flip 0.1, pixels 0.02, aov 0.5 px)',
      parseNotNegative,
    )
    .option(
      '--fail-above <share>',
      'end with exit code 5 where more than this share of the pixels, 0 … 1, is different',
      parseFraction,
    )
    .option('--max <x>', 'error that the map shows in its brightest colour', parsePositive)
    .option('--exposure <EV>', 'with --triptych: show .exr pictures 2^EV times as bright', parseNumber, 0)
    .option('--json', 'print as JSON')
    .addHelpText('after', notes)
    .action(async (a: string, b: string, flags: CompareFlags) =>
      (await import('./compareAction.ts')).compare(a, b, flags),
    );
}
