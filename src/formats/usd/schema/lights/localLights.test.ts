import { describe, expect, it } from 'vitest';
import { rotate } from '../../../../math/quat.ts';
import type { Vec3 } from '../../../../math/vec3.ts';
import { inEnglish } from '../../../../messages/message.ts';
import { projectedArea } from '../../../../scene/lights/lightKinds.ts';
import type { LocalLight, Scene } from '../../../../scene/types.ts';
import { blackbodyColor } from '../../../../spectrum/color/blackbodyColor.ts';
import { memorySource } from '../../../files/fileSource.ts';
import { readUsd } from '../../read.ts';
import { writeUsda } from '../../write/writeUsd.ts';

const HEADER = '#usda 1.0\n(\n    metersPerUnit = 0.01\n)\n';
const readText = (text: string): Promise<Scene> =>
  readUsd(memorySource({ 'a.usda': new TextEncoder().encode(text) }), 'a.usda');
const read = (prims: string): Promise<Scene> => readText(HEADER + prims);

async function lamp(type: string, ...lines: string[]): Promise<LocalLight> {
  const [light] = (await read(`def ${type} "L"\n{\n${lines.join('\n')}\n}\n`)).lights;
  if (light.kind === 'distant' || light.kind === 'dome' || light.kind === 'stars') throw new Error(light.kind);
  return light;
}
const near = (v: readonly number[]) => v.map((x) => expect.closeTo(x, 6));
const axisOf = (light: LocalLight, axis: Vec3): Vec3 =>
  light.motion.kind === 'static' ? rotate(light.motion.pose.orientation, axis) : axis;

describe('area lights', () => {
  it('have USD’s default sizes, in metres', async () => {
    expect(await lamp('RectLight')).toMatchObject({ kind: 'rect', width: 0.01, height: 0.01, color: [1, 1, 1] });
    expect(await lamp('DiskLight')).toMatchObject({ kind: 'disk', radius: 0.005 });
    expect(await lamp('CylinderLight')).toMatchObject({ kind: 'cylinder', radius: 0.005, length: 0.01 });
  });

  it('are scaled and rotated by their transforms', async () => {
    const light = await lamp(
      'RectLight',
      'float inputs:width = 30',
      'float inputs:height = 20',
      'double3 xformOp:translate = (100, 0, 0)',
      'double xformOp:rotateX = 90',
      'double3 xformOp:scale = (2, 3, 4)',
      'uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateX", "xformOp:scale"]',
    );
    expect(light).toMatchObject({ width: expect.closeTo(0.6, 6), height: expect.closeTo(0.6, 6) });
    expect(light.motion).toMatchObject({ kind: 'static', pose: { position: near([1, 0, 0]) } });
    // A turn by 90° about X takes −Z to +Y.
    expect(axisOf(light, [0, 0, -1])).toEqual(near([0, 1, 0]));
    expect(axisOf(light, [1, 0, 0])).toEqual(near([1, 0, 0]));
  });

  it('emit to the other side if reflected', async () => {
    const order = 'uniform token[] xformOpOrder = ["xformOp:scale"]';
    for (const [scale, front] of [
      ['(1, 1, -1)', [0, 0, 1]],
      ['(-1, 1, 1)', [0, 0, -1]],
    ] as const)
      expect(axisOf(await lamp('DiskLight', `double3 xformOp:scale = ${scale}`, order), [0, 0, -1])).toEqual(
        near(front),
      );
  });

  it('move by transforms, and by slowlight:motion', async () => {
    const order = 'uniform token[] xformOpOrder = ["xformOp:translate"]';
    const moving = await lamp(
      'RectLight',
      'double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 24: (100, 0, 0) }',
      order,
    );
    expect(moving.motion).toMatchObject({ kind: 'sampled', times: Float64Array.of(0, 1) });
    const flying = await lamp(
      'DiskLight',
      'token slowlight:motion = "uniform"',
      'vector3d slowlight:velocity = (0, 50, 0)',
    );
    expect(flying.motion).toMatchObject({ kind: 'uniform', velocity: [0, 0.5, 0] });
  });

  it('have the same intensity at any size if normalized', async () => {
    const intensity = async (type: string, ...sizes: string[]): Promise<number> => {
      const light = await lamp(type, 'bool inputs:normalize = 1', 'float inputs:intensity = 5', ...sizes);
      return light.color[1] * projectedArea(light);
    };
    // In metres: E = I (0.01 m)²/d²; the projected area is that of a face, ¼ of a sphere’s, 1/π of a cylinder’s.
    for (const k of [1, 7]) {
      const radius = `float inputs:radius = ${k}`;
      expect(await intensity('RectLight', `float inputs:width = ${k}`)).toBeCloseTo(5e-4, 9);
      expect(await intensity('DiskLight', radius)).toBeCloseTo(5e-4, 9);
      expect(await intensity('SphereLight', radius)).toBeCloseTo(5e-4 / 4, 9);
      expect(await intensity('SphereLight', radius, 'bool treatAsPoint = 1')).toBeCloseTo(5e-4 / 4, 9);
      expect(await intensity('CylinderLight', radius, 'float inputs:length = 3')).toBeCloseTo(5e-4 / Math.PI, 9);
      expect(await intensity('CylinderLight', radius, 'bool treatAsLine = 1')).toBeCloseTo(5e-4 / Math.PI, 9);
    }
    expect(await intensity('RectLight', 'float inputs:width = 0')).toBe(0);
  });

  it('treated as points and lines keep their intensity', async () => {
    for (const [type, hint] of [
      ['SphereLight', 'treatAsPoint'],
      ['CylinderLight', 'treatAsLine'],
    ]) {
      const [thick, thin] = [await lamp(type), await lamp(type, `bool ${hint} = 1`)];
      expect(thin).toMatchObject({ radius: 0 });
      expect(thin.color[0] * projectedArea(thin)).toBeCloseTo(thick.color[0] * projectedArea(thick), 12);
    }
  });
});

