import { report, type StageContext } from './context.ts';
import type { Arc, ListOp, PrimSpec } from './layer.ts';

/** Prim types that hold something to see and are not read yet, and what becomes of them. */
export const UNREAD_TYPES: ReadonlyMap<string, string> = new Map([
  ['PointInstancer', 'is not read yet; its instances are left out (write them out as prims)'],
  ['SkelRoot', 'is not read yet; its meshes stay in their bind pose (bake the skin to points)'],
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

const ARCS = ['references', 'payload', 'inherits', 'specializes'];

interface NamedArc {
  readonly arc: string;
  readonly targets: readonly string[];
}

/** The composition arcs written on a prim. */
function arcsIn(prim: PrimSpec): NamedArc[] {
  return ARCS.flatMap((arc) => {
    const value = prim.metadata.get(arc);
    const targets =
      value?.type === 'arcs'
        ? listed(value.op).map(written)
        : value?.type === 'paths'
          ? listed(value.op).map((path) => `<${path}>`)
          : [];
    return targets.length > 0 ? [{ arc, targets }] : [];
  });
}

export const hasArcs = (prim: PrimSpec): boolean => prim.variantSets.size > 0 || arcsIn(prim).length > 0;

const listed = <T>(op: ListOp<T>): readonly T[] =>
  op.explicit ?? [...(op.prepended ?? []), ...(op.added ?? []), ...(op.appended ?? [])];

const written = ({ asset, path }: Arc): string => `${asset ? `@${asset}@` : ''}${path ? `<${path}>` : ''}`;

const FLATTEN = 'composition comes later; until then flatten the file: usdcat --flatten in.usd -o out.usda';

/** Says which arcs of a prim are not followed. */
export function noteUnreadArcs(context: StageContext, prim: PrimSpec): void {
  const say = (what: string): void =>
    report(context, 'warning', 'usd.unsupported-arc', prim.path, `${what} not read yet (${FLATTEN})`);
  for (const { arc, targets } of arcsIn(prim)) say(`${arc} ${targets.join(', ')} is`);
  const selections = prim.metadata.get('variants');
  for (const [set, variants] of prim.variantSets) {
    const chosen = selections?.type === 'texts-by-name' ? selections.data.get(set) : undefined;
    say(`the variant set '${set}' (${[...variants.keys()].join(', ')}${chosen ? `; selected: ${chosen}` : ''}) is`);
  }
  if (prim.metadata.has('clips')) say('value clips are');
  const instanceable = prim.metadata.get('instanceable');
  if (instanceable?.type === 'bool' && instanceable.data)
    report(
      context,
      'info',
      'usd.instanceable',
      prim.path,
      'is instanceable; what it holds is read like any other prim',
    );
  for (const property of prim.properties.values())
    if (property.kind === 'attribute' && property.spline !== undefined) say(`the spline of ${property.name} is`);
}

/** Says which arcs of the layer are not followed. */
export function noteUnreadLayers(context: StageContext): void {
  const { metadata } = context.layer;
  const subLayers = metadata.get('subLayers');
  if (subLayers?.type === 'subLayers' && subLayers.data.length > 0) {
    const names = subLayers.data.map((arc) => `@${arc.asset}@`).join(', ');
    report(context, 'warning', 'usd.unsupported-arc', '', `the sublayers ${names} are not read yet (${FLATTEN})`);
  }
  if (metadata.has('relocates'))
    report(context, 'warning', 'usd.unsupported-arc', '', `relocates are not read yet (${FLATTEN})`);
}
