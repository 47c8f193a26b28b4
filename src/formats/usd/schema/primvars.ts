import { msg } from '../../../messages/message.ts';
import type { PolygonValues } from '../../../scene/mesh/polygons.ts';
import { report } from '../diagnostics.ts';
import { attributeOf, numbersOf, type TimeCode, valueAt } from '../layer/attributes.ts';
import type { AttributeSpec, NumberArray, PrimSpec } from '../layer/layer.ts';
import { metadataText } from '../layer/query.ts';
import type { StageContext } from './context.ts';

/** Number of values per interpolation. */
export interface MeshElementCounts {
  readonly points: number;
  readonly corners: number;
  readonly faces: number;
}

const ELEMENTS: ReadonlyMap<string, PolygonValues['per']> = new Map([
  ['constant', 'constant'],
  ['uniform', 'face'],
  ['varying', 'point'],
  ['vertex', 'point'],
  ['faceVarying', 'corner'],
]);

export interface Primvar {
  readonly interpolation: PolygonValues['per'];
  /** `varying`: interpolated linearly even on subdivision surfaces. */
  readonly isLinear: boolean;
  readonly values: NumberArray;
  readonly indices?: NumberArray;
  readonly attribute: AttributeSpec;
}

/** A primvar or `normals` with its indices; undefined if it has no value. */
export function primvarOf(prim: PrimSpec, name: string, time: TimeCode, fallback = 'constant'): Primvar | undefined {
  const attribute = attributeOf(prim, name);
  const values = numbersOf(valueAt(attribute, time));
  if (!attribute || !values) return undefined;
  const written = metadataText(attribute.metadata, 'interpolation') ?? fallback;
  const interpolation = ELEMENTS.get(written) ?? 'constant';
  const isLinear = written === 'varying';
  const indices = numbersOf(valueAt(attributeOf(prim, `${name}:indices`), time));
  return { interpolation, isLinear, values, attribute, ...(indices ? { indices } : {}) };
}

/** The primvar as values on a mesh; undefined, with a warning, if its count does not fit. */
export function valuesOnMesh(
  context: StageContext,
  prim: PrimSpec,
  name: string,
  primvar: Primvar,
  size: number,
  topology: MeshElementCounts,
): PolygonValues | undefined {
  const { interpolation: per, values, indices } = primvar;
  const needed = { point: topology.points, corner: topology.corners, face: topology.faces, constant: 1 }[per];
  const held = values.length / size;
  const count = indices ? indices.length : held;
  const outside = indices?.some((i) => !(i >= 0 && i < held)) ?? false;
  if (count >= needed && !outside) {
    return { per, values, ...(indices ? { indices } : {}), ...(primvar.isLinear ? { linear: true } : {}) };
  }
  const message = outside
    ? msg`${name} has an index outside its ${held} values; it is left out`
    : msg`${name} has ${count} values where ${needed} are needed; it is left out`;
  report(context, 'warning', 'usd.primvar', prim.path, message);
  return undefined;
}
