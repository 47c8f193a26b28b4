import { msg } from '../../../../messages/message.ts';
import { withMaterial } from '../../../../scene/mesh/meshOps.ts';
import { type Axis, box, capsule, cone, cylinder, plane, sphere } from '../../../../scene/mesh/primitives.ts';
import type { Mesh } from '../../../../scene/types.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numberAt, sampleTimes, textAt, valueAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import type { StageContext } from '../context.ts';
import type { PrimMaterials } from '../materials/materialBinding.ts';
import type { PrimGeometry } from './primGeometry.ts';

type GprimBuilder = (size: (name: string, fallback: number) => number, axis: Axis) => Mesh;

/** The parametric shapes of UsdGeom with their fallback sizes. */
const BUILDERS: ReadonlyMap<string, GprimBuilder> = new Map<string, GprimBuilder>([
  ['Cube', (size) => cube(size('size', 2))],
  ['Sphere', (size) => sphere(size('radius', 1))],
  ['Cylinder', (size, axis) => cylinder(size('radius', 1), size('height', 2), { axis })],
  ['Cone', (size, axis) => cone(size('radius', 1), size('height', 2), { axis })],
  ['Capsule', (size, axis) => capsule(size('radius', 0.5), size('height', 1), { axis })],
  ['Plane', (size, axis) => plane(size('width', 2), size('length', 2), axis)],
]);

const cube = (size: number): Mesh => box([size, size, size]);

export const isGprim = (typeName: string): boolean => BUILDERS.has(typeName);

export function gprimGeometry(context: StageContext, prim: PrimSpec, surface: PrimMaterials): PrimGeometry {
  const size = (name: string, fallback: number): number => {
    if (sampleTimes(attributeOf(prim, name)).length > 0)
      report(
        context,
        'warning',
        'usd.animated-size',
        prim.path,
        msg`${name} changes with time; it is held at the start`,
      );
    return numberAt(prim, name, context.startCode) ?? fallback;
  };
  const written = textAt(prim, 'axis', undefined);
  const axis: Axis = written === 'X' || written === 'Y' ? written : 'Z';
  const mesh = BUILDERS.get(prim.typeName)!(size, axis);
  return { mesh: withMaterial(withSides(prim, mesh), surface.base.index) };
}

/** By `doubleSided`; fallback true for planes and false for closed shapes. */
function withSides(prim: PrimSpec, mesh: Mesh): Mesh {
  const value = valueAt(attributeOf(prim, 'doubleSided'), undefined);
  return value?.type === 'bool' ? { ...mesh, doubleSided: value.data } : mesh;
}
