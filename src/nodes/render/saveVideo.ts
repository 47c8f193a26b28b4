import type { FlightRecording } from '../../flight/recording/recording.ts';
import type { FrameSpacing } from '../../flight/spacing.ts';
import { extensionOf } from '../../formats/files/fileSource.ts';
import { gifProblem, MAX_GIF_RATE, MAX_GIF_SIDE, MIN_GIF_RATE } from '../../formats/image/gif/gifLimits.ts';
import { msg } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import { nodeRefusal, readOrRefuse, timeParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { checkedFileName, frameCount, type VideoOutput } from '../project/outputFiles.ts';
import type { Services } from '../services.ts';
import { pictureSizeParams, pictureToSave, samplesParam } from './saveParams.ts';

/** Maximum number of frames: three quarters of an hour at 24 frames per second. */
const MAX_FRAMES = 65_536;

/** For what a flight says itself. */
const UNFLOWN = { param: 'flight', is: '' } as const;

/** Requests that an image is saved over a time range, as a film or as frames; passes it through. */
export const saveVideoNode = defineNode({
  id: 'save-video',
  title: msg`Save video`,
  help: msg`Requests that the image is saved over a time range, as a film or one file per frame, and passes it through. The node’s button downloads it; “slowlight render PROJECT” without -o writes it.`,
  category: 'render',
  params: {
    name: {
      kind: 'text',
      title: msg`File name`,
      help: msg`Without folders. .mp4 and .gif are films; .png and .exr are frames, whose numbers replace ####: film.####.png. A .gif repeats for ever, has 256 colours, and frames of whole hundredths of a second, right on average.`,
      default: 'film.mp4',
    },
    ...pictureSizeParams,
    flight: {
      kind: 'text',
      title: msg`Flight`,
      help: msg`A recorded flight, .flight.json: all of it is filmed, instead of what the camera sees.`,
      default: '',
      file: true,
    },
    from: { ...timeParam(msg`From`, 0), suggestion: 'startTime', onlyWhen: UNFLOWN },
    to: { ...timeParam(msg`To`, 0), suggestion: 'endTime', onlyWhen: UNFLOWN },
    fps: {
      kind: 'number',
      title: msg`Frames per second`,
      unit: '1/s',
      default: 24,
      min: 0.001,
      max: 1000,
      step: 1,
      slider: false,
      suggestion: 'timeCodesPerSecond',
    },
    spacing: {
      kind: 'choice',
      title: msg`Times are`,
      help: msg`Proper: of the clock of the observer, who rides a moving camera, coasts, or flies a flight.`,
      default: 'world',
      options: [
        { value: 'world', title: msg`World time` },
        { value: 'proper', title: msg`Proper time` },
      ],
    },
    stayInPlace: {
      kind: 'boolean',
      title: msg`Observer stays in place`,
      help: msg`On: the picture has the observer’s velocity, from a fixed position. Off: the observer coasts.`,
      default: false,
      onlyWhen: UNFLOWN,
    },
    samples: samplesParam(2),
  },
  inputs: { image: { type: 'image' } },
  outputs: { image: { type: 'image' }, file: { type: 'file', title: msg`File` } },
  async evaluate(
    { image },
    { name, width, height, flight, spacing, stayInPlace, samples, ...range },
    { node, services },
  ) {
    const called = checkedFileName(name, ['mp4', 'gif', 'png', 'exr'], node);
    const picture = pictureToSave(image, called, { width, height }, node);
    const { startTime, endTime, timeCodesPerSecond } = picture.scene;
    const flown = flight === '' ? undefined : await flownSpan(flight, spacing, picture.speedOfLight, node, services);
    const { from, to } = flown ?? { from: range.from ?? startTime, to: range.to ?? endTime };
    const span = { from, to, fps: range.fps ?? timeCodesPerSecond };
    assertFrameRange(span, node);
    const kind = extensionOf(called);
    if (kind === 'mp4') assertEvenSize({ width, height }, node);
    else if (kind === 'gif') assertGif({ width, height, fps: span.fps }, node);
    else assertFrameNumber(called, node);
    const film = {
      kind: 'video',
      name: called,
      picture,
      width,
      height,
      samples,
      spacing,
      stayInPlace,
      ...span,
    } as const;
    return { image, file: { ...film, ...(flown && { flight: flown.flight }) } };
  },
});

/** A flight of a file, and the times of the clock that a film of it follows [s]. */
async function flownSpan(
  file: string,
  spacing: FrameSpacing,
  c: number,
  node: string,
  services: Services,
): Promise<Pick<VideoOutput, 'from' | 'to'> & { readonly flight: FlightRecording }> {
  const { parseFlight } = await import('../flights/flightFile.ts');
  const { FlightPlayback } = await import('../../flight/recording/playback.ts');
  const { assertFlownAt, filmClockOf } = await import('../flights/flightPath.ts');
  const bytes = await readOrRefuse(() => services.readFile(file), { node, param: 'flight', value: '' });
  try {
    const flight = parseFlight(new TextDecoder().decode(bytes));
    assertFlownAt(flight, c);
    return { flight, from: 0, to: filmClockOf(new FlightPlayback(flight), spacing).duration };
  } catch (error) {
    if (!(error instanceof MessageError)) throw error;
    throw nodeRefusal('file.flight', `${node}.flight`, msg`${file}: ${messageOf(error)}`);
  }
}

function assertFrameRange(span: Pick<VideoOutput, 'from' | 'to' | 'fps'>, node: string): void {
  const { from, to, fps } = span;
  if (to < from) {
    const message = msg`it ends at ${to} s, before it begins at ${from} s`;
    throw nodeRefusal('file.span', `${node}.to`, message, { node, param: 'to', value: from });
  }
  const count = frameCount(span);
  if (count <= MAX_FRAMES) return;
  const message = msg`${count} frames are more than ${MAX_FRAMES}; let it be shorter, or of fewer frames per second`;
  throw nodeRefusal('file.frames', `${node}.to`, message, { node, param: 'to', value: from + (MAX_FRAMES - 1) / fps });
}

/** Video chroma is subsampled in blocks of 2 × 2 pixels. */
function assertEvenSize(size: Pick<VideoOutput, 'width' | 'height'>, node: string): void {
  for (const param of ['width', 'height'] as const) {
    if (size[param] % 2 === 0) continue;
    const message = msg`an .mp4 needs an even width and height; ${param} is ${size[param]}`;
    throw nodeRefusal('file.even', `${node}.${param}`, message, { node, param, value: size[param] + 1 });
  }
}

function assertGif(film: Pick<VideoOutput, 'width' | 'height' | 'fps'>, node: string): void {
  const problem = gifProblem(film, film.fps);
  if (!problem) return;
  const { fps } = film;
  if (fps > MAX_GIF_RATE || fps < MIN_GIF_RATE) {
    const value = fps > MAX_GIF_RATE ? MAX_GIF_RATE : 0.002;
    throw nodeRefusal('file.rate', `${node}.fps`, problem, { node, param: 'fps', value });
  }
  const param = film.width > MAX_GIF_SIDE ? 'width' : 'height';
  throw nodeRefusal('file.size', `${node}.${param}`, problem, { node, param, value: MAX_GIF_SIDE });
}

function assertFrameNumber(name: string, node: string): void {
  if (name.includes('#')) return;
  const value = name.replace(/(\.\w+)$/, '.####$1');
  const message = msg`"${name}": several frames need a place for their number, like ${value}; or write an .mp4`;
  throw nodeRefusal('file.frame', `${node}.name`, message, { node, param: 'name', value });
}
