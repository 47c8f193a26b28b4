import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import type { Mesh } from '../../src/scene/types.ts';
import type { Bench } from '../support/bench.ts';
import { inChild } from '../support/inChild.ts';

const COUNT = 1000;
const TRIANGLES = 10_000;

/** Result of child.ts for a file. */
interface InstancesMeasurement {
  readonly load: number;
  readonly loaded: number;
  readonly upload: number;
  readonly resident: number;
  readonly still: number;
  readonly fast: number;
  readonly triangles: number;
}

export const instances: Bench = {
  name: 'instances',
  title: 'A thousand instances',
  about:
    `${COUNT.toLocaleString('en')} instances of a sphere of about ${TRIANGLES.toLocaleString('en')} triangles in a cube of 10 × 10 × 10, 640 × 360, from a file of one mesh. *Instances*: of a PointInstancer. ` +
    '*Copies*: prims that refer to the mesh, each with an opinion of its own on it, so that each is a mesh of its own, which is what instances were before. Each in a process of its own, one after the other. ' +
    '*Memory*: resident, after reading and after drawing; with a software GPU that is the memory of program and GPU together. *Upload*: and the first picture. A frame ends when its pixels have been read back.',
  async run() {
    const folder = mkdtempSync(join(tmpdir(), 'slowlight-bench-'));
    try {
      const texts = { instances: instancer(), copies: references() };
      const rows = Object.entries(texts).map(([name, text]) => {
        console.error(`  ${name}`);
        const file = join(folder, `${name}.usda`);
        writeFileSync(file, text);
        const { load, loaded, upload, resident, still, fast, triangles } = inChild<InstancesMeasurement>(
          'instances',
          file,
        );
        const mebibytes = [loaded, resident].map((bytes) => bytes / 2 ** 20);
        return [
          name,
          load / 1000,
          mebibytes[0],
          upload / 1000,
          mebibytes[1],
          still,
          fast,
          triangles.toLocaleString('en'),
        ];
      });
      const columns = ['', 'read [s]', 'then [MiB]', 'upload [s]', 'then [MiB]', 'at rest [ms]', 'at 0.9 c [ms]'];
      return [{ columns: [...columns, 'triangles at 0.9 c'], rows }];
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  },
};

const HEAD = '#usda 1.0\n( metersPerUnit = 1 )\n';

const places = Array.from({ length: COUNT }, (_, i) => {
  const [x, y, z] = [i % 10, Math.floor(i / 10) % 10, Math.floor(i / 100)];
  return `(${2.5 * (x - 4.5)}, ${2.5 * (y - 4.5)}, ${-6 - 2.5 * z})`;
});

function instancer(): string {
  return `${HEAD}over "Kept" { ${prim()} }
def PointInstancer "Crowd" {
  int[] protoIndices = [${places.map(() => '0').join(', ')}]
  point3f[] positions = [${places.join(', ')}]
  rel prototypes = </Kept/Ball>
}
`;
}

function references(): string {
  const prims = places.map(
    (place, i) => `def Mesh "Ball${i}" ( references = </Kept/Ball> ) {
  custom int own = ${i}
  double3 xformOp:translate = ${place}
  uniform token[] xformOpOrder = ["xformOp:translate"]
}
`,
  );
  return `${HEAD}over "Kept" { ${prim()} }\n${prims.join('')}`;
}

function prim(): string {
  const { positions, normals, indices }: Mesh = sphere(0.6, { segments: Math.round(1 + Math.sqrt(1 + TRIANGLES)) });
  const vectors = (array: Float32Array): string =>
    Array.from({ length: array.length / 3 }, (_, i) => `(${array.subarray(3 * i, 3 * i + 3).join(', ')})`).join(', ');
  return `def Mesh "Ball" {
  int[] faceVertexCounts = [${Array.from({ length: indices.length / 3 }, () => 3).join(', ')}]
  int[] faceVertexIndices = [${indices.join(', ')}]
  point3f[] points = [${vectors(positions)}]
  normal3f[] normals = [${vectors(normals)}] ( interpolation = "vertex" )
  uniform token subdivisionScheme = "none"
}`;
}
