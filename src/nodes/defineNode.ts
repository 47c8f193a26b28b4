import type { RunRecord } from '../dynamics/runRecord.ts';
import type { EvaluationContext, NodeType, ParamSpec, ParamValueOf, Socket } from '../graph/nodeType.ts';
import type { Vec3 } from '../math/vec3.ts';
import type { MotionPath } from '../scene/compose/motionPaths.ts';
import type { Light } from '../scene/types.ts';
import type { LightSpectrum } from '../spectrum/sources/lightSpectrum.ts';
import type { Matter } from './dynamics/matter.ts';
import type { RequestedFile } from './project/outputFiles.ts';
import type { LoadedScene, Services } from './services.ts';
import type { CameraView, GBufferSpec, ImageSpec, PictureSpec, RelativisticScene, TimeRange } from './socketValues.ts';

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
export type SocketType = keyof SocketValues;
type SocketTable = Readonly<Record<string, Socket<SocketType>>>;
type ValueOf<S extends Socket<SocketType>> = S extends { readonly many: true }
  ? readonly SocketValues[S['type']][]
  : S extends { readonly optional: true }
    ? SocketValues[S['type']] | undefined
    : SocketValues[S['type']];
type SocketValuesOf<S extends SocketTable> = { readonly [K in keyof S]: ValueOf<S[K]> };
export type ParamTable = Readonly<Record<string, ParamSpec>>;
type ParamsOf<P extends ParamTable> = { readonly [K in keyof P]: ParamValueOf<P[K]> };

export interface NodeDefinition<P extends ParamTable, I extends SocketTable, O extends SocketTable>
  extends Omit<NodeType<Services>, 'params' | 'inputs' | 'outputs' | 'evaluate'> {
  readonly params: P;
  readonly inputs: I;
  readonly outputs: O;
  evaluate(
    inputs: SocketValuesOf<I>,
    params: ParamsOf<P>,
    work: EvaluationContext<Services> & { readonly node: string },
  ): SocketValuesOf<O> | Promise<SocketValuesOf<O>>;
}

/**
 * Defines a node whose code is typed by its own description. The engine connects only sockets of equal types, and the
 * document's values are validated against the description, so the erased types hold.
 */
export function defineNode<const P extends ParamTable, const I extends SocketTable, const O extends SocketTable>(
  definition: NodeDefinition<P, I, O>,
): NodeType<Services> & NodeDefinition<P, I, O> {
  return definition as unknown as NodeType<Services> & NodeDefinition<P, I, O>;
}
