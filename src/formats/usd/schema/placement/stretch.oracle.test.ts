import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { hasUsdCore, python } from '../../../../../tests/support/pythonOracles.ts';
import { determinant } from '../../../../math/mat3.ts';
import { cross, distance, dot, length, sub, type Vec3 } from '../../../../math/vec3.ts';
import { sphere } from '../../../../scene/mesh/primitives.ts';
import { objectNormal, objectPoint } from '../../../../scene/mesh/stretch.ts';
import { vertexPosition } from '../../../../scene/motion/motion.ts';
import type { Scene } from '../../../../scene/types.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';
import { writeUsda, writeUsdc } from '../../write/writeUsd.ts';

/** World points of all meshes at the times after the file, by prim path, instances too; and of instancers, in their order. */
const ORACLE = `
import json, sys
from pxr import Gf, Usd, UsdGeom
stage = Usd.Stage.Open(sys.argv[1])
times = [float(t) for t in sys.argv[2:]]
out = {}
def points(mesh, matrix, t):
    return [list(matrix.Transform(Gf.Vec3d(*map(float, p)))) for p in mesh.GetPointsAttr().Get(t)]
for prim in stage.Traverse(Usd.TraverseInstanceProxies()):
    if prim.IsA(UsdGeom.Mesh) and not prim.GetParent().IsA(UsdGeom.PointInstancer):
        out[str(prim.GetPath())] = [points(UsdGeom.Mesh(prim), UsdGeom.XformCache(t).GetLocalToWorldTransform(prim), t) for t in times]
    if prim.IsA(UsdGeom.PointInstancer):
        kept = UsdGeom.PointInstancer(prim)
        mesh = UsdGeom.Mesh(stage.GetPrimAtPath(kept.GetPrototypesRel().GetTargets()[0]))
        for t in times:
            to_world = UsdGeom.XformCache(t).GetLocalToWorldTransform(prim)
            for i, matrix in enumerate(kept.ComputeInstanceTransformsAtTime(t, t)):
                out.setdefault(f'{prim.GetPath()}/{i}', []).append(points(mesh, matrix * to_world, t))
print(json.dumps(out))
`;

type Places = Record<string, readonly (readonly (readonly [number, number, number])[])[]>;

const TIMES = [0, 12, 24];
const ball = sphere(0.5, { segments: 12, rings: 8 });
const tuples = (values: Float32Array): string =>
  `[${Array.from({ length: values.length / 3 }, (_, i) => `(${values.subarray(3 * i, 3 * i + 3).join(', ')})`).join(', ')}]`;
const meshText = `
    int[] faceVertexCounts = [${new Array(ball.indices.length / 3).fill(3).join(', ')}]
    int[] faceVertexIndices = [${ball.indices.join(', ')}]
    point3f[] points = ${tuples(ball.positions)}
    normal3f[] normals = ${tuples(ball.normals)} (
        interpolation = "vertex"
    )
    uniform token subdivisionScheme = "none"`;

const pot = (name: string, ops: string, order: string): string => `
def Xform "${name}" (
    instanceable = true
    prepend references = </Kept>
)
{
    ${ops}
    uniform token[] xformOpOrder = [${order}]
}`;

const ORDER = '"xformOp:translate", "xformOp:rotateXYZ", "xformOp:scale"';
const file = `#usda 1.0
(
    metersPerUnit = 0.01
    timeCodesPerSecond = 24
    startTimeCode = 0
    endTimeCode = 24
)
class "Kept"
{
    def Mesh "Ball"
    {${meshText}
    }
}
${pot('Long', 'double3 xformOp:translate = (1, 2, 3)\n float3 xformOp:rotateXYZ = (20, 30, 40)\n float3 xformOp:scale = (1, 2, 3)', ORDER)}
${pot('Mirrored', 'double3 xformOp:translate = (-1, 2, 3)\n float3 xformOp:rotateXYZ = (70, -30, 10)\n float3 xformOp:scale = (-1, 2, 0.5)', ORDER)}
${pot('Turning', 'double3 xformOp:translate = (4, 0, 0)\n float3 xformOp:rotateXYZ.timeSamples = { 0: (0, 0, 0), 24: (0, 80, 0) }\n float3 xformOp:scale = (2, 0.5, 1)', ORDER)}
${pot('Sheared', 'matrix4d xformOp:transform = ((1, 0.3, 0, 0), (0, 1.5, 0.2, 0), (0.4, 0, 0.8, 0), (5, 6, 7, 1))', '"xformOp:transform"')}
${pot('Flat', 'double3 xformOp:translate = (0, 9, 0)\n float3 xformOp:scale = (1, 0, 1)', '"xformOp:translate", "xformOp:scale"')}
def PointInstancer "Crowd"
{
    point3f[] positions = [(10, 0, 0), (20, 0, 0), (30, 0, 0), (40, 0, 0)]
    float3[] scales = [(1, 1, 1), (1, 2, 1), (3, 1, -1), (0.5, 0.5, 2)]
    quath[] orientations = [(1, 0, 0, 0), (0.5, 0.5, 0.5, 0.5), (0.5, -0.5, 0.5, 0.5), (1, 0, 0, 0)]
    int[] protoIndices = [0, 0, 0, 0]
    rel prototypes = </Crowd/Ball>
    def Mesh "Ball"
    {${meshText}
    }
}
`;

