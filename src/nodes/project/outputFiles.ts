import type { FlightRecording } from '../../flight/recording/recording.ts';
import type { FrameSpacing } from '../../flight/spacing.ts';
import { dotted, extensionOf } from '../../formats/files/fileSource.ts';
import { msg } from '../../messages/message.ts';
import type { Scene } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';
import type { PictureSpec } from '../socketValues.ts';

/** Description of a file that a project requests. Whoever evaluates the project writes or downloads it. */
export type RequestedFile = SceneOutput | ImageOutput | VideoOutput;

export interface SceneOutput {
  readonly kind: 'scene';
  /** Without folders; the extension determines the format. */
  readonly name: string;
  readonly scene: Scene;
  /** Whether motions that USD cannot express are sampled over the scene’s time. */
  readonly sampled: boolean;
  /** `name` is then a new root layer of an existing stage, and the scene a layer that it names. */
  readonly stage?: { readonly text: string; readonly geometryFile: string };
}

/** Pictures to render, with the observer that the project describes. */
interface PictureOutput {
  /** Without folders; the extension determines the format. */
  readonly name: string;
  readonly picture: PictureSpec;
  /** [px] */
  readonly width: number;
  readonly height: number;
  /** n × n samples per pixel, if the picture is antialiased. */
  readonly samples: number;
}

export interface ImageOutput extends PictureOutput {
  readonly kind: 'image';
  /** World time of the observer's event [s]. */
  readonly time: number;
}

/** A film, or one file per frame if the name contains `####` for the frame number. */
export interface VideoOutput extends PictureOutput {
  readonly kind: 'video';
  /** World times of the first frame and of the end, which is included if a frame falls on it [s]. */
  readonly from: number;
  readonly to: number;
  /** Frames per second. */
  readonly fps: number;
  /** Whose clock `from`, `to` and `fps` are of, unless a flight is filmed. */
  readonly spacing: FrameSpacing;
  /** Whether the observer stays in place despite a velocity. */
  readonly stayInPlace: boolean;
  /** What is filmed instead of the project's observer: `from` and `to` are then of the clock that `spacing` names, from its beginning. */
  readonly flight?: FlightRecording;
}

/** A frame's number, if there are several, and its world time [s]. */
export interface FrameTime {
  readonly number?: number;
  readonly t: number;
}

/** Number of frames, including both ends; a frame that is missed by rounding alone is counted. */
export const frameCount = ({ from, to, fps }: Pick<VideoOutput, 'from' | 'to' | 'fps'>): number =>
  Math.floor((to - from) * fps + 1e-6) + 1;

/** Frame numbers and times. If a film starts at a whole frame, frame n is at n/fps. */
export function frameTimes(file: ImageOutput | VideoOutput): readonly FrameTime[] {
  if (file.kind === 'image') return [{ t: file.time }];
  const { from, fps } = file;
  const first = Math.round(from * fps);
  const isWhole = Math.abs(from * fps - first) < 1e-6;
  const time = (i: number): number => (isWhole ? (first + i) / fps : from + i / fps);
  return Array.from({ length: frameCount(file) }, (_, i) => ({ number: first + i, t: time(i) }));
}

/** Characters that file systems do not allow. */
const FORBIDDEN_CHARACTERS = /[\p{Cc}/\\:*?"<>|]/gu;
const MAX_NAME_LENGTH = 200;

/** Validates a file name: projects may come from strangers and must not choose where on the disk they write. */
export function checkedFileName(name: string, extensions: readonly string[], node: string): string {
  const plain =
    name ===
    name
      .replace(FORBIDDEN_CHARACTERS, '_')
      .replace(/^[.\s]+/u, '')
      .slice(0, MAX_NAME_LENGTH);
  if (plain && extensions.includes(extensionOf(name))) return name;
  const bare = name
    .replace(/^.*[/\\]/u, '')
    .replace(FORBIDDEN_CHARACTERS, '_')
    .replace(/^[.\s]+/u, '')
    .replace(/\.[^.]*$/u, '');
  const value = `${bare.slice(0, MAX_NAME_LENGTH / 2) || 'file'}.${extensions[0]}`;
  const message = msg`"${name.slice(0, 80)}" is no name of a file without folders that ends in ${dotted(extensions)}; write one like ${value}`;
  throw nodeRefusal('file.name', `${node}.name`, message, { node, param: 'name', value });
}
