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
  /** The observer's greatest speed, as a fraction of c. */
  readonly maxSpeed: number;
  readonly lightDelay: boolean;
  readonly aberration: boolean;
  readonly solver: Solver;
  readonly iterations: number;
  readonly damping: number;
  readonly view: View;
}

/** A scene with where it is looked at from. */
export interface CameraView extends RelativisticScene {
  /** Prim path; empty: the scene's first camera. */
  readonly camera: string;
  /** The observer rides on the file's camera, with its velocity, instead of flying freely. */
  readonly ride: boolean;
  /** Vertical field of view [rad]; undefined: the camera's own. */
  readonly fovY: number | undefined;
}

/** What the rasterizer is to draw. A description: the pass itself runs once a frame. */
export interface GBufferSpec extends CameraView {
  readonly colors: ColorMode;
  readonly dopplerMix: number;
  readonly beaming: number;
  readonly antialiasing: boolean;
  readonly grid: boolean;
}

/** An image, by the step that makes it of others; nothing is drawn before the whole picture is known. */
export interface ImageSpec {
  readonly step: FrameGraphPassOf<ImageSpec, GBufferSpec>;
  /** The G-buffer that the picture is of, first of all: whose camera, time and speed of light hold for it. */
  readonly gbuffer: GBufferSpec;
}

/** A whole picture, but for the time and the observer, which change by themselves. */
export interface PictureSpec extends GBufferSpec {
  readonly shadows: boolean;
  /** What hides the sky of a place dims its light. */
  readonly occlusion: boolean;
  readonly tone: ToneMapping;
  readonly metering: MeteringMode;
  /** What is added to the metered exposure [EV]. */
  readonly exposure: number;
  readonly falseColor: FalseColorQuantity | 'none';
  /** Where it is more than one G-buffer, shaded: how it is put together. */
  readonly frameGraph?: FrameGraph;
  /** What it was planned of. */
  readonly image: ImageSpec;
  /** What the plan's other G-buffers are of, with that of the first. */
  readonly scenes: readonly Scene[];
}

/** From when to when a scene's animation is shown [s]. */
export interface TimeRange {
  readonly start: number;
  readonly end: number;
  /** World time that it opens at; absent: its start. */
  readonly openAt?: number;
}

/** What flows through a socket of each type. */
interface SocketValues {
  /** Things, lamps and cameras that are to be part of a scene. */
  readonly geometry: LoadedScene;
  readonly motion: MotionPath;
  /** What is to be simulated. */
  readonly matter: Matter;
  /** What a simulation did. */
  readonly books: RunRecord;
  readonly lights: readonly Light[];
  /** The observer's velocity at the start, in units of c. */
  readonly observer: Vec3;
  readonly time: TimeRange;
  readonly spectrum: LightSpectrum;
  readonly scene: LoadedScene;
  readonly relativity: RelativisticScene;
  readonly view: CameraView;
  readonly gbuffer: GBufferSpec;
  readonly image: ImageSpec;
  /** An image whose first channel counts. */
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
 * A node whose code is typed by its own description. The engine connects only sockets of one type and the document's
 * values are checked against the description, so the erased types are what the code was promised.
 */
export function defineNode<const P extends Params, const I extends SocketTable, const O extends SocketTable>(
  definition: NodeDefinition<P, I, O>,
): NodeType<Services> & NodeDefinition<P, I, O> {
  return definition as unknown as NodeType<Services> & NodeDefinition<P, I, O>;
}
