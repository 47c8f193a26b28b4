import { Command } from 'commander';
import { msg } from '../../messages/message.ts';
import { explicitFlags } from '../flags/explicitFlags.ts';
import { addText } from '../flags/parse.ts';
import { SCENE_ARGUMENT } from '../flags/sceneFlags.ts';
import { addSceneOrProjectFlags } from '../flags/sceneOrProjectFlags.ts';
import { observerTimeOption } from '../flags/viewFlags.ts';
import { examples } from '../terminal/help.ts';
import { localized } from '../terminal/language.ts';
import type { ClocksFlags } from './clocksFlags.ts';

const EXAMPLES = [
  'slowlight clocks dice.usdc --time 2 --beta 0,0,-0.6',
  'slowlight clocks street.usdc --prim /World/Clock --flight street.flight.json',
];

export function clocksCommand(): Command {
  const command = new Command('clocks')
    .description(
      localized(
        msg`Says what clocks of the observer, of the world and of objects show: as seen, in the observer’s slice of simultaneity, and at his world time; and at what rates.`,
      ),
    )
    .argument('<scene>', localized(msg`${SCENE_ARGUMENT}; or a .slowlight.json project`))
    .option(
      '--prim <path>',
      localized(
        msg`an object whose clock is read, with those below it; repeatable (default: what moves, else everything; the first 12 things)`,
      ),
      addText,
    )
    .addOption(observerTimeOption())
    .option(
      '--flight <file>',
      localized(
        msg`the observer is the pilot of a recorded flight, NAME.flight.json, and --time the pilot's time from its beginning (default: its end)`,
      ),
    );
  return addSceneOrProjectFlags(command)
    .option('--json', localized(msg`print as JSON`))
    .addHelpText('after', examples(EXAMPLES))
    .action(async (scene: string, flags: ClocksFlags) =>
      (await import('./clocksAction.ts')).clocks(scene, flags, explicitFlags(command)),
    );
}
