import { extensionOf } from '../../formats/files/fileSource.ts';
import type { Scene } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';
import type { PictureSpec } from '../socketValues.ts';

/** A file that a project asks for: a description. Who evaluates the project writes it, or offers it. */
export type RequestedFile = SceneOutput | ImageOutput | VideoOutput;

export interface SceneOutput {
  readonly kind: 'scene';
  /** Without folders; its extension tells what it is. */
  readonly name: string;
  readonly scene: Scene;
  /** Motions that only this program knows are sampled over the scene’s time, for others to see. */
  readonly sampled: boolean;
}

/** Pictures that are to be drawn, seen by the observer that the project describes. */
interface PictureOutput {
  /** Without folders; its extension tells what it is. */
  readonly name: string;
  readonly picture: PictureSpec;
  /** [px] */
  readonly width: number;
  readonly height: number;
  /** n × n samples per pixel, where the picture is antialiased. */
  readonly samples: number;
}

export interface ImageOutput extends PictureOutput {
  readonly kind: 'image';
  /** World time of the observer's event [s]. */
  readonly time: number;
}

/** A film, or a file for each of its frames where `####` in the name takes their numbers. */
export interface VideoOutput extends PictureOutput {
  readonly kind: 'video';
  /** World times of the first frame and of the last, if one falls there [s]. */
  readonly from: number;
  readonly to: number;
  /** Frames per second. */
  readonly fps: number;
  /** The observer stays in place although there is a velocity. */
  readonly hold: boolean;
}

/** A frame's number, where there are several, and its world time [s]. */
export interface FrameTime {
  readonly number?: number;
  readonly t: number;
}

/** How many frames a film has: both ends count. A frame that is missed by rounding alone is there. */
export const frameCount = ({ from, to, fps }: Pick<VideoOutput, 'from' | 'to' | 'fps'>): number =>
  Math.floor((to - from) * fps + 1e-6) + 1;

/** The frames of what is to be drawn. Frame n is at n/fps, wherever a film begins at a whole number of frames. */
export function frameTimes(file: ImageOutput | VideoOutput): readonly FrameTime[] {
  if (file.kind === 'image') return [{ t: file.time }];
  const { from, fps } = file;
  const first = Math.round(from * fps);
  const isWhole = Math.abs(from * fps - first) < 1e-6;
  const time = (i: number): number => (isWhole ? (first + i) / fps : from + i / fps);
  return Array.from({ length: frameCount(file) }, (_, i) => ({ number: first + i, t: time(i) }));
}

/** What no system has in the name of a file. */
const FORBIDDEN_CHARACTERS = /[\p{Cc}/\\:*?"<>|]/gu;
const MAX_NAME_LENGTH = 200;

/** A name as a project may give it: a project can be a stranger’s, and is not to choose where on a disk it writes. */
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
  const known = extensions.map((each) => `.${each}`).join(', ');
  const message = `"${name.slice(0, 80)}" is no name of a file without folders that ends in ${known}; write one like ${value}`;
  throw nodeRefusal('file.name', `${node}.name`, message, { node, param: 'name', value });
}
