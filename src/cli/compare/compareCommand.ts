import { Command, Option } from 'commander';
import { type Message, msg } from '../../messages/message.ts';
import { parseFraction, parseNotNegative, parseNumber, parsePositive } from '../flags/parse.ts';
import { examples, section } from '../terminal/help.ts';
import { localized } from '../terminal/language.ts';
import type { CompareFlags, Metric } from './compareFlags.ts';

const METRICS: Readonly<Record<Metric, Message>> = {
  flip: msg`perceived difference when alternating between the pictures (FLIP), 0 … 1; for .exr over all relevant exposures`,
  pixels: msg`absolute differences of sRGB values 0 … 1, for .exr of linear light`,
  aov: msg`differences of .exr channels, and the displacement of A's points in B in pixels`,
};

const EXAMPLES = [
  'slowlight compare fast.png exact.png -o error.png',
  'slowlight compare fast.png exact.png -o error.png --triptych',
  'slowlight compare fast.exr exact.exr --metric aov -o moved.png',
  "slowlight compare fast.png exact.png --metric pixels --threshold 0 --fail-above 0 || echo 'not the same'",
];

const metricLines = (): readonly Message[] =>
  Object.entries(METRICS).map(([metric, meaning]) => msg`${metric.padEnd(9)}${meaning}`);

export function compareCommand(): Command {
  return new Command('compare')
    .description(localized(msg`Compares two pictures: statistics and an error map.`))
    .argument('<A>', localized(msg`test picture: .png, .jpg or .exr`))
    .argument('<B>', localized(msg`reference picture`))
    .addOption(
      new Option('--metric <name>', localized(msg`error metric, see below`))
        .choices(Object.keys(METRICS))
        .default('flip'),
    )
    .option('-o, --output <file>', localized(msg`error map, .png`))
    .option('--triptych', localized(msg`with -o: A, B and the error side by side`))
    .option(
      '--channel <name>',
      localized(msg`with --metric aov: use the differences of this channel for map and fraction`),
    )
    .option(
      '--threshold <x>',
      localized(msg`error above which a pixel counts as different (default: flip 0.1, pixels 0.02, aov 0.5 px)`),
      parseNotNegative,
    )
    .option(
      '--fail-above <share>',
      localized(msg`exit with code 5 if more than this fraction of the pixels, 0 … 1, is different`),
      parseFraction,
    )
    .option('--max <x>', localized(msg`error shown in the brightest colour of the map`), parsePositive)
    .option('--exposure <EV>', localized(msg`with --triptych: show .exr pictures 2^EV times as bright`), parseNumber, 0)
    .option('--json', localized(msg`print as JSON`))
    .addHelpText('after', `${section(msg`Metrics:`, metricLines())}\n${examples(EXAMPLES)}`)
    .action(async (a: string, b: string, flags: CompareFlags) =>
      (await import('./compareAction.ts')).compare(a, b, flags),
    );
}
