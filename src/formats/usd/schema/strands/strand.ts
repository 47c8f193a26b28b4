import type { SweptPoints } from '../../../read/strands/sweep.ts';
import type { TimeCode } from '../../layer/attributes.ts';

/** Points or curves as a surface whose shape is a function of time. */
export interface Strand {
  readonly faceCounts: ArrayLike<number>;
  readonly faceIndices: ArrayLike<number>;
  /** Points and normals of the surface at a time code. */
  at(time: TimeCode): SweptPoints;
  /** By point of the surface: a value of `size` numbers, of an attribute. */
  valuesOf(name: string, size: number): Float32Array | undefined;
  /** By point of the surface: the prim's point that it moves with; absent where there are several. */
  readonly pointOf?: Uint32Array;
  readonly doubleSided: boolean;
  /** Time codes between which it moves straight; absent: those of the prim's samples. */
  readonly times?: readonly number[] | undefined;
}

/** Width where none is written [stage units], as OpenUSD draws it. */
export const DEFAULT_WIDTH = 1;
