import { extname } from 'node:path';
import { exrPicture, frameName, pngPicture } from '../nodes/drawing/encode.ts';
import type { Frame } from '../nodes/drawing/sequence.ts';
import type { Scene } from '../scene/types.ts';
import { usageError } from './exit.ts';
import { checkWritable, writeWhole } from './output.ts';
import type { RenderFlags } from './render.ts';
import { VideoWriter } from './video.ts';

/** Where finished frames go. */
export interface Sink {
  /** What has been written. */
  readonly files: readonly string[];
  add(frame: Frame): Promise<void>;
  finish(): Promise<void>;
  /** Removes what is not finished; after `finish` nothing is. */
  discard(): void;
}

export async function openSink(flags: RenderFlags, scene: Scene, frames: number): Promise<Sink> {
  const { output, size } = flags;
  switch (extname(output).toLowerCase()) {
    case '.png':
      return fileSink(output, frames, (frame) => pngPicture(size, frame.painted, frame));
    case '.exr':
      return fileSink(output, frames, (frame) => exrPicture(size, frame.painted, frame, scene));
    case '.mp4':
      return videoSink(flags, flags.fps ?? scene.timeCodesPerSecond);
    default:
      throw usageError(`--output ${output}: its name must end in .png, .exr or .mp4`);
  }
}

/** One file per frame; `####` in the name is the frame's number. */
function fileSink(output: string, frames: number, encode: (frame: Frame) => Uint8Array): Sink {
  if (frames > 1 && !/#/.test(output)) {
    const pattern = output.replace(/(\.\w+)$/, '.####$1');
    throw usageError(`--output ${output}: several frames need a place for their number, like ${pattern}`);
  }
  checkWritable(output);
  const files: string[] = [];
  return {
    files,
    add: async (frame) => {
      const file = frameName(output, frame.number ?? 0);
      writeWhole(file, encode(frame));
      files.push(file);
    },
    finish: async () => {},
    discard: () => {},
  };
}

async function videoSink({ output, size }: RenderFlags, fps: number): Promise<Sink> {
  if (size.width % 2 || size.height % 2) {
    throw usageError(`--size ${size.width}x${size.height}: an .mp4 needs an even width and height`);
  }
  const video = await VideoWriter.open(output, size, fps);
  const files: string[] = [];
  return {
    files,
    add: ({ painted }) => video.add(painted.pixels),
    finish: async () => {
      await video.finish();
      files.push(output);
    },
    discard: () => video.discard(),
  };
}
