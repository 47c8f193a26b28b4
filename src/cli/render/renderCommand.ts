import { Command, Option } from 'commander';
import { FRAME_SPACINGS } from '../../flight/spacing.ts';
import { inClauses, listed, msg } from '../../messages/message.ts';
import { PIPELINES } from '../../pipelines/registry.ts';
import { AOVS } from '../../scene/view/view.ts';
import { FALSE_COLOR_QUANTITIES } from '../../spectrum/falseColor/falseColor.ts';
import { explicitFlags } from '../flags/explicitFlags.ts';
import {
  parseAovs,
  parseFrames,
  parsePositive,
  parseRange,
  parseSamples,
  parseVec3,
  sizeOption,
} from '../flags/parse.ts';
import { addPipelineFlags } from '../flags/pipelineFlags.ts';
import { addSceneFlags, SCENE_ARGUMENT } from '../flags/sceneFlags.ts';
import { projectSetOption } from '../flags/sceneOrProjectFlags.ts';
import { addObserverFlags, addSettingFlags, observerTimeOption } from '../flags/viewFlags.ts';
import { usageError } from '../terminal/exitCodes.ts';
import { examples } from '../terminal/help.ts';
import { localized } from '../terminal/language.ts';
import type { ProjectFilesFlags, RenderFlags } from './renderFlags.ts';

type Optional<T, K extends keyof T> = Omit<T, K> & Partial<Pick<T, K>>;

const DEFAULT_SAMPLES = inClauses(
  PIPELINES.map(({ id, samples: { default: n, note } }) => {
    const samples = msg`${n} of ${id}`;
    return note ? msg`${samples}, ${note}` : samples;
  }),
);

const EXAMPLES = [
  'slowlight render street.usdc -o street.png --time 2 --c 10 --beta 0,0,-0.8',
  'slowlight render street.usdc -o street.exr --aov beauty,depth,doppler --size 1920x1080',
  'slowlight render street.usdc -o street.mp4 --frames 1:96 --fps 24',
  'slowlight render street.usdc -o street.gif --frames 1:96 --fps 25 --size 480x270',
  "slowlight render street.usdc -o 'street.####.png' --frames 1:96",
  'slowlight render street.usdc -o flown.mp4 --flight street.flight.json --fps 24',
  'slowlight render street.usdc -o around.png --lens equirectangular --beta 0,0,-0.9',
  'slowlight render street.usdc -o dome.png --lens dome --dome-tilt 20 --size 4096x4096',
  'slowlight render street.usdc -o truth.png --pipeline reference --samples 8',
  'slowlight render street.usdc -o shift.png --false-colour doppler --legend --beta 0,0,-0.5',
  'slowlight render workshop.slowlight.json -o workshop.png --set console.speedOfLight=10',
];

export function renderCommand(): Command {
  const command = new Command('render')
    .description(
      localized(msg`Renders a scene or a project as .png, .exr with data channels, or a film: .mp4 or .gif.`),
    )
    .argument('<scene>', localized(msg`${SCENE_ARGUMENT}; or a .slowlight.json project`))
    .option(
      '-o, --output <file>',
      localized(
        msg`output file; #### in the name of a .png or .exr is replaced by the frame number (default: the files that the nodes of a project write)`,
      ),
    )
    .option(
      '--folder <folder>',
      localized(msg`for a project, without -o: folder that its files are written to (default: the current one)`),
    )
    .addOption(
      sizeOption(
        msg`picture size in pixels; of --lens equirectangular by default 2048x1024, of fisheye and dome 1024x1024, of cube 1536x1024, of cube-strip 3072x512, of stereo 2048x2048`,
      ),
    )
    .addOption(observerTimeOption())
    .option('--frames <A:B>', localized(msg`first and last frame; frame n is at world time n/fps`), parseFrames)
    .option(
      '--fps <n>',
      localized(
        msg`frames per second (default: the scene's time codes per second); a .gif has at most 50, of whole hundredths of a second: at 24, four or five each`,
      ),
      parsePositive,
    )
    .addOption(
      new Option(
        '--spacing <clock>',
        localized(
          msg`with --frames: whether n/fps is world time or proper time, of the observer's own clock; the clock on a moving camera shows 0 at world time 0, that of one who coasts starts with the first frame, and both begin with a flight (default: world, of a flight proper)`,
        ),
      ).choices(FRAME_SPACINGS),
    );
  addObserverFlags(addSceneFlags(command)).option(
    '--stay-in-place',
    localized(msg`with --frames: keep the observer in place instead of moving it with its velocity`),
  );
  command.option(
    '--vantage <x,y,z>',
    localized(
      msg`where the camera stands, from the observer's eye, on his axes [m]: everything stays as and where he sees it, and is looked at from there`,
    ),
    parseVec3,
  );
  command.option(
    '--flight <file>',
    localized(
      msg`film a recorded flight, NAME.flight.json: frame n is at n/fps of the pilot's time from its beginning, or of world time (--spacing), --time likewise (default: all of it)`,
    ),
  );
  addSettingFlags(command)
    .option('--samples <n>', localized(msg`n × n samples per pixel (default: ${DEFAULT_SAMPLES})`), parseSamples)
    .addOption(
      new Option(
        '--false-colour <what>',
        localized(
          msg`false colours: the Doppler factor, emission time relative to the observer, luminance before exposure, or the emitted wavelength that is visible`,
        ),
      ).choices(FALSE_COLOR_QUANTITIES),
    )
    .option(
      '--false-range <from:to>',
      localized(
        msg`values at both ends of the colour scale; emission-time in seconds, band in metres (default: round numbers that enclose the values of the first picture)`,
      ),
      parseRange,
    )
    .option('--legend', localized(msg`with --false-colour, --ghost or --past-future: add a legend below the picture`))
    .option(
      '--aov <names>',
      localized(msg`for .exr: data channels to write, comma-separated: ${listed(Object.keys(AOVS))}`),
      parseAovs,
    );
  return (
    addPipelineFlags(command)
      .addOption(projectSetOption())
      .option('--json', localized(msg`print a report as JSON`))
      .addHelpText('after', examples(EXAMPLES))
      // Imported lazily: the renderer is large.
      .action(async (scene: string, { output, ...flags }: Optional<RenderFlags, 'output'> & ProjectFilesFlags) => {
        const given = explicitFlags(command);
        if (output === undefined && flags.flight !== undefined)
          throw usageError(msg`--flight films with -o; nodes of a project film on their own`);
        if (output === undefined) return (await import('./projectFiles.ts')).writeProjectFiles(scene, flags, given);
        if (flags.folder !== undefined) throw usageError(msg`--folder is for the files of a project; -o names its own`);
        return (await import('./renderAction.ts')).render(scene, { output, ...flags }, given);
      })
  );
}
