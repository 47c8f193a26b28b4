import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { memorySource } from '../../src/formats/files/fileSource.ts';
import { writeExr } from '../../src/formats/image/exr.ts';
import { readUsd } from '../../src/formats/usd/read.ts';
import { writeTextures, writeUsda } from '../../src/formats/usd/write/writeUsd.ts';
import { random } from '../../src/math/random.ts';
import { normalize, scale, type Vec3 } from '../../src/math/vec3.ts';
import { skyOf } from '../../src/reference/lights/sky.ts';
import { rgbSensor } from '../../src/reference/spectral/rgbSensor.ts';
import type { Scene } from '../../src/scene/types.ts';
import { hasUsdCore, python } from '../support/pythonOracles.ts';

const available = hasUsdCore();
const folder = mkdtempSync(join(tmpdir(), 'slowlight-domes-'));
afterAll(() => rmSync(folder, { recursive: true }));

/** The linear sRGB of the sky in a direction. */
function skyIn(scene: Scene, n: Vec3): Vec3 {
  const { context: sight, color } = rgbSensor('approximate', { dopplerMix: 0, beaming: 1 });
  return color(skyOf(scene, []).radiance(n, sight));
}

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);

/** A float image whose colours are a function of the pixel. */
const exr = (width: number, height: number, color: (column: number, row: number) => Vec3): Uint8Array =>
  writeExr({
    width,
    height,
    channels: ['R', 'G', 'B'].map((name, k) => ({
      name,
      type: 'float',
      data: Float32Array.from({ length: width * height }, (_, i) => color(i % width, Math.floor(i / width))[k]),
    })),
  });

const open = (text: string, picture: Uint8Array): Promise<Scene> =>
  readUsd(memorySource({ 'a.usda': bytes(text), 'sky.exr': picture }), 'a.usda');

const [W, H] = [16, 8];

/** The direction of a pixel by UsdLux (schema.usda, DomeLight and DomeLight_1), transformed to the world by usd-core's matrices. */
const SCRIPT = `
import json, math, sys
from pxr import Gf, Usd, UsdGeom, UsdLux
W, H = [int(a) for a in sys.argv[1:3]]
out = []
for path, column, row in json.loads(sys.argv[3]):
    longitude = math.pi * (1 - 2 * (column + 0.5) / W)
    latitude = math.pi * (0.5 - (row + 0.5) / H)
    stage = Usd.Stage.Open(path)
    prim = stage.GetPrimAtPath('/World/Sky')
    pole = 'Y'
    if prim.IsA(UsdLux.DomeLight_1):
        pole = UsdLux.DomeLight_1(prim).GetPoleAxisAttr().Get()
        if pole == 'scene': pole = UsdGeom.GetStageUpAxis(stage)
    level, up = math.cos(latitude), math.sin(latitude)
    x, middle = level * math.sin(longitude), level * math.cos(longitude)
    local = Gf.Vec3d(x, up, middle) if pole == 'Y' else Gf.Vec3d(x, -middle, up)
    n = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(0).TransformDir(local).GetNormalized()
    out.append(list(n))
print(json.dumps(out))
`;

const STAGES = [
  ['Y', 'DomeLight', ''],
  ['Z', 'DomeLight', ''],
  ['Y', 'DomeLight_1', ''],
  ['Z', 'DomeLight_1', ''],
  ['Z', 'DomeLight_1', 'uniform token poleAxis = "Y"'],
  ['Y', 'DomeLight_1', 'uniform token poleAxis = "Z"'],
] as const;

const stage = (up: string, type: string, more: string, turn: readonly number[], scales: string): string => `#usda 1.0
( upAxis = "${up}" )
def Xform "World"
{
    float3 xformOp:rotateXYZ = (${turn.map((x) => x / 2).join(', ')})
    double3 xformOp:translate = (3, 4, 5)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateXYZ"]
    def ${type} "Sky"
    {
        asset inputs:texture:file = @sky.exr@
        ${more}
        float3 xformOp:rotateXYZ = (${turn.join(', ')})
        float3 xformOp:scale = ${scales}
        uniform token[] xformOpOrder = ["xformOp:rotateXYZ", "xformOp:scale"]
    }
}
`;

