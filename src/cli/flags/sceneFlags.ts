import { type Command, Option } from 'commander';
import { ANY_FORMAT_FILE } from '../../formats/formatLists.ts';
import type { Interpolation, ReadOptions } from '../../formats/readOptions.ts';
import { listed, msg } from '../../messages/message.ts';
import { type Flight, isAtOrBelow, tooLargeToFly } from '../../scene/motion/fly.ts';
import { changeMotion, type MotionChange } from '../../scene/motion/motionChange.ts';
import type { Scene, SceneObject } from '../../scene/types.ts';
import { renderableScene } from '../../scene/validation/renderableScene.ts';
import { openSceneFile } from '../files/sceneFiles.ts';
import { InvalidValue } from '../terminal/commandLineErrors.ts';
import { inputProblem, usageError } from '../terminal/exitCodes.ts';
import { localized } from '../terminal/language.ts';
import { addVariant, parseBeta, parseLevels, parseNumber, parsePositive } from './parse.ts';
import { speedOfLight } from './viewFlags.ts';

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

export const SCENE_ARGUMENT = msg`${ANY_FORMAT_FILE} file; or a .zip with one, set.zip[scene.usda] to choose one of several`;

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

export const readOptions = ({ variant, animation, interpolation, subdivision }: SceneFlags): ReadOptions => ({
  interpolation,
  ...(variant && { variants: variant }),
  ...(subdivision !== undefined && { subdivision }),
  ...(animation !== undefined && { animation: /^\d+$/.test(animation) ? Number(animation) : animation }),
});

export const motionChange = ({
  speedFactor = 1,
  startOffset = 0,
  fly = [],
  flyShape = 'rest',
}: SceneFlags): MotionChange => ({
  timing: { speed: speedFactor, offset: startOffset },
  flights: fly.map((flight) => ({ ...flight, authoredIn: flyShape })),
});

/** Opens a scene file with the flags' motions, without objects that cannot be drawn. */
export async function openSceneWithFlags(path: string, flags: SceneFlags): Promise<Scene> {
  const { scene } = renderableScene(await openSceneFile(path, readOptions(flags)));
  for (const flight of flags.fly ?? []) checkFlyFlag(scene, flight.path);
  return changeMotion(scene, motionChange(flags), speedOfLight(scene, flags.c));
}

function checkFlyFlag(scene: Scene, path: string): void {
  const near = scene.objects.map((object) => object.path).slice(0, 8);
  if (!scene.objects.some((object) => isAtOrBelow(object.path, path)))
    throw usageError(msg`--fly ${path}: the scene has no such thing; it has ${listed(near) || msg`none`}`);
  const [large] = tooLargeToFly(scene, path);
  if (large !== undefined) throw inputProblem(msg`${large}: it deforms, and has too many samples to be carried along`);
}
