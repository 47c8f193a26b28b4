import { readFileSync } from 'node:fs';
import type { Vec3 } from '../../src/math/vec3.ts';
import { vertexPosition } from '../../src/scene/motion/motion.ts';
import type { Scene } from '../../src/scene/types.ts';
import { find } from '../support/gltfBuilder.ts';
import type { Files } from './claim.ts';

/** Speed of light far above every speed in these files [m/s]. */
export const C = 1e9;

/** A stage in metres with the given prims and a cube that must always be loaded. */
export const usd = (prims: string): Files => ({
  'a.usda': `#usda 1.0\n(\n    metersPerUnit = 1\n)\n${prims}\ndef Cube "Rest" {}\n`,
});

export const def = (type: string, body = ''): string => `def ${type} "A"\n{\n${body}\n}\n`;

/** A square, as polygons. */
export const FACE = `int[] faceVertexCounts = [4]; int[] faceVertexIndices = [0, 1, 2, 3]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
  uniform token subdivisionScheme = "none"`;

export const paths = (scene: Scene): string[] => scene.objects.map(({ path }) => path);

/** Position of an object's vertex at a time [s]. */
export const corner = (scene: Scene, path: string, vertex: number, t: number): Vec3 =>
  vertexPosition(find(scene, path), vertex, t, C);

/** A Material at `/NAME` with the shader `/NAME/S`; `more`: further prims in it. */
export const material = (
  name: string,
  inputs: string,
  more = '',
  id = 'UsdPreviewSurface',
  output = 'outputs:surface',
): string =>
  `def Material "${name}" { token ${output}.connect = </${name}/S.outputs:surface>
  def Shader "S" { uniform token info:id = "${id}"
    ${inputs}
    token outputs:surface }
  ${more} }\n`;

export const RED = material('Red', 'color3f inputs:diffuseColor = (1, 0, 0)');

/** A motion to (3, 0, 0) within a second. */
export const MOVED = 'double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 24: (3, 0, 0) }';
export const ORDER = 'uniform token[] xformOpOrder = ["xformOp:translate"]';

/** A fixture of the crate reader's tests. */
export const crateFixture = (name: string): Uint8Array =>
  new Uint8Array(readFileSync(new URL(`../../src/formats/usd/crate/fixtures/${name}`, import.meta.url)));
