import { extname } from 'node:path';
import { encodePng } from '../formats/png.ts';
import { withPngText } from '../formats/pngText.ts';
import { aboutObserver, aboutPicture } from '../scene/about.ts';
import type { Scene } from '../scene/types.ts';
import type { RenderSettings, ViewPoint } from '../scene/view.ts';
import { usageError } from './exit.ts';
import { checkWritable, writeWhole } from './output.ts';
import type { Picture } from './painter.ts';
import { encodeExr } from './pictures.ts';
import type { RenderFlags } from './render.ts';
import { VideoWriter } from './video.ts';

/** What is known of a frame besides its pixels. */
export interface FrameNotes {
  readonly number?: number;
  readonly view: ViewPoint;
  /** With the exposure and the false colours that it was shown with. */
  readonly settings: RenderSettings;
}

/** Where finished frames go. */
export interface Sink {
  /** What has been written. */
  readonly files: readonly string[];
  add(picture: Picture, notes: FrameNotes): Promise<void>;
  finish(): Promise<void>;
  /** Removes what is not finished; after `finish` nothing is. */
  discard(): void;
}

export async function openSink(flags: RenderFlags, scene: Scene, frames: number): Promise<Sink> {
  const { output, size } = flags;
  switch (extname(output).toLowerCase()) {
    case '.png':
      return fileSink(output, frames, ({ pixels }, { view, settings }) =>
        withPngText(encodePng(size.width, size.height, pixels), aboutPicture(view, settings)),
      );
    case '.exr':
      return fileSink(output, frames, ({ aovs }, { view, settings }) =>
        encodeExr(size, aovs, scene, { scene: scene.name, ...aboutObserver(view, settings.speedOfLight) }),
      );
    case '.mp4':
      return videoSink(flags, flags.fps ?? scene.timeCodesPerSecond);
    default:
      throw usageError(`--output ${output}: its name must end in .png, .exr or .mp4`);
  }
}

/** One file per frame; `####` in the name is the frame's number. */
function fileSink(output: string, frames: number, encode: (picture: Picture, notes: FrameNotes) => Uint8Array): Sink {
  if (frames > 1 && !/#/.test(output)) {
    const pattern = output.replace(/(\.\w+)$/, '.####$1');
    throw usageError(`--output ${output}: several frames need a place for their number, like ${pattern}`);
  }
  checkWritable(output);
  const files: string[] = [];
  return {
    files,
    add: async (picture, notes) => {
      const file = frameName(output, notes.number ?? 0);
      writeWhole(file, encode(picture, notes));
      files.push(file);
    },
    finish: async () => {},
    discard: () => {},
  };
}

/** `a.####.png` and 7 → `a.0007.png` */
function frameName(pattern: string, frame: number): string {
  return pattern.replace(/#+/, (run) => (frame < 0 ? '-' : '') + String(Math.abs(frame)).padStart(run.length, '0'));
}

async function videoSink({ output, size }: RenderFlags, fps: number): Promise<Sink> {
  if (size.width % 2 || size.height % 2) {
    throw usageError(`--size ${size.width}x${size.height}: an .mp4 needs an even width and height`);
  }
  const video = await VideoWriter.open(output, size, fps);
  const files: string[] = [];
  return {
    files,
    add: ({ pixels }) => video.add(pixels),
    finish: async () => {
      await video.finish();
      files.push(output);
    },
    discard: () => video.discard(),
  };
}
