import { report, type StageContext } from './context.ts';
import type { PrimSpec } from './layer.ts';

/** Prim types that hold something to see and are not read yet, and what becomes of them. */
const leftOut = (type: string): string => `${type} is not read; it is left out`;
const asMesh = (type: string): string => `${type} is not read; it is left out (export it as a mesh)`;
const surfaceAsMesh = (type: string): string => `${type} is not read; it is left out (export its surface as a mesh)`;
const UNREAD: ReadonlyMap<string, (type: string) => string> = new Map([
  ['BasisCurves', leftOut],
  ['NurbsCurves', leftOut],
  ['HermiteCurves', leftOut],
  ['NurbsPatch', asMesh],
  ['Points', leftOut],
  ['TetMesh', surfaceAsMesh],
  ['Volume', leftOut],
  ['Cylinder_1', asMesh],
  ['Capsule_1', asMesh],
]);

/** What is said of a prim of a type that is not read; undefined of others. */
export const unreadType = (type: string): string | undefined => UNREAD.get(type)?.(type);

/** Says what of a prim's values is not evaluated. */
export function noteUnreadValues(context: StageContext, prim: PrimSpec): void {
  for (const property of prim.properties.values()) {
    if (property.kind !== 'attribute' || property.spline === undefined) continue;
    const message = `the spline of ${property.name} is not read yet (write the values as time samples)`;
    report(context, 'warning', 'usd.unsupported-arc', prim.path, message);
  }
}
