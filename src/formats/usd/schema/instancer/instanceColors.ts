import type { Vec3 } from '../../../../math/vec3.ts';
import { msg } from '../../../../messages/message.ts';
import { report } from '../../diagnostics.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import { primvarOf } from '../primvars.ts';
import type { PointInstance, PointInstances } from './pointInstances.ts';

/** The displayColor of an instance by its instancer; undefined if it has none. */
export type InstanceColor = (instance: PointInstance) => Vec3 | undefined;

const DISPLAY_COLOR = 'primvars:displayColor';

/** The values at the stage's start, by each instance's first array index: `constant` is one for all, every other interpolation one per instance. */
export function instanceColors(context: StageContext, prim: PrimSpec, { instances }: PointInstances): InstanceColor {
  const primvar = primvarOf(prim, DISPLAY_COLOR, context.startCode);
  if (!primvar) return () => undefined;
  const { interpolation, values, indices } = primvar;
  const count = interpolation === 'constant' ? 1 : (instances[0]?.indexRuns[0].count ?? 0);
  const place = (i: number): number => 3 * (indices ? indices[i] : i);
  const fits = Array.from({ length: count }, (_, i) => place(i)).every((at) => at >= 0 && at + 3 <= values.length);
  if (!fits) {
    const has = indices?.length ?? values.length / 3;
    report(
      context,
      'warning',
      'usd.primvar',
      prim.path,
      msg`${DISPLAY_COLOR} has ${has} values for ${count} instances; it is left out`,
    );
    return () => undefined;
  }
  return ({ indexRuns: [{ index }] }) => {
    const at = place(interpolation === 'constant' ? 0 : index);
    return at + 3 <= values.length ? [values[at], values[at + 1], values[at + 2]] : undefined;
  };
}
