import type { Light, Scene } from '../../../scene/types.ts';
import type { TracedLight } from '../lightingContext.ts';

/** What the reference renderer knows of a kind of light (docs/adr/0024-light-kinds.md). */
export interface LightTracer<L extends Light> {
  /** Made once per scene: all that does not depend on the ray is computed here. */
  trace(light: L, scene: Scene): TracedLight;
}
