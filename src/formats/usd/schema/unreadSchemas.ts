import { type Message, msg } from '../../../messages/message.ts';
import { report } from '../diagnostics.ts';
import type { PrimSpec } from '../layer/layer.ts';
import type { StageContext } from './context.ts';

/** Unsupported visible prim types, with the text of their diagnostic. */
const leftOutMessage = (type: string): Message => msg`${type} is not read; it is left out`;
const exportAsMeshMessage = (type: string): Message => msg`${type} is not read; it is left out (export it as a mesh)`;
const exportSurfaceMessage = (type: string): Message =>
  msg`${type} is not read; it is left out (export its surface as a mesh)`;
const UNREAD_TYPES: ReadonlyMap<string, (type: string) => Message> = new Map([
  ['HermiteCurves', leftOutMessage],
  ['NurbsPatch', exportAsMeshMessage],
  ['TetMesh', exportSurfaceMessage],
  ['Volume', leftOutMessage],
  ['Cylinder_1', exportAsMeshMessage],
  ['Capsule_1', exportAsMeshMessage],
]);

/** The diagnostic for a prim of an unsupported type; undefined for others. */
export const unreadType = (type: string): Message | undefined => UNREAD_TYPES.get(type)?.(type);

/** Reports values of a prim that are not evaluated. */
export function reportUnreadValues(context: StageContext, prim: PrimSpec): void {
  for (const property of prim.properties.values()) {
    if (property.kind !== 'attribute' || property.spline === undefined) continue;
    const message = msg`the spline of ${property.name} is not read yet (write the values as time samples)`;
    report(context, 'warning', 'usd.unsupported-arc', prim.path, message);
  }
}