describe('inputs of lights', () => {
  it('colour, temperature, exposure and intensity are multiplied', async () => {
    const light = await lamp(
      'RectLight',
      'color3f inputs:color = (1, 0.5, 0.25)',
      'bool inputs:enableColorTemperature = 1',
      'float inputs:colorTemperature = 3000',
      'float inputs:intensity = 3',
      'float inputs:exposure = 2',
      'float inputs:diffuse = 0.5',
      'float inputs:specular = 0.5',
    );
    const [r, g, b] = blackbodyColor(3000);
    expect(light.color).toEqual(near([6 * r, 3 * g, 1.5 * b]));
  });

  it('are found without their prefix', async () => {
    const light = await lamp('DiskLight', 'float radius = 4', 'float intensity = 2', 'color3f color = (1, 0, 0)');
    expect(light).toMatchObject({ radius: 0.04, color: [2, 0, 0] });
  });

  it('shape a cone, softly on the inside; a face has no light behind it anyway', async () => {
    const cone = ['float inputs:shaping:cone:angle = 40', 'float inputs:shaping:cone:softness = 0.25'];
    for (const type of ['SphereLight', 'RectLight']) {
      const { shaping } = await lamp(type, ...cone, 'float inputs:shaping:focus = 2');
      const outer = (40 * Math.PI) / 180;
      expect(shaping).toEqual({ inner: expect.closeTo(0.75 * outer, 6), outer: expect.closeTo(outer, 6), focus: 2 });
    }
    const wide = 'float inputs:shaping:cone:angle = 90';
    expect((await lamp('DiskLight', wide)).shaping).toBeUndefined();
    expect((await lamp('SphereLight', wide)).shaping?.outer).toBeCloseTo(Math.PI / 2, 6);
    expect((await lamp('SphereLight', 'float inputs:shaping:cone:angle = 180')).shaping).toBeUndefined();
  });

  it('give the angular diameter of a sun, in degrees', async () => {
    const [written, unwritten] = (
      await read('def DistantLight "A" { float inputs:angle = 1.5 }\ndef DistantLight "B" {}')
    ).lights;
    expect(written).toMatchObject({ angle: expect.closeTo((1.5 * Math.PI) / 180, 9) });
    expect(unwritten).not.toHaveProperty('angle');
  });

  it('that are not supported are reported', async () => {
    const { diagnostics } = await read(
      'def RectLight "L"\n{\nasset inputs:shaping:ies:file = @a.ies@\nasset inputs:texture:file = @no.png@\nfloat inputs:specular = 0\n}\n',
    );
    expect(diagnostics.map((d) => inEnglish(d.message))).toEqual([
      'the IES profile of the light is not applied',
      expect.stringContaining('no.png is not there'),
      'its multiplier for diffuse light, 1, is taken for specular light too',
    ]);
  });
});

