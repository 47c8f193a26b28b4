import type { Light, Scene } from '../../../scene/types.ts';
import type { TracedLight } from '../lightingContext.ts';

/** The reference renderer's functions for one kind of light (docs/adr/0024-light-kinds.md). */
export interface LightTracer<L extends Light> {
  /** Called once per scene; computes everything that does not depend on the ray. */
  trace(light: L, scene: Scene): TracedLight;
}
