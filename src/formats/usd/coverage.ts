import { report, type StageContext } from './context.ts';
import type { PrimSpec } from './layer.ts';

/** Prim types that hold something to see and are not read yet, and what becomes of them. */
export const UNREAD_TYPES: ReadonlyMap<string, string> = new Map([
  ['BasisCurves', 'is not read; it is left out'],
  ['NurbsCurves', 'is not read; it is left out'],
  ['HermiteCurves', 'is not read; it is left out'],
  ['NurbsPatch', 'is not read; it is left out (export it as a mesh)'],
  ['Points', 'is not read; it is left out'],
  ['TetMesh', 'is not read; it is left out (export its surface as a mesh)'],
  ['Volume', 'is not read; it is left out'],
  ['Cylinder_1', 'is not read; it is left out (export it as a mesh)'],
  ['Capsule_1', 'is not read; it is left out (export it as a mesh)'],
]);

/** Says what of a prim's values is not evaluated. */
export function noteUnreadValues(context: StageContext, prim: PrimSpec): void {
  const say = (what: string): void =>
    report(
      context,
      'warning',
      'usd.unsupported-arc',
      prim.path,
      `${what} not read yet (write the values as time samples)`,
    );
  for (const property of prim.properties.values())
    if (property.kind === 'attribute' && property.spline !== undefined) say(`the spline of ${property.name} is`);
}