describe('meshes that are lights', () => {
  const triangle =
    'int[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 2]\npoint3f[] points = [(0, 0, 0), (2, 0, 0), (0, 2, 0)]';
  const api = '(prepend apiSchemas = ["MeshLightAPI"])';
  const glow = async (head: string, ...lines: string[]) => {
    const scene = await read(
      `${head}\n{\n${[triangle, ...lines].join('\n')}\n}\ndef GeometryLight "G" { rel geometry = </Plain>\nfloat inputs:intensity = 9 }\ndef Material "M" { token outputs:surface.connect = </M/S.outputs:surface>\ndef Shader "S" { uniform token info:id = "UsdPreviewSurface"\ncolor3f inputs:emissiveColor = (0.5, 0, 0)\ntoken outputs:surface\n} }\n`,
    );
    return scene.materials[scene.objects[0].mesh.groups[0].material];
  };

  it('emit as given by LightAPI, divided by their area if normalized', async () => {
    expect(await glow(`def Mesh "L" ${api}`, 'float inputs:intensity = 6')).toMatchObject({
      emissive: [6, 6, 6],
      baseColor: [0.5, 0.5, 0.5],
    });
    const normalized = ['float inputs:intensity = 6', 'bool inputs:normalize = 1'];
    expect((await glow(`def Mesh "L" ${api}`, ...normalized)).emissive).toEqual(near([3, 3, 3]));
  });

  it('are tinted by their material, or not', async () => {
    const lines = ['float inputs:intensity = 6', 'rel material:binding = </M>'];
    const mode = (name: string) => `uniform token light:materialSyncMode = "${name}"`;
    expect((await glow(`def Mesh "L" ${api}`, ...lines)).emissive).toEqual([3, 0, 0]);
    expect((await glow(`def Mesh "L" ${api}`, ...lines, mode('independent'))).emissive).toEqual([6, 6, 6]);
    expect(await glow(`def Mesh "L" ${api}`, ...lines, mode('noMaterialResponse'))).toMatchObject({
      emissive: [6, 6, 6],
      baseColor: [0, 0, 0],
    });
  });

  it('can be targets of a GeometryLight', async () => {
    expect(await glow('def Mesh "Plain"')).toMatchObject({ emissive: [9, 9, 9], baseColor: [0, 0, 0] });
    expect((await glow('def Mesh "Other"')).emissive).toEqual([0, 0, 0]);
  });
});

it('written lights are read back', async () => {
  const scene = await read(`
def RectLight "A" (prepend apiSchemas = ["ShapingAPI"])
{
    float inputs:width = 30
    float inputs:height = 20
    float inputs:shaping:cone:angle = 40
    float inputs:shaping:cone:softness = 0.5
    double slowlight:birth = 1
    double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 24: (100, 0, 0) }
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
def DiskLight "B" { float inputs:radius = 8
    token slowlight:motion = "uniform"
    vector3d slowlight:velocity = (0, 50, 0) }
def CylinderLight "C" { bool treatAsLine = 1
    float inputs:length = 12 }
def SphereLight "D" { float inputs:shaping:focus = 3
    float inputs:shaping:cone:angle = 180 }
`);
  const back = await readText(writeUsda(scene));
  scene.lights.forEach((light, i) => {
    if (!('motion' in light)) throw new Error(light.kind);
    const { shaping, ...rest } = light;
    const numbers = (value: object) =>
      Object.fromEntries(Object.entries(value).map(([k, v]) => [k, typeof v === 'number' ? expect.closeTo(v, 6) : v]));
    expect(back.lights[i]).toEqual({
      ...numbers(rest),
      motion: expect.anything(),
      color: near(light.color),
      ...(shaping && { shaping: numbers(shaping) }),
    });
    expect((back.lights[i] as LocalLight).motion.kind).toBe(light.motion.kind);
  });
  expect(back.diagnostics).toEqual([]);
});
