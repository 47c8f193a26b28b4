import { extname } from 'node:path';
import { GifEncoder } from '../../formats/image/gif/encodeGif.ts';
import { gifProblem } from '../../formats/image/gif/gifLimits.ts';
import { anyOf, msg } from '../../messages/message.ts';
import { encodeExrPicture, encodePngPicture, frameName } from '../../nodes/pictures/encode.ts';
import type { PictureFrame } from '../../nodes/pictures/sequence.ts';
import { sphericalFileOf } from '../../nodes/pictures/sphericalFile.ts';
import type { Scene } from '../../scene/types.ts';
import type { SphericalPicture } from '../../scene/view/sphericalPicture.ts';
import { checkWritable, OutputFile, writeFileAtomically } from '../files/outputFile.ts';
import { usageError } from '../terminal/exitCodes.ts';
import type { RenderFlags } from './renderFlags.ts';
import { checkEncoder, VIDEO_EXTENSION, VideoWriter } from './videoWriter.ts';

export interface FrameSink {
  /** Paths of the files written so far. */
  readonly files: readonly string[];
  add(frame: PictureFrame): Promise<void>;
  finish(): Promise<void>;
  /** Removes unfinished files; does nothing after `finish`. */
  discard(): void;
}

type OpenSink = (flags: RenderFlags, scene: Scene) => FrameSink | Promise<FrameSink>;

/** By the extension of the output. */
const SINKS: ReadonlyMap<string, OpenSink> = new Map<string, OpenSink>([
  ['.png', ({ output, size }) => fileSink(output, (frame) => encodePngPicture(size, frame.rendered, frame))],
  [
    '.exr',
    ({ output, size }, scene) => fileSink(output, (frame) => encodeExrPicture(size, frame.rendered, frame, scene)),
  ],
  [`.${VIDEO_EXTENSION}`, (flags, scene) => videoSink(flags, flags.fps ?? scene.timeCodesPerSecond)],
  ['.gif', (flags, scene) => gifSink(flags, flags.fps ?? scene.timeCodesPerSecond)],
]);

/** Extensions of films, which need several frames. */
const isFilm = (output: string): boolean => /\.(mp4|gif)$/i.test(output);

const sinkOf = (output: string): OpenSink | undefined => SINKS.get(extname(output).toLowerCase());

/** Throws if the output does not fit the other flags, or cannot be written; called before the scene is read, which may take minutes. */
export function checkOutput({ output, frames, time, flight, spacing }: RenderFlags): void {
  if (!sinkOf(output)) throw usageError(msg`--output ${output}: its name must end in ${anyOf([...SINKS.keys()])}`);
  if (isFilm(output) && !frames && flight === undefined)
    throw usageError(msg`a film, .mp4 or .gif, needs --frames FIRST:LAST`);
  if (spacing && !frames && flight === undefined)
    throw usageError(msg`--spacing is for several frames: add --frames FIRST:LAST`);
  if (frames && time !== undefined) throw usageError(msg`--time and --frames exclude each other`);
  if (frames && frames.last > frames.first && !isFilm(output) && !output.includes('#')) {
    const pattern = output.replace(/(\.\w+)$/, '.####$1');
    throw usageError(msg`--output ${output}: several frames need a place for their number, like ${pattern}`);
  }
  checkWritable(output);
  if (extname(output).toLowerCase() === `.${VIDEO_EXTENSION}`) checkEncoder();
}

export async function openFrameSink(flags: RenderFlags, scene: Scene): Promise<FrameSink> {
  const open = sinkOf(flags.output);
  if (!open) throw new Error(`nothing writes ${flags.output}`);
  return open(flags, scene);
}

/** One file per frame; `####` in the name is the frame's number. */
function fileSink(output: string, encode: (frame: PictureFrame) => Uint8Array): FrameSink {
  const files: string[] = [];
  return {
    files,
    add: async (frame) => {
      const file = frameName(output, frame.number ?? 0);
      writeFileAtomically(file, encode(frame));
      files.push(file);
    },
    finish: async () => {},
    discard: () => {},
  };
}

/** Appends each frame to the film as soon as it is drawn. */
function gifSink({ output, size }: RenderFlags, fps: number): FrameSink {
  const problem = gifProblem(size, fps);
  if (problem) throw usageError(msg`${output}: ${problem}`);
  const film = new OutputFile(output);
  const encoder = new GifEncoder(size, fps);
  const files: string[] = [];
  return {
    files,
    add: async ({ rendered }) => film.append(encoder.add(rendered.pixels)),
    finish: async () => {
      film.append(encoder.finish());
      film.commit();
      files.push(output);
    },
    discard: () => film.discard(),
  };
}

async function videoSink({ output, size }: RenderFlags, fps: number): Promise<FrameSink> {
  if (size.width % 2 || size.height % 2) {
    throw usageError(msg`--size ${size.width}x${size.height}: an .mp4 needs an even width and height`);
  }
  const video = await VideoWriter.open(output, size, fps);
  const files: string[] = [];
  let spherical: SphericalPicture | undefined;
  return {
    files,
    add: ({ rendered, views }) => {
      spherical ??= sphericalFileOf(views, size);
      return video.add(rendered.pixels);
    },
    finish: async () => {
      await video.finish(spherical);
      files.push(output);
    },
    discard: () => video.discard(),
  };
}
