import { report } from '../diagnostics.ts';
import type { PrimSpec } from '../layer/layer.ts';
import type { StageContext } from './context.ts';

/** Prim types that hold something to see and are not read yet, and what becomes of them. */
const leftOutMessage = (type: string): string => `${type} is not read; it is left out`;
const exportAsMeshMessage = (type: string): string => `${type} is not read; it is left out (export it as a mesh)`;
const exportSurfaceMessage = (type: string): string =>
  `${type} is not read; it is left out (export its surface as a mesh)`;
const UNREAD_TYPES: ReadonlyMap<string, (type: string) => string> = new Map([
  ['BasisCurves', leftOutMessage],
  ['NurbsCurves', leftOutMessage],
  ['HermiteCurves', leftOutMessage],
  ['NurbsPatch', exportAsMeshMessage],
  ['Points', leftOutMessage],
  ['TetMesh', exportSurfaceMessage],
  ['Volume', leftOutMessage],
  ['Cylinder_1', exportAsMeshMessage],
  ['Capsule_1', exportAsMeshMessage],
]);

/** What is said of a prim of a type that is not read; undefined of others. */
export const unreadType = (type: string): string | undefined => UNREAD_TYPES.get(type)?.(type);

/** Says what of a prim's values is not evaluated. */
export function reportUnreadValues(context: StageContext, prim: PrimSpec): void {
  for (const property of prim.properties.values()) {
    if (property.kind !== 'attribute' || property.spline === undefined) continue;
    const message = `the spline of ${property.name} is not read yet (write the values as time samples)`;
    report(context, 'warning', 'usd.unsupported-arc', prim.path, message);
  }
}
