import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../tests/support/pythonOracles.ts';
import { fromParts, type Mat4 } from '../../../math/mat4.ts';
import { fromAxisAngle, rotate, toMatrix } from '../../../math/quat.ts';
import { add, type Vec3 } from '../../../math/vec3.ts';
import { boundingBox } from '../../../scene/bounds/bounds.ts';
import { makeMaterial, makeObject, makeScene } from '../../../scene/defaults.ts';
import { transformMesh } from '../../../scene/mesh/meshOps.ts';
import { capsule, cone, cylinder, sphere } from '../../../scene/mesh/primitives.ts';
import type { Mesh } from '../../../scene/types.ts';
import { writeUsda, writeUsdc } from './writeUsd.ts';

/** Type, sizes and axis of each prim in /World, the box of its `extent` by its schema, and its matrix, row by row. */
const ORACLE = `
import json, sys
from pxr import Usd, UsdGeom, UsdShade
stage = Usd.Stage.Open(sys.argv[1])
out = {}
for prim in stage.GetPrimAtPath('/World').GetChildren():
    gprim = UsdGeom.Boundable(prim)
    computed = UsdGeom.Boundable.ComputeExtentFromPlugins(gprim, Usd.TimeCode.Default())
    size = lambda name: prim.GetAttribute(name).Get() if prim.HasAttribute(name) else None
    out[prim.GetName()] = {
        'type': prim.GetTypeName(), 'radius': size('radius'), 'height': size('height'), 'axis': size('axis'),
        'extent': [list(v) for v in gprim.GetExtentAttr().Get()],
        'computed': [list(v) for v in computed],
        'matrix': [x for row in UsdGeom.XformCache().GetLocalToWorldTransform(prim) for x in row],
        'material': str(UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()[0].GetPath()),
    }
print(json.dumps(out))
`;

interface GprimJson {
  readonly type: string;
  readonly radius: number;
  readonly height: number | null;
  readonly axis: string | null;
  readonly extent: readonly Vec3[];
  readonly computed: readonly Vec3[];
  readonly matrix: readonly number[];
  readonly material: string;
}

const folder = mkdtempSync(join(tmpdir(), 'slowlight-gprims-'));
afterAll(() => rmSync(folder, { recursive: true }));

const STRETCH: Mat4 = fromParts([1.5, 0.2, 0, 0.2, 0.7, 0, 0, 0, 1], [0, 0, 0]);
const MOVED: Mat4 = fromParts(toMatrix(fromAxisAngle([3, 1, 0], 0.9)), [0.5, 0, 0.25]);
const pose = { position: [1, -2, 3] as Vec3, orientation: fromAxisAngle([1, 2, -1], 0.7) };

const meshes: readonly (readonly [name: string, mesh: Mesh, radius: number, height: number | null])[] = [
  ['Sphere', sphere(1.2), 1.2, null],
  ['Cylinder', cylinder(0.8, 2, { axis: 'X' }), 0.8, 2],
  ['Cone', transformMesh(cone(1, 2.2, { axis: 'Y' }), STRETCH), 1, 2.2],
  ['Capsule', transformMesh(capsule(0.7, 1.1), MOVED), 0.7, 1.1],
];

describe.skipIf(!hasUsdCore())('usd-core reads written round solids', () => {
  const scene = (metersPerUnit: number) =>
    makeScene({
      name: 'round',
      metersPerUnit,
      materials: [makeMaterial({ name: '/Looks/A' })],
      objects: meshes.map(([name, mesh]) =>
        makeObject({ path: `/World/${name}`, mesh, motion: { kind: 'static', pose } }),
      ),
    });

  it.each([
    ['usda', 1],
    ['usdc', 0.01],
  ] as const)('%s, in units of %d m', (format, unit) => {
    const path = join(folder, `round.${format}`);
    writeFileSync(path, format === 'usda' ? writeUsda(scene(unit)) : writeUsdc(scene(unit)));
    const read: Record<string, GprimJson> = JSON.parse(python('-c', ORACLE, path));
    for (const [name, mesh, radius, height] of meshes) {
      const prim = read[name];
      expect(prim).toMatchObject({ type: name, material: '/Looks/A', radius: expect.closeTo(radius / unit, 9) });
      expect(prim.height).toEqual(height === null ? null : expect.closeTo(height / unit, 9));
      prim.extent.forEach((corner, i) => {
        expect(corner).toEqual(prim.computed[i].map((x) => expect.closeTo(x, 3)));
      });
      expectBounds(prim, mesh, unit);
    }
  });
});

/** The solid that usd-core sees has the bounds of the mesh: its support along each axis is that of the mesh's points, up to the facets. */
function expectBounds({ type, radius, height, axis, matrix }: GprimJson, mesh: Mesh, unit: number): void {
  const placed = Float32Array.from(
    { length: mesh.positions.length },
    (_, i) => add(pose.position, rotate(pose.orientation, pointOf(mesh, Math.floor(i / 3))))[i % 3],
  );
  const box = boundingBox(placed)!;
  const along = ['X', 'Y', 'Z'].indexOf(axis ?? 'Z');
  const half = (height ?? 0) / 2;
  for (let k = 0; k < 3; k++) {
    // Row vectors: column k of the matrix is what the coordinate k of the world depends on.
    const n = [matrix[k], matrix[4 + k], matrix[8 + k]];
    const across = radius * Math.hypot(...n.filter((_, i) => i !== along));
    const support = (sign: number): number => {
      const up = sign * n[along];
      if (type === 'Sphere') return radius * Math.hypot(...n);
      if (type === 'Cylinder') return Math.abs(up) * half + across;
      if (type === 'Cone') return Math.max(up * half, across - up * half);
      return Math.abs(up) * half + radius * Math.hypot(...n);
    };
    expect((matrix[12 + k] + support(1)) * unit).toBeCloseTo(box.max[k], 2);
    expect((matrix[12 + k] - support(-1)) * unit).toBeCloseTo(box.min[k], 2);
  }
}

const pointOf = ({ positions }: Mesh, i: number): Vec3 => [
  positions[3 * i],
  positions[3 * i + 1],
  positions[3 * i + 2],
];