/** Stages with rotated, scaled and mirrored domes, and the one pixel of each that is not black. */
const numbers = random(7);
const cases = STAGES.flatMap(([up, type, more], i) =>
  ['(1, 1, 1)', '(2, 2, 2)', '(-1, 1, 1)', '(1, -1, 1)'].map((scales, k) => ({
    title: `${up} up, ${type} ${more}, scale ${scales}`,
    path: join(folder, `${i}-${k}.usda`),
    pixel: [Math.floor(W * numbers()), Math.floor(H * numbers())],
    text: stage(
      up,
      type,
      more,
      [0, 0, 0].map(() => Math.round(360 * numbers())),
      scales,
    ),
  })),
);

/** The world directions of those pixels. */
function saidByUsd(): readonly Vec3[] {
  for (const { path, text } of cases) writeFileSync(path, text);
  const asked = cases.map(({ path, pixel }) => [path, ...pixel]);
  return JSON.parse(python('-c', SCRIPT, `${W}`, `${H}`, JSON.stringify(asked)));
}

describe.runIf(available)('a dome’s pixel is in the direction given by UsdLux and the matrices of usd-core', () => {
  const said = available ? saidByUsd() : [];

  it.each(cases.map((one, i) => [one.title, one, i] as const))('%s', async (_, { pixel, text }, i) => {
    const scene = await open(
      text,
      exr(W, H, (x, y) => (x === pixel[0] && y === pixel[1] ? [4, 2, 1] : [0, 0, 0])),
    );
    const seen = skyIn(scene, said[i]);
    for (const [k, value] of [4, 2, 1].entries()) expect(seen[k]).toBeCloseTo(value, 4);
    // Also after writing and reading back.
    const written = { 'b.usda': bytes(writeUsda(scene)), ...Object.fromEntries(writeTextures(scene)) };
    const again = await readUsd(memorySource(written), 'b.usda');
    expect(skyIn(again, said[i])).toEqual(seen.map((x) => expect.closeTo(x, 9)));
  });
});

const SIZE = 96;
const code = (n: Vec3): Vec3 => [(n[0] + 1) / 2, (n[1] + 1) / 2, (n[2] + 1) / 2];
/** Position relative to the centre of a square image, in half sides, x to the right and y up. */
const offset = (column: number, row: number): readonly [number, number] => [
  (2 * (column + 0.5)) / SIZE - 1,
  1 - (2 * (row + 0.5)) / SIZE,
];

const BALLS = {
  /** The ray (0, 0, −1) meets the unit ball at the normal (x, y, √(1 − x² − y²)) and leaves it as d − 2(d·n) n. */
  mirroredBall: (x: number, y: number): Vec3 => {
    const z = Math.sqrt(Math.max(1 - x * x - y * y, 0));
    return [2 * z * x, 2 * z * y, 2 * z * z - 1];
  },
  /** The angle from +Z is π times the distance from the middle. */
  angular: (x: number, y: number): Vec3 => {
    const [theta, phi] = [Math.PI * Math.hypot(x, y), Math.atan2(y, x)];
    return [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];
  },
};

describe.each(['mirroredBall', 'angular'] as const)('%s', (format) => {
  const picture = exr(SIZE, SIZE, (column, row) => code(BALLS[format](...offset(column, row))));
  const text = `#usda 1.0\ndef DomeLight "Sky"\n{\n    asset inputs:texture:file = @sky.exr@\n    token inputs:texture:format = "${format}"\n}\n`;

  it('shows every direction where the image projection has it', async () => {
    const scene = await open(text, picture);
    const numbers = random(3);
    for (let i = 0; i < 200; i++) {
      const n = normalize([numbers() - 0.5, numbers() - 0.5, 1.2 * numbers() - 0.5]);
      // Directions behind the ball are compressed at its rim.
      if (n[2] < -0.8) continue;
      const decoded = scale(skyIn(scene, n), 2).map((x) => x - 1) as unknown as Vec3;
      for (let k = 0; k < 3; k++) expect(Math.abs(decoded[k] - n[k]), `${n}`).toBeLessThan(0.02);
    }
  });
});
