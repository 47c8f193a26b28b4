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

/** How finely a round shape is divided into polygons; USD leaves that to the renderer. */
interface Division {
  readonly axis: Axis;
  readonly segments?: number;
  readonly rings?: number;
}

type GprimBuilder = (size: (name: string, fallback: number) => number, division: Division) => Mesh;

/** The parametric shapes of UsdGeom with their fallback sizes. */
const BUILDERS: ReadonlyMap<string, GprimBuilder> = new Map<string, GprimBuilder>([
  ['Cube', (size) => cube(size('size', 2))],
  ['Sphere', (size, division) => sphere(size('radius', 1), division)],
  ['Cylinder', (size, division) => cylinder(size('radius', 1), size('height', 2), division)],
  ['Cone', (size, division) => cone(size('radius', 1), size('height', 2), division)],
  ['Capsule', (size, division) => capsule(size('radius', 0.5), size('height', 1), division)],
  ['Plane', (size, { axis }) => plane(size('width', 2), size('length', 2), axis)],
]);

const cube = (size: number): Mesh => box([size, size, size]);

export const isGprim = (typeName: string): boolean => BUILDERS.has(typeName);

export const gprimGeometry = (context: StageContext, prim: PrimSpec, surface: PrimMaterials): PrimGeometry => ({
  mesh: withMaterial(gprimMesh(context, prim), surface.base.index),
});

/** A parametric shape as triangles. */
export function gprimMesh(context: StageContext, prim: PrimSpec): Mesh {
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
  // USD's spheres have none; ours say with another name around what texture coordinates run.
  const written = textAt(prim, prim.typeName === 'Sphere' ? 'slowlight:axis' : 'axis', undefined);
  const axis: Axis = written === 'X' || written === 'Y' ? written : 'Z';
  const count = (name: 'segments' | 'rings') => divisionAt(context, prim, name);
  const mesh = BUILDERS.get(prim.typeName)!(size, { axis, segments: count('segments'), rings: count('rings') });
  return withSides(prim, mesh);
}

/** The fewest and the most polygons along a way that a file may ask for. */
export const DIVISIONS = { segments: [3, 256], rings: [2, 128] } as const;

/** `slowlight:segments` and `slowlight:rings`; undefined leaves it to the shape. */
function divisionAt(context: StageContext, prim: PrimSpec, name: 'segments' | 'rings'): number | undefined {
  const asked = numberAt(prim, `slowlight:${name}`, undefined);
  if (asked === undefined) return undefined;
  const [least, most] = DIVISIONS[name];
  if (Number.isInteger(asked) && asked >= least && asked <= most) return asked;
  const message = msg`slowlight:${name} is ${asked}, not a whole number from ${least} to ${most}; it is left out`;
  report(context, 'warning', 'usd.slowlight', prim.path, message);
  return undefined;
}

/** By `doubleSided`; fallback true for planes and false for closed shapes. */
function withSides(prim: PrimSpec, mesh: Mesh): Mesh {
  const value = valueAt(attributeOf(prim, 'doubleSided'), undefined);
  return value?.type === 'bool' ? { ...mesh, doubleSided: value.data } : mesh;
}
