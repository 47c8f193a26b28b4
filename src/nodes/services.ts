import { type ComputeGpu, openWebGpu } from '../compute/computeDevice.ts';
import type { TeamThreads } from '../dynamics/threads/threadTeam.ts';
import type { ReadFont } from '../formats/font/glyphs.ts';
import type { ReadOptions } from '../formats/readOptions.ts';
import type { AbortSignalLike, ProgressCallback } from '../graph/nodeType.ts';
import { msg } from '../messages/message.ts';
import { MessageError } from '../messages/messageError.ts';
import type { FastestInScene } from '../scene/motion/fastestInScene.ts';
import type { Scene } from '../scene/types.ts';
import type { RenderStill } from './still.ts';

/**
 * A scene as read, with values that are costly to compute; these are computed where the file is read, off the main
 * thread.
 */
export interface LoadedScene {
  /** As read. */
  readonly scene: Scene;
  /** The fastest point; undefined if nothing moves. */
  readonly fastest?: FastestScenePoint;
}

/** The fastest vertex of a scene and its object. */
export type FastestScenePoint = FastestInScene;

/** What a node asks of a reader. */
export type SceneReadOptions = Pick<ReadOptions, 'variants' | 'interpolation' | 'prim' | 'fisheye'>;

/** Options for reading a scene. */
export interface ReadRequest extends SceneReadOptions {
  /** Cancels the reading. */
  readonly signal?: AbortSignalLike;
  /** Told how far the reading is. */
  readonly progress: ProgressCallback;
}

/** Services of the host: the page reads in a worker, the command line directly. */
export interface Services {
  /** Throws an `InputError` if the file cannot be read. */
  readScene(source: string, how: ReadRequest): Promise<LoadedScene>;
  /** Reads a font file that comes with the program; throws an `InputError` if it cannot. */
  readonly readFont: ReadFont;
  /** Reads a small file, such as a table; throws an `InputError` if it does not exist. */
  readFile(source: string): Promise<Uint8Array>;
  /** Renders stills with a pipeline. */
  readonly renderStill: RenderStill;
  /** Opens a GPU for computing; throws a `SystemError` if there is none. */
  readonly openGpu: () => Promise<ComputeGpu>;
  /** Threads for simulations; absent where memory cannot be shared. */
  readonly teamThreads?: TeamThreads;
}

/** Heavy-node threads read nothing and start no threads; their inputs come with the request. */
const rejectReading = () =>
  Promise.reject(new MessageError(msg`a heavy node reads no files; give it what it needs as inputs`));
export const workerServices: Services = {
  readScene: rejectReading,
  readFont: rejectReading,
  readFile: rejectReading,
  renderStill: () => Promise.reject(new MessageError(msg`a heavy node has no threads of its own`)),
  openGpu: openWebGpu,
};
