import { type ComputeGpu, openWebGpu } from '../compute/computeDevice.ts';
import type { ReadFont } from '../formats/font/glyphs.ts';
import type { ReadOptions } from '../formats/registry.ts';
import type { AbortSignalLike, ProgressCallback } from '../graph/nodeType.ts';
import type { FastestInScene } from '../scene/motion/fastestInScene.ts';
import type { Scene } from '../scene/types.ts';
import type { RenderStill } from './still.ts';

/** A scene as read, with what the checks need that is dear to compute: done where the file is read, off the main thread. */
export interface LoadedScene {
  readonly scene: Scene;
  /** The fastest point of all; undefined where nothing moves. */
  readonly fastest?: FastestScenePoint;
}

export type FastestScenePoint = FastestInScene;

/** How a scene is to be read. */
export interface ReadRequest extends Pick<ReadOptions, 'variants' | 'interpolation'> {
  readonly signal?: AbortSignalLike;
  readonly progress: ProgressCallback;
}

/** What the nodes need from where they run: a page reads in a worker, a command line reads directly. */
export interface Services {
  /** Throws an `InputError` where the file cannot be read. */
  readScene(source: string, how: ReadRequest): Promise<LoadedScene>;
  /** Reads a file of a font that comes with the program; throws an `InputError` where it cannot. */
  readonly readFont: ReadFont;
  /** A small file whole, a table; throws an `InputError` where it is not there. */
  readFile(source: string): Promise<Uint8Array>;
  /** Pictures by a pipeline, of nodes that have them drawn once. */
  readonly renderStill: RenderStill;
  /** A GPU that nobody else computes on; throws a `SystemError` where there is none. */
  readonly openGpu: () => Promise<ComputeGpu>;
}

/** In the threads of heavy nodes nothing is read, and no others are started: what they work on comes with their orders. */
const rejectReading = () => Promise.reject(new Error('a heavy node reads no files; give it what it needs as inputs'));
export const workerServices: Services = {
  readScene: rejectReading,
  readFont: rejectReading,
  readFile: rejectReading,
  renderStill: () => Promise.reject(new Error('a heavy node has no threads of its own')),
  openGpu: openWebGpu,
};
