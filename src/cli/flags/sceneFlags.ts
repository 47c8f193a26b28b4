import { type Command, Option } from 'commander';
import { ANY_FORMAT_FILE } from '../../formats/formatLists.ts';
import type { Interpolation } from '../../formats/readOptions.ts';
import { msg } from '../../messages/message.ts';
import type { Flight } from '../../scene/motion/fly.ts';
import type { SceneObject } from '../../scene/types.ts';
import { InvalidValue } from '../terminal/commandLineErrors.ts';
import { localized } from '../terminal/language.ts';
import { addVariant, parseBeta, parseLevels, parseNumber, parsePositive } from './parse.ts';

/** Which parts of a file are opened, and changes of its motions. */
export interface SceneFlags {
  readonly variant?: ReadonlyMap<string, string>;
  readonly animation?: string;
  readonly interpolation: Interpolation;
  readonly subdivision?: number;
  readonly speedFactor?: number;
  readonly startOffset?: number;
  readonly fly?: readonly FlyFlag[];
  readonly flyShape?: SceneObject['authoredIn'];
  /** Only for commands with `--c` [m/s]. */
  readonly c?: number;
}

const interpolations: readonly Interpolation[] = ['linear', 'cubic'];

type FlyFlag = Omit<Flight, 'authoredIn'>;

export const SCENE_ARGUMENT = msg`${ANY_FORMAT_FILE} file; a panorama (a picture or a film); or a .zip with one, set.zip[scene.usda] to choose one of several`;

export const addSceneFlags = (command: Command): Command =>
  command
    .option(
      '--variant <set=option>',
      localized(msg`select a variant, as listed by inspect: '/World/Car{paint}=red'; repeatable`),
      addVariant,
    )
    .option('--animation <name>', localized(msg`glTF: animation to play, by name or index from 0 (default: the first)`))
    .addOption(
      new Option(
        '--interpolation <name>',
        localized(msg`USD: interpolation between time samples; USD specifies linear`),
      )
        .choices(interpolations)
        .default('linear'),
    )
    .option(
      '--subdivision <n>',
      localized(
        msg`USD: subdivision levels; 0 draws the polygons (default: as many as look smooth, fewer if there would be too many faces)`,
      ),
      parseLevels,
    )
    .option('--speed-factor <k>', localized(msg`factor on the speed of the animation`), parsePositive)
    .option('--start-offset <s>', localized(msg`delay of the animation [s]; negative: earlier`), parseNumber)
    .option(
      '--fly <prim=x,y,z@t>',
      localized(
        msg`make a prim and its descendants move at this velocity in units of c, passing their authored positions at t [s] (default 0): '/World/Car=0.8,0,0@2'; repeatable`,
      ),
      addFlyFlag,
    )
    .addOption(
      new Option(
        '--fly-shape <name>',
        localized(msg`with --fly: whether the file has the rest shape, or the shape in the world frame while moving`),
      )
        .choices(['rest', 'world'])
        .default('rest'),
    );

function addFlyFlag(text: string, before: readonly FlyFlag[] = []): readonly FlyFlag[] {
  const [, path, velocity, at = '0'] = /^([^=]+)=([^@]+)(?:@(.+))?$/.exec(text) ?? [];
  if (path === undefined || velocity === undefined)
    throw new InvalidValue(msg`Expected PRIM=X,Y,Z or PRIM=X,Y,Z@T, like /World/Car=0.8,0,0@2.`);
  return [...before, { path, beta: parseBeta(velocity), at: parseNumber(at) }];
}
