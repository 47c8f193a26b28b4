import type { Message } from '../messages/message.ts';
import { MessageError } from '../messages/messageError.ts';
import type { Backend, RendererOptions } from '../render/settings.ts';
import type { Scene } from '../scene/types.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';
import type { AovName, RenderSettings } from '../scene/view/view.ts';
import type { SeenDome } from './films/filmReader.ts';
import type { PipelineHost, ThreadPort } from './host.ts';
import type { InteractiveRenderer } from './interactiveRenderer.ts';
import type { OptionValues, OptionValuesOf, PipelineOptions } from './options.ts';
import type { PictureRenderer } from './pictureRenderer.ts';

/** The scene of a picture, and those of its frame graph's extra G-buffers. */
export type PictureScenes = readonly [Scene, ...Scene[]];

/** The scenes, size and options of the pictures of a session. */
export interface SessionRequest<Options> {
  readonly scenes: PictureScenes;
  readonly size: PictureSize;
  /** Speed of light of the first picture [m/s], for which slow preparations begin at once. */
  readonly speedOfLight: number;
  readonly options: Options;
}

/** How a session shows what is seen of a film. */
export interface ShowDome {
  /** Whether it needs the maps of `SeenDome`. */
  readonly needsMaps: boolean;
  /** `scene`: its index among those of the session. */
  show(scene: number, seen: SeenDome): Promise<void> | void;
}

/** An open pipeline. */
export interface PipelineSession extends PictureRenderer {
  /** Pipeline, device and the like, for `--json`. */
  readonly info: { readonly pipeline: string } & Readonly<Record<string, string | number>>;
  /** Shows another picture of a scene's dome: what is seen of its film. Absent: films stand still. */
  readonly showDome?: ShowDome;
  /** Rejects the current picture with this error at once. Absent: a session can only end between pictures. */
  stop?(error: Error): void;
  close(): Promise<void>;
}

/** A way to draw pictures, with its requirements, abilities and options. docs/adr/0025-pipelines.md */
export interface Pipeline<Options extends PipelineOptions = PipelineOptions> {
  /** Used in `--pipeline`, reports, and messages to threads. */
  readonly id: string;
  /** Used in sentences: "is for the rasterizer". */
  readonly name: Message;
  /** Follows its id in the help of `--pipeline`. */
  readonly summary: Message;
  /** GPU backends that it supports, the preferred first; empty if it needs no GPU. */
  readonly backends: readonly Backend[];
  /** Whether it uses worker threads. */
  readonly usesThreads: boolean;
  /** Its drawbacks and merits, if `--pipeline auto` falls back on it when another cannot be opened. Absent: used only if named, or first in the list. */
  readonly fallback?: Message;
  /** Why it rejects flags of others, after `--pipeline ID`. */
  readonly constraint?: Message;
  /** Picture settings of which it supports one value only. */
  readonly fixedSettings: Partial<RenderSettings>;
  readonly options: Options;
  /** AOVs that it can draw. */
  readonly aovs: readonly AovName[];
  /** Default of n, for n × n samples per pixel; `note`: what it does with them. */
  readonly samples: { readonly default: number; readonly note?: Message };
  /** Most views of one picture; Infinity: no limit. */
  readonly maxViews: number;
  /** Its node that renders stills. Absent: there is none. */
  readonly still?: StillLimits;
  /**
   * Opens it to draw on a canvas or into memory, frame by frame. Absent: it is too slow for that. Without `open`, single pictures are drawn with it too
   * (interactiveSession.ts).
   */
  openInteractive?(options: RendererOptions): Promise<InteractiveRenderer>;
  /** Opens it to draw single pictures, which may take long. */
  open?(request: SessionRequest<OptionValuesOf<Options>>, host: PipelineHost): Promise<PipelineSession>;
  /** Runs in its worker threads, if it `usesThreads`. */
  serveThread?(port: ThreadPort): Promise<void>;
}

/** The node that renders stills, and its limits, which keep its work within minutes. */
export interface StillLimits {
  /** Id of the node type. */
  readonly node: string;
  readonly title: Message;
  readonly help: Message;
  readonly maxPixels: number;
  /** Limit of pixels × samples. */
  readonly maxPaths: number;
  readonly maxSamples: number;
}

/** Infers the types of a pipeline's options. */
export const definePipeline = <const Options extends PipelineOptions>(pipeline: Pipeline<Options>): Pipeline<Options> =>
  pipeline;

/** A request whose options are not checked against the pipeline's. */
export type UncheckedRequest = SessionRequest<OptionValues>;

/** Thrown if a pipeline cannot draw a request, with a message for users. */
export class PipelineRefusal extends MessageError {}
