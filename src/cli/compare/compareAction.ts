import { extname } from 'node:path';
import { encodePng } from '../../formats/image/encodePng.ts';
import { listed, msg } from '../../messages/message.ts';
import { VISIBLE_POINT_CHANNELS } from '../../reference/compare/channels.ts';
import { comparisonSheet, errorMap } from '../../reference/figures/errorMap.ts';
import { checkWritable, writeFileAtomically } from '../files/outputFile.ts';
import { CliError, EXIT, inputProblem, usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import type { CompareFlags } from './compareFlags.ts';
import { comparePair, type ErrorMap } from './metrics.ts';
import { displayCanvas, openPair, type PictureFile } from './pictureFiles.ts';
import { compareLines, percent } from './table.ts';

export async function compare(pathA: string, pathB: string, flags: CompareFlags): Promise<void> {
  checkFlags(flags);
  const [a, b] = await openPair(pathA, pathB);
  const { findings, share, map } = comparePair(a, b, flags);
  if (!map && (flags.output !== undefined || flags.failAbove !== undefined)) throw missingDisplacementChannels();
  if (map && flags.output !== undefined) writeFileAtomically(flags.output, drawErrorSheet(a, b, map, flags));
  const about = { a: pathA, b: pathB, width: a.width, height: a.height };
  console.log(flags.json ? toJson({ ...about, ...findings }) : compareLines(about, findings).join('\n'));
  if (share !== undefined && flags.failAbove !== undefined && share > flags.failAbove)
    throw new CliError(
      EXIT.different,
      msg`${percent(share)} of the pixels are different, and --fail-above allows ${percent(flags.failAbove)}`,
    );
}

function checkFlags({ output, triptych, metric, channel }: CompareFlags): void {
  if (triptych && output === undefined) throw usageError(msg`--triptych needs a picture to draw: give -o FILE.png`);
  if (channel !== undefined && metric !== 'aov') throw usageError(msg`--channel goes with --metric aov`);
  if (output === undefined) return;
  if (extname(output).toLowerCase() !== '.png') throw usageError(msg`--output ${output}: its name must end in .png`);
  checkWritable(output);
}

const missingDisplacementChannels = (): CliError =>
  inputProblem(
    msg`displacement needs the channels ${listed(VISIBLE_POINT_CHANNELS)} in both: render with --aov position,object, or name another by --channel`,
  );

function drawErrorSheet(
  a: PictureFile,
  b: PictureFile,
  { title, errors, max }: ErrorMap,
  flags: CompareFlags,
): Uint8Array {
  const map = errorMap(errors, a.width, a.height, max);
  const shown = (picture: PictureFile, caption: string) => ({
    picture: displayCanvas(picture, flags.exposure),
    caption,
  });
  const pictures = flags.triptych
    ? [shown(a, 'A'), shown(b, 'B'), { picture: map, caption: `ERROR: ${title}` }]
    : [{ picture: map }];
  const { width, height, pixels } = comparisonSheet(pictures, { title, max });
  return encodePng(width, height, pixels);
}
