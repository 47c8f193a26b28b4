import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { add, build, connect, edited, set } from '../../../tests/support/graphKit.ts';
import { saying } from '../../../tests/support/inWords.ts';
import { hasUsdCore, python } from '../../../tests/support/pythonOracles.ts';
import { inputError } from '../../formats/diagnostics/inputError.ts';
import { memorySource } from '../../formats/files/fileSource.ts';
import { openScene } from '../../formats/open.ts';
import { Evaluator } from '../../graph/evaluation/evaluator.ts';
import { msg } from '../../messages/message.ts';
import { InputError } from '../../scene/types.ts';
import { nodeLibrary } from '../library.ts';
import { exportSceneFile } from '../project/exportSceneFile.ts';
import type { SceneOutput } from '../project/outputFiles.ts';
import { type Services, workerServices } from '../services.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-stage-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** In centimetres, its world moved by 2 m along x and turned by 90° about y; a red material is bound to it. */
const STAGE = `#usda 1.0
( defaultPrim = "World"
  endTimeCode = 48
  metersPerUnit = 0.01
  startTimeCode = 0
  timeCodesPerSecond = 24
  upAxis = "Y"
)
def Scope "Looks" {
  def Material "Red" {
    token outputs:surface.connect = </Looks/Red/S.outputs:surface>
    def Shader "S" { uniform token info:id = "UsdPreviewSurface"
      color3f inputs:diffuseColor = (1, 0, 0)
      token outputs:surface
    }
  }
}
def Xform "World" (prepend apiSchemas = ["MaterialBindingAPI"]) {
  rel material:binding = </Looks/Red>
  double3 xformOp:translate = (200, 0, 0)
  float xformOp:rotateY = 90
  uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateY"]
  def Xform "Car" {
    double3 xformOp:translate = (0, 0, 100)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    def Cube "Body" {
      double size = 100
    }
    def Sphere "Wheel" {
      double radius = 25
    }
  }
  def Cube "Carriage" {
      double size = 100
    }
  def SphereLight "Lamp" {}
}
`;
const FILES: Readonly<Record<string, string>> = {
  'stage.usda': STAGE,
  'shot.usda': '#usda 1.0\n(\n  subLayers = [@./stage.usda@]\n)\n',
};
const services: Services = {
  ...workerServices,
  readFile: async (name) => {
    const text = FILES[name.replace(/^\.\//, '')];
    if (text === undefined) throw inputError('file.missing', name, msg`no`);
    return new TextEncoder().encode(text);
  },
};

const project = build(
  ...[add('box', 'box'), add('move', 'transform'), add('paint', 'material'), add('usd', 'write-usd')],
  { kind: 'set-param', node: 'move', param: 'position', value: [1, 2, 3] },
  ...[set('usd', 'name', 'out.usda'), set('usd', 'prim', '/World/geom/geometry'), set('usd', 'into', 'stage.usda')],
  ...[connect('box.geometry', 'move.geometry'), connect('move.geometry', 'paint.geometry')],
  connect('paint.geometry', 'usd.geometry'),
);
const evaluated = async (document: typeof project) =>
  (await new Evaluator(nodeLibrary).evaluate(document, 'usd', services)).target;

/** Writes what the node asks for beside the stage; returns the file's path. */
async function written(document: typeof project, name: string): Promise<string> {
  const target = await evaluated(document);
  if (target.status !== 'done') throw new Error(JSON.stringify(target));
  const { files } = await exportSceneFile(target.outputs.file as SceneOutput, name);
  for (const [path, text] of Object.entries(FILES)) writeFileSync(join(folder, path), text);
  for (const [path, bytes] of files) writeFileSync(join(folder, path), bytes);
  return join(folder, name);
}

const described = (file: string) =>
  JSON.parse(
    python(
      '-c',
      `
import json
from pxr import Usd, UsdGeom, UsdShade
stage = Usd.Stage.Open(r'${file}')
mesh = UsdGeom.Mesh(stage.GetPrimAtPath('/World/geom/geometry/Box'))
m = UsdGeom.Xformable(mesh).ComputeLocalToWorldTransform(0)
points = [list(m.Transform(p)) for p in mesh.GetPointsAttr().Get(0)]
material = UsdShade.MaterialBindingAPI(mesh.GetPrim()).ComputeBoundMaterial()[0]
print(json.dumps({
  'center': [sum(p[k] for p in points) / len(points) for k in range(3)],
  'car': list(UsdGeom.Xformable(stage.GetPrimAtPath('/World/Car')).ComputeLocalToWorldTransform(0).ExtractTranslation()),
  'world': stage.GetPrimAtPath('/World').GetTypeName(), 'default': str(stage.GetDefaultPrim().GetPath()),
  'material': str(material.GetPath()), 'end': stage.GetEndTimeCode(), 'unit': UsdGeom.GetStageMetersPerUnit(stage),
  'payload': stage.GetPrimAtPath('/World/geom/geometry').HasAuthoredPayloads(),
}))`,
    ),
  );

describe.skipIf(!hasUsdCore())('geometry written into a stage, read by usd-core', () => {
  it.each(['sublayer', 'payload'])('as %s: beside what is there, and moved with its parent', async (arc) => {
    const found = described(await written(edited(project, set('usd', 'arc', arc)), 'out.usda'));
    // (1, 2, 3) m turned about y: (3, 2, −1) m, then 2 m along x; in centimetres.
    for (const [k, x] of [500, 200, -100].entries()) expect(found.center[k]).toBeCloseTo(x, 2);
    expect(found).toMatchObject({
      ...{ world: 'Xform', default: '/World', end: 48, unit: 0.01, payload: arc === 'payload' },
      material: '/World/geom/geometry/Materials/paint',
    });
    expect(found.car[0]).toBeCloseTo(300, 6);
  });

  it('a prim path is read with what it inherits from above', async () => {
    const scene = await openScene(memorySource({ 'stage.usda': new TextEncoder().encode(STAGE) }), 'stage.usda', {
      prim: '/World/Car',
    });
    expect(scene.objects.map(({ path }) => path)).toEqual(['/World/Car/Body', '/World/Car/Wheel']);
    expect(scene.lights).toEqual([]);
    writeFileSync(join(folder, 'stage.usda'), STAGE);
    const place: number[] = JSON.parse(
      python(
        '-c',
        `
import json
from pxr import Usd, UsdGeom
stage = Usd.Stage.Open(r'${join(folder, 'stage.usda')}')
print(json.dumps(list(UsdGeom.Xformable(stage.GetPrimAtPath('/World/Car/Wheel')).ComputeLocalToWorldTransform(0).ExtractTranslation())))`,
      ),
    );
    const wheel = scene.objects[1]!;
    if (wheel.motion.kind !== 'static') throw new Error('it moves');
    for (const [k, x] of wheel.motion.pose.position.entries()) expect(x).toBeCloseTo(place[k]! / 100, 6);
    expect(scene.materials[wheel.mesh.groups[0]!.material]!.baseColor).toEqual([1, 0, 0]);
  });
});

it('a stage among the files of the page is named as it will be beside the result', async () => {
  const onPage: Services = {
    ...services,
    readFile: (name) => services.readFile(name.startsWith('local:1/set/') ? name.slice('local:1/set/'.length) : ''),
  };
  const into = (path: string) =>
    new Evaluator(nodeLibrary).evaluate(
      edited(project, set('usd', 'into', 'local:1/set/shot.usda'), set('usd', 'prim', path)),
      ...(['usd', onPage] as const),
    );
  expect((await into('/World/geom/geometry')).target).toMatchObject({
    outputs: {
      file: { stage: { text: expect.stringContaining('subLayers = [@./shot.usda@, @./out.geometry.usdc@]') } },
    },
  });
  expect((await into('/World/Car')).target).toMatchObject({ problem: { place: 'shot.usda' } });
});

it('the speed of light that the stage suggests holds, else that of the geometry', async () => {
  const suggesting = STAGE.replace(
    'endTimeCode',
    'customLayerData = { dictionary slowlight = { double speedOfLight = 30 } }\n  endTimeCode',
  );
  for (const [stage, expected] of [
    [STAGE, 10],
    [suggesting, 30],
  ] as const) {
    const readFile = async () => new TextEncoder().encode(stage);
    const { target } = await new Evaluator(nodeLibrary).evaluate(
      edited(project, set('usd', 'speedOfLight', 10)),
      'usd',
      {
        ...services,
        readFile,
      },
    );
    if (target.status !== 'done') throw new Error(JSON.stringify(target));
    const { files } = await exportSceneFile(target.outputs.file as SceneOutput, 'out.usda');
    const all = { ...Object.fromEntries(files), 'stage.usda': await readFile() };
    expect((await openScene(memorySource(all), 'out.usda')).hints.speedOfLight).toBe(expected);
  }
});

describe('nothing is overwritten:', () => {
  it.each([
    ['/World/Car', 'usd.prim-exists', /there is a prim \/World\/Car already/],
    ['/World/Car/Body', 'usd.prim-exists', /choose another path/],
    ['World', 'usd.prim-path', /is no path of a prim; write one like/],
    ['', 'usd.prim-path', /is no path of a prim/],
  ])('%s', async (path, code, message) => {
    for (const into of ['stage.usda', 'shot.usda'])
      expect(await evaluated(edited(project, set('usd', 'prim', path), set('usd', 'into', into)))).toMatchObject({
        ...{ status: 'failed', problem: { code, message: saying(message) } },
      });
  });

  it('the stage has to be there, and its axes those of the geometry', async () => {
    expect(await evaluated(edited(project, set('usd', 'into', 'other.usda')))).toMatchObject({
      problem: { code: 'file.missing' },
    });
    const made = await evaluated(edited(project, set('usd', 'name', 'out.usdc')));
    expect(made).toMatchObject({ problem: { code: 'file.name' } });
    const same = await evaluated(edited(project, set('usd', 'name', 'stage.usda')));
    expect(same).toMatchObject({ problem: { code: 'usd.stage', message: saying(/would overwrite stage\.usda/) } });
  });
});

describe('a prim path without anything', () => {
  const stage = memorySource({
    'stage.usda': new TextEncoder().encode(STAGE),
    'a.obj': new TextEncoder().encode('o A\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'),
  });
  it.each([
    ['stage.usda', '/World/Cars', /no prim \/World\/Cars; below \/World there is Car/],
    ['stage.usda', '/Looks/Red', /nothing to be seen/],
    ['a.obj', '/B', /nothing at \/B; there is \/A/],
  ])('%s %s', async (file, prim, message) => {
    await expect(openScene(stage, file, { prim })).rejects.toThrow(InputError);
    await expect(openScene(stage, file, { prim })).rejects.toThrow(message);
  });
});
