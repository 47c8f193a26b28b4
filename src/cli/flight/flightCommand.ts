import { Command } from 'commander';
import { msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT, STANDARD_GRAVITY } from '../../physics/constants.ts';
import { parseNotNegative, parseNumber, parsePositive, parseVec3, parseWithin } from '../flags/parse.ts';
import { examples } from '../terminal/help.ts';
import { localized } from '../terminal/language.ts';
import type { CutFlags, TripFlags } from './flightFlags.ts';

const EXAMPLES = [
  'slowlight flight trip --to 0,0,-4.07e16 -o star.flight.json        # 4.3 light-years at 1 g',
  'slowlight flight inspect star.flight.json',
  'slowlight flight cut street.flight.json --from 2 --to 5 -o short.flight.json',
  'slowlight render street.usdc --flight short.flight.json -o short.mp4',
];

const OUTPUT = '-o, --output <file>';
const FILE = 'NAME.flight.json';
const READ = () => localized(msg`file of a flight, ${FILE}`);
const WRITTEN = () => localized(msg`file to write, ${FILE}`);

/** `slowlight flight trip|inspect|cut|splice` */
export function flightCommand(): Command {
  const command = new Command('flight')
    .description(localized(msg`Plans trips, and inspects, cuts and joins recorded flights.`))
    .addHelpText('after', examples(EXAMPLES));
  command
    .command('trip')
    .description(
      localized(
        msg`Plans the fastest trip to a place at rest with a constant proper acceleration: half the way forwards, half the way back.`,
      ),
    )
    .requiredOption('--to <x,y,z>', localized(msg`where it ends, world frame [m]`), parseVec3)
    .option('--from <x,y,z>', localized(msg`where it begins, at rest, world frame [m]`), parseVec3, [0, 0, 0])
    .option('--acceleration <m/s²>', localized(msg`proper acceleration`), parsePositive, STANDARD_GRAVITY)
    .option('--c <m/s>', localized(msg`speed of light`), parsePositive, SPEED_OF_LIGHT)
    .option('--start <s>', localized(msg`world time of the beginning`), parseNumber, 0)
    .option(
      '--max-speed <beta>',
      localized(msg`coast at this part of c (default: none)`),
      parseWithin({ above: 0, max: 1 - 2 ** -53 }),
    )
    .option('--return', localized(msg`and back again`))
    .requiredOption(OUTPUT, WRITTEN())
    .option('--json', localized(msg`print a report as JSON`))
    .action(async (flags: TripFlags) => (await import('./flightAction.ts')).trip(flags));
  command
    .command('inspect')
    .description(
      localized(msg`Says how long a flight lasts on both clocks, how fast it is, and of what legs it is made.`),
    )
    .argument('<flight>', READ())
    .option('--json', localized(msg`print a report as JSON`))
    .action(async (path: string, flags: { json?: boolean }) =>
      (await import('./flightAction.ts')).inspectFlight(path, flags),
    );
  command
    .command('cut')
    .description(localized(msg`Writes the part of a flight between two of the pilot's times.`))
    .argument('<flight>', READ())
    .option('--from <s>', localized(msg`pilot's time from the beginning (default: the beginning)`), parseNotNegative)
    .option('--to <s>', localized(msg`pilot's time from the beginning (default: the end)`), parseNotNegative)
    .requiredOption(OUTPUT, WRITTEN())
    .action(async (path: string, flags: CutFlags) => (await import('./flightAction.ts')).cut(path, flags));
  command
    .command('splice')
    .description(localized(msg`Writes flights one after the other as one.`))
    .argument('<flights...>', READ())
    .requiredOption(OUTPUT, WRITTEN())
    .action(async (paths: string[], flags: { output: string }) =>
      (await import('./flightAction.ts')).splice(paths, flags),
    );
  return command;
}
