import { Command, Option } from 'commander';
import { DIAGRAM_KINDS } from '../../diagrams/sceneDiagram.ts';
import { DIAGRAM_FRAMES } from '../../diagrams/spacetimeDiagram.ts';
import { msg } from '../../messages/message.ts';
import { explicitFlags } from '../flags/explicitFlags.ts';
import { addText, parsePositive, parseVec3, sizeOption } from '../flags/parse.ts';
import { SCENE_ARGUMENT } from '../flags/sceneFlags.ts';
import { addSceneOrProjectFlags } from '../flags/sceneOrProjectFlags.ts';
import { observerTimeOption } from '../flags/viewFlags.ts';
import { examples } from '../terminal/help.ts';
import { localized } from '../terminal/language.ts';
import type { DiagramFlags } from './diagramFlags.ts';

const EXAMPLES = [
  'slowlight diagram street.usdc -o street.svg --time 5 --beta 0,0,-0.6',
  'slowlight diagram ladder.usdc -o ladder.svg --prim /World/Ladder --frame observer',
  'slowlight diagram dice.usdc -o cone.svg --second-axis 1,0,0',
  'slowlight diagram boxes.usdc -o energy.svg --of energy',
];

export function diagramCommand(): Command {
  const command = new Command('diagram')
    .description(
      localized(
        msg`Draws as .svg a spacetime diagram of an observer’s event, with world lines, light cone and simultaneity; or energy and momentum over speed.`,
      ),
    )
    .argument('<scene>', localized(msg`${SCENE_ARGUMENT}; or a .slowlight.json project`))
    .requiredOption('-o, --output <file>', localized(msg`output file, .svg`))
    .addOption(new Option('--of <what>', localized(msg`what is drawn`)).choices(DIAGRAM_KINDS).default('spacetime'))
    .option(
      '--prim <path>',
      localized(
        msg`an object whose world line is drawn, with those below it; repeatable (default: what moves, else everything; the first 12 things)`,
      ),
      addText,
    )
    .addOption(observerTimeOption())
    .addOption(
      new Option('--frame <frame>', localized(msg`the frame that is drawn: the world’s, or the observer’s rest frame`))
        .choices(DIAGRAM_FRAMES)
        .default('world'),
    )
    .option(
      '--axis <x,y,z>',
      localized(
        msg`direction of the x axis (default: the observer’s velocity; at rest that of the fastest object, else towards the most distant one)`,
      ),
      parseVec3,
    )
    .option(
      '--second-axis <x,y,z>',
      localized(msg`a second direction: the diagram has two dimensions of space`),
      parseVec3,
    )
    .option(
      '--span <m>',
      localized(msg`half the length of the x axis [m] (default: as far as the events that are seen)`),
      parsePositive,
    )
    .addOption(
      new Option('--theme <theme>', localized(msg`colours on a light or a dark ground`))
        .choices(['light', 'dark'])
        .default('light'),
    )
    .addOption(sizeOption(msg`picture size in pixels`));
  return addSceneOrProjectFlags(command)
    .addHelpText('after', examples(EXAMPLES))
    .action(async (scene: string, flags: DiagramFlags) =>
      (await import('./diagramAction.ts')).diagram(scene, flags, explicitFlags(command)),
    );
}
