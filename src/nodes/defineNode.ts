import type { RunRecord } from '../dynamics/runRecord.ts';
import type { EvaluationContext, NodeType, ParamSpec, ParamValueOf, Socket } from '../graph/nodeType.ts';
import type { Vec3 } from '../math/vec3.ts';
import type { MotionPath } from '../scene/compose/motionPaths.ts';
import type { FrameGraph, FrameGraphPassOf } from '../scene/frameGraph/frameGraph.ts';
import type { Light, Scene } from '../scene/types.ts';
import type { ColorMode, Solver, View } from '../scene/view/view.ts';
import type { ToneMapping } from '../spectrum/display/toneMap.ts';
import type { FalseColorQuantity } from '../spectrum/falseColor/falseColor.ts';
import type { LightSpectrum } from '../spectrum/sources/lightSpectrum.ts';
import type { Matter } from './dynamics/matter.ts';
import type { MeteringMode } from './pictures/metering.ts';
import type { RequestedFile } from './project/outputFiles.ts';
import type { LoadedScene, Services } from './services.ts';

/** A scene with how light travels in it. */
export interface RelativisticScene extends LoadedScene {
  /** [m/s] */
  readonly speedOfLight: number;
  /** The observer's maximum speed as a fraction of c. */
  readonly maxSpeed: number;
  readonly lightDelay: boolean;
  readonly aberration: boolean;
  readonly solver: Solver;
  readonly iterations: number;
  readonly damping: number;
  readonly view: View;
}

/** A relativistic scene with the camera that observes it. */
export interface CameraView extends RelativisticScene {
  /** Prim path; empty: the scene's first camera. */
  readonly camera: string;
  /** Whether the observer rides on the file's camera with its velocity instead of flying freely. */
  readonly ride: boolean;
  /** Vertical field of view [rad]; undefined: the camera's. */
  readonly fovY: number | undefined;
}

/** What the rasterizer is to draw. A description only: the pass runs once per frame. */
export interface GBufferSpec extends CameraView {
  readonly colors: ColorMode;
  readonly dopplerMix: number;
  readonly beaming: number;
  readonly antialiasing: boolean;
  readonly grid: boolean;
}

/** An image, described by the pass that makes it from others; nothing is rendered before the whole picture is known. */
export interface ImageSpec {
  readonly step: FrameGraphPassOf<ImageSpec, GBufferSpec>;
  /** The primary G-buffer, whose camera, time and speed of light apply to the image. */
  readonly gbuffer: GBufferSpec;
}

/** A whole picture, except for time and observer, which change without an evaluation. */
export interface PictureSpec extends GBufferSpec {
  readonly shadows: boolean;
  /** Whether ambient occlusion dims the light of the sky. */
  readonly occlusion: boolean;
  readonly tone: ToneMapping;
  readonly metering: MeteringMode;
  /** Exposure compensation, added to the metered exposure [EV]. */
  readonly exposure: number;
  readonly falseColor: FalseColorQuantity | 'none';
  /** Present if the picture is more than one shaded G-buffer. */
  readonly frameGraph?: FrameGraph;
  /** The final image. */
  readonly image: ImageSpec;
  /** Scenes of all G-buffers; the primary one's first. */
  readonly scenes: readonly Scene[];
}

/** Time range in which a scene's animation is shown [s]. */
export interface TimeRange {
  readonly start: number;
  readonly end: number;
  /** Initial world time [s]; absent: the start. */
  readonly openAt?: number;
}

/** Type of value of each socket type. */
interface SocketValues {
  /** Objects, lights and cameras to be part of a scene. */
  readonly geometry: LoadedScene;
  readonly motion: MotionPath;
  /** Description of what is to be simulated. */
  readonly matter: Matter;
  /** Run record of a simulation. */
  readonly books: RunRecord;
  readonly lights: readonly Light[];
  /** The observer's initial velocity [c]. */
  readonly observer: Vec3;
  readonly time: TimeRange;
  readonly spectrum: LightSpectrum;
  readonly scene: LoadedScene;
  readonly relativity: RelativisticScene;
  readonly view: CameraView;
  readonly gbuffer: GBufferSpec;
  readonly image: ImageSpec;
  /** An image whose first channel is used. */
  readonly mask: ImageSpec;
  readonly picture: PictureSpec;
  readonly number: number;
  readonly vector: Vec3;
  /** Linear sRGB. */
  readonly color: Vec3;
  readonly text: string;
  readonly file: RequestedFile;
  readonly any: unknown;
}
type SocketType = keyof SocketValues;
type SocketTable = Readonly<Record<string, Socket<SocketType>>>;
type ValueOf<S extends Socket<SocketType>> = S extends { readonly many: true }
  ? readonly SocketValues[S['type']][]
  : S extends { readonly optional: true }
    ? SocketValues[S['type']] | undefined
    : SocketValues[S['type']];
type ValuesOf<S extends SocketTable> = { readonly [K in keyof S]: ValueOf<S[K]> };
type Params = Readonly<Record<string, ParamSpec>>;
type ParamsOf<P extends Params> = { readonly [K in keyof P]: ParamValueOf<P[K]> };

export interface NodeDefinition<P extends Params, I extends SocketTable, O extends SocketTable>
  extends Omit<NodeType<Services>, 'params' | 'inputs' | 'outputs' | 'evaluate'> {
  readonly params: P;
  readonly inputs: I;
  readonly outputs: O;
  evaluate(
    inputs: ValuesOf<I>,
    params: ParamsOf<P>,
    work: EvaluationContext<Services> & { readonly node: string },
  ): ValuesOf<O> | Promise<ValuesOf<O>>;
}

/**
 * Defines a node whose code is typed by its own description. The engine connects only sockets of equal types, and the
 * document's values are validated against the description, so the erased types hold.
 */
export function defineNode<const P extends Params, const I extends SocketTable, const O extends SocketTable>(
  definition: NodeDefinition<P, I, O>,
): NodeType<Services> & NodeDefinition<P, I, O> {
  return definition as unknown as NodeType<Services> & NodeDefinition<P, I, O>;
}
