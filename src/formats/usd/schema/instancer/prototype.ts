import type { Lifetime } from '../../../../scene/types.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { PrimGeometry } from '../geometry/primGeometry.ts';
import type { MeshLight } from '../lights/meshLights.ts';
import type { SlowlightAttributes } from '../slowlightAttributes.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';

/** A gprim before its placement in the scene. */
export interface UnplacedGprim {
  readonly path: string;
  readonly geometry: PrimGeometry;
  readonly transform: StageTransform;
  readonly slowlight: SlowlightAttributes;
  /** When it exists, apart from what `slowlight` says [s]. */
  readonly lives: readonly Lifetime[];
  /** Its number, if it is one of the pieces of a mesh whose topology changes. */
  readonly piece?: number;
  /** Index in `Scene.materials` of the material that an instance's displayColor replaces. */
  readonly displayColorMaterial: number | undefined;
  /** Absent if it is not a light. */
  readonly light?: MeshLight;
}

export interface PlacedInstancer {
  readonly prim: PrimSpec;
  readonly transform: StageTransform;
  readonly slowlight: SlowlightAttributes;
  /** When it exists, apart from what `slowlight` says [s]. */
  readonly lives: readonly Lifetime[];
}

/** The content of a prim's subtree. */
export interface Prototype {
  /** Path of the parent of its root, which the paths of its content begin with. */
  readonly parentPath: string;
  readonly gprims: readonly UnplacedGprim[];
  readonly instancers: readonly PlacedInstancer[];
}