const folder = mkdtempSync(join(tmpdir(), 'slowlight-stretch-'));
afterAll(() => rmSync(folder, { recursive: true }));

function oracle(name: string, content: string | Uint8Array): Places {
  const path = join(folder, name);
  writeFileSync(path, content);
  return JSON.parse(python('-c', ORACLE, path, ...TIMES.map(String))) as Places;
}

const nearest = (points: readonly Vec3[], to: Vec3): number => Math.min(...points.map((point) => distance(point, to)));

/** Farthest of all vertices from where the oracle has them [m]. */
function worstOf(scene: Scene, places: Places, pathOf: (path: string) => string): number {
  return Math.max(
    ...scene.objects.flatMap((object) =>
      TIMES.map((time, k) => {
        const points = places[pathOf(object.path)][k];
        expect(points).toHaveLength(object.mesh.positions.length / 3);
        // Readers number points anew, by the first face that has them.
        const placed = points.map((_, i) => vertexPosition(object, i, time / 24, 3e8));
        return Math.max(...points.map(([x, y, z]) => nearest(placed, [0.01 * x, 0.01 * y, 0.01 * z])));
      }),
    ),
  );
}

describe.skipIf(!hasUsdCore())('instances with scales of their own', () => {
  const read = () => readUsd(memorySource({ 'pots.usda': new TextEncoder().encode(file) }), 'pots.usda');

  it('are where usd-core has them, and share few meshes', async () => {
    const scene = await read();
    const named = (path: string): string => path.replace(/^\/Crowd\[(\d)\].*/, '/Crowd/$1');
    expect(scene.objects.map(({ path }) => path)).toHaveLength(9);
    expect(worstOf(scene, oracle('pots.usda', file), named)).toBeLessThan(2e-5);
    const meshes = new Set(scene.objects.map(({ mesh }) => mesh));
    // The ball and its mirror image of each prim, and the flat one.
    expect(meshes.size).toBe(5);
  });

  it('have positive stretches, and fronts and normals outside, mirrored too', async () => {
    const { objects } = await read();
    for (const object of objects.filter(({ path }) => !path.startsWith('/Flat'))) {
      if (object.stretch) expect(determinant(object.stretch)).toBeGreaterThan(0);
      const { indices } = object.mesh;
      for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map((k) => objectPoint(object, indices[i + k]));
        const outwards = cross(sub(b, a), sub(c, a));
        if (length(outwards) < 1e-9) continue;
        // The origin is inside.
        expect(dot(outwards, a), object.path).toBeGreaterThan(0);
        expect(dot(outwards, objectNormal(object, indices[i])), object.path).toBeGreaterThan(0);
      }
    }
  });

  it.each(['usda', 'usdc'] as const)('are written as %s where they are, and read back', async (format) => {
    const scene = await read();
    const content = format === 'usda' ? writeUsda(scene) : writeUsdc(scene);
    const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
    const back = await readUsd(memorySource({ [`again.${format}`]: bytes }), `again.${format}`);
    expect(worstOf(back, oracle(`again.${format}`, content), (path) => path)).toBeLessThan(2e-5);
    expect(back.diagnostics.filter(({ severity }) => severity !== 'info')).toEqual([]);
    back.objects.forEach((object, k) => {
      const before = scene.objects[k];
      const count = before.mesh.positions.length / 3;
      const placed = Array.from({ length: count }, (_, i) => vertexPosition(object, i, 0.7, 3e8));
      for (let i = 0; i < count; i++) expect(nearest(placed, vertexPosition(before, i, 0.7, 3e8))).toBeLessThan(2e-5);
    });
  });
});
