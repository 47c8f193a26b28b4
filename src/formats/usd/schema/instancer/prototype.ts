import type { PrimSpec } from '../../layer/layer.ts';
import type { PrimGeometry } from '../geometry/primGeometry.ts';
import type { MeshLight } from '../lights/meshLights.ts';
import type { SlowlightAttributes } from '../slowlightAttributes.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';

/** A gprim without placement. */
export interface UnplacedGprim {
  readonly path: string;
  readonly geometry: PrimGeometry;
  readonly transform: StageTransform;
  readonly slowlight: SlowlightAttributes;
  /** The material, by its place in the scene's, that an instance's own displayColor changes. */
  readonly displayColorMaterial: number | undefined;
  /** Absent where it does not shine. */
  readonly light?: MeshLight;
}

/** An instancer, and where it is. */
export interface PlacedInstancer {
  readonly prim: PrimSpec;
  readonly transform: StageTransform;
  readonly slowlight: SlowlightAttributes;
}

/** What is at a prim and below it. */
export interface Prototype {
  /** Of the prim that the paths of what is in it begin with: the parent of its root. */
  readonly parentPath: string;
  readonly gprims: readonly UnplacedGprim[];
  readonly instancers: readonly PlacedInstancer[];
}
