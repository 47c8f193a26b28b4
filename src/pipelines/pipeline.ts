import type { Backend, RendererOptions } from '../render/settings.ts';
import type { Scene } from '../scene/types.ts';
import type { PictureSize } from '../scene/view/pictureViews.ts';
import type { AovName, RenderSettings } from '../scene/view/view.ts';
import type { PipelineHost, ThreadPort } from './host.ts';
import type { InteractiveRenderer } from './interactiveRenderer.ts';
import type { OptionValues, OptionValuesOf, PipelineOptions } from './options.ts';
import type { PictureRenderer } from './pictureRenderer.ts';

/** A picture's scene, and those of its frame graph's other G-buffers. */
export type PictureScenes = readonly [Scene, ...Scene[]];

/** What pictures are going to be drawn. */
export interface SessionRequest<Options> {
  readonly scenes: PictureScenes;
  readonly size: PictureSize;
  /** Of the first picture [m/s]: what takes a while is prepared for it. */
  readonly speedOfLight: number;
  readonly options: Options;
}

/** A pipeline at work on one request. */
export interface PipelineSession extends PictureRenderer {
  /** What draws, for `--json`. */
  readonly info: { readonly pipeline: string } & Readonly<Record<string, string | number>>;
  /** Ends what is being drawn with this error, at once. Absent: it ends between pictures only. */
  stop?(error: Error): void;
  close(): Promise<void>;
}

/** What draws pictures: declares what it needs, what it gives and what it obeys. docs/adr/0025-pipelines.md */
export interface Pipeline<Options extends PipelineOptions = PipelineOptions> {
  /** In `--pipeline`, in reports, and in messages to threads. */
  readonly id: string;
  /** In sentences: "is for the rasterizer". */
  readonly name: string;
  /** What it does, after its id in `--pipeline`'s help. */
  readonly summary: string;
  /** GPU interfaces that it can draw with, the preferred first; none: it needs no GPU. */
  readonly backends: readonly Backend[];
  /** It draws with as many threads as it is given. */
  readonly usesThreads: boolean;
  /** Where it stands in for another that cannot be opened (`--pipeline auto`): what to expect of it. Absent: it only draws where it is named, or comes first. */
  readonly fallback?: string;
  /** Why flags of others are refused, after `--pipeline ID`. */
  readonly constraint?: string;
  /** Settings of pictures of which it has one value only. */
  readonly fixedSettings: Partial<RenderSettings>;
  readonly options: Options;
  /** Data that it gives beside a picture. */
  readonly aovs: readonly AovName[];
  /** n × n per pixel where nobody says; `note`: what it does with them. */
  readonly samples: { readonly default: number; readonly note?: string };
  /** How many views it draws into one picture, as the two of a stereo pair; Infinity: as many as one likes. */
  readonly maxViews: number;
  /** The node that puts a still picture by it into an image. Absent: there is none. */
  readonly still?: StillLimits;
  /**
   * Opens it to draw on a canvas or into memory, frame by frame. Absent: a picture takes longer than a frame may.
   * With it and without `open`, single pictures are drawn frame by frame too (interactiveSession.ts).
   */
  openInteractive?(options: RendererOptions): Promise<InteractiveRenderer>;
  /** Opens it to draw pictures, each for as long as it takes. */
  open?(request: SessionRequest<OptionValuesOf<Options>>, host: PipelineHost): Promise<PipelineSession>;
  /** What a thread of its own does, where it `usesThreads`. */
  serveThread?(port: ThreadPort): Promise<void>;
}

/** Of the node for stills. Above the limits it refuses: minutes, not hours. */
export interface StillLimits {
  /** Id of the node type, and keys of the catalogue of messages. */
  readonly node: string;
  readonly title: string;
  readonly help: string;
  readonly maxPixels: number;
  /** Samples of all pixels together. */
  readonly maxPaths: number;
  readonly maxSamples: number;
}

/** A pipeline whose code is typed by its own options. */
export const definePipeline = <const Options extends PipelineOptions>(pipeline: Pipeline<Options>): Pipeline<Options> =>
  pipeline;

/** A request as somebody makes it who does not know the pipeline's options. */
export type UncheckedRequest = SessionRequest<OptionValues>;

/** What a pipeline cannot draw, in words for people. */
export class PipelineRefusal extends Error {}
