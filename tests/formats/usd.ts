import { expect } from 'vitest';
import { packUsdz } from '../../src/formats/usd/write/packUsdz.ts';
import { vertexPosition } from '../../src/scene/motion/motion.ts';
import { volume } from '../support/meshes.ts';
import { approximated, type ClaimGroup, type Files, leftOut, read, refused } from './claim.ts';
import { C, corner, crateFixture, MOVED, ORDER, paths, usd } from './usdKit.ts';
import { materialGroups } from './usdMaterials.ts';
import { shapeGroups } from './usdShapes.ts';

/** The header of a crate file of a version. */
const crate = (minor: number): Uint8Array =>
  Uint8Array.from({ length: 96 }, (_, i) => ('PXR-USDC'.charCodeAt(i) || 0) + (i === 9 ? minor : 0));

/** A package of one file. */
const packageOf = (name: string, text: string): Uint8Array =>
  packUsdz(new Map([[name, new TextEncoder().encode(text)]]));

const inner = packageOf('b.usda', usd('def Cube "A" {}')['a.usda'] as string);

const BOX = '#usda 1.0\n( defaultPrim = "Box" )\ndef Xform "Box" { def Cube "Side" { double size = 1 } }\n';
const beside = (text: string): Files => ({ ...usd(text), 'box.usda': BOX });

const files: ClaimGroup = {
  title: 'Files and stages',
  rows: [
    read('text (`.usda`, `.usd`), versions 1.x', 'the stage', usd('def Cube "A" {}'), (s) =>
      expect(paths(s)).toEqual(['/A', '/Rest']),
    ),
    read(
      'former names of types (`Vec3f`, `PointFloat`, `Transform` …), and asset paths in quotes',
      'as their successors, and as paths',
      {
        'a.usda': `#usda 1.0
( metersPerUnit = 1 )
def Cube "A" {
  Vec3d xformOp:translate = (1, 2, 3)
  asset picture = "./a.png"
  uniform token[] xformOpOrder = ["xformOp:translate"]
}`,
      },
      (s) => expect(vertexPosition(s.objects[0], 0, 0, C).map((x, i) => Math.abs(x - 1 - i))).toEqual([1, 1, 1]),
    ),
    read(
      'binary “crate” files (`.usdc`, `.usd`), versions 0.4 to 0.15',
      'bit for bit the same as the text layer',
      { 'a.usdc': crateFixture('written.usdc') },
      (s) => expect(s.objects.length).toBeGreaterThan(0),
    ),
    read(
      '`.usdz`, with the layers and pictures it contains',
      'its first layer, also of a package in it; any file in a package can be addressed, as in `box.usdz[lid.usda]`',
      [{ 'a.usdz': inner }, { 'a.usdz': packUsdz(new Map([['b.usdz', inner]])) }],
      (s) => expect(paths(s)).toEqual(['/A', '/Rest']),
    ),
    read(
      '`upAxis`, `metersPerUnit`, `timeCodesPerSecond` (or `framesPerSecond`), `startTimeCode`, `endTimeCode` (or `startFrame`, `endFrame`)',
      'axes are kept, lengths are converted to metres and times to seconds',
      {
        'a.usda':
          '#usda 1.0\n( upAxis = "Z"; metersPerUnit = 0.5; timeCodesPerSecond = 10; endTimeCode = 20 )\ndef Cube "A" {}',
      },
      (s) => {
        expect([s.upAxis, s.metersPerUnit, s.endTime]).toEqual(['Z', 0.5, 2]);
        expect(volume(s.objects[0].mesh)).toBeCloseTo(1, 6);
      },
    ),
    read(
      'no `metersPerUnit`',
      '1 unit = 1 cm, the default of USD',
      { 'a.usda': '#usda 1.0\ndef Cube "A" {}' },
      (s) => expect(s.metersPerUnit).toBe(0.01),
      { says: 'usd.units' },
    ),
    read(
      '`customLayerData`’s dictionary `slowlight`',
      'speed of light, title, what to look for, the observer’s velocity, the initial time',
      {
        'a.usda':
          '#usda 1.0\n( metersPerUnit = 1; customLayerData = { dictionary slowlight = { double speedOfLight = 10; double3 beta = (0, 0, -0.9) } } )\ndef Cube "A" {}',
      },
      (s) => expect(s.hints).toEqual({ speedOfLight: 10, beta: [0, 0, -0.9] }),
    ),
    refused('text of a version later than 1.x', 'with its version', 'usd.version', { 'a.usda': '#usda 2.0\n' }),
    refused('text that is damaged or not UTF-8', 'with line and column', 'usd.syntax', {
      'a.usda': '#usda 1.0\ndef Cube "A" {',
    }),
    refused('a crate before 0.4', 'with the command that rewrites it', 'usd.version', { 'a.usdc': crate(3) }),
    refused(
      'a damaged or truncated crate, array edits, splines of a later version',
      'with location, value and the command that converts it to text',
      'usd.crate',
      {
        'a.usdc': crateFixture('meshes.usdc').slice(0, 400),
      },
    ),
    refused('units or rates that are not positive numbers', 'with the value', 'usd.metadata', {
      'a.usda': '#usda 1.0\n( metersPerUnit = -1 )\n',
    }),
    refused('a damaged, encrypted or zip64 package', 'as for any zip', 'zip.damaged', {
      'a.usdz': packageOf('b.usda', BOX).slice(0, 100),
    }),
    refused('a package with compressed files, or without a layer', 'with what to do', 'usd.package', {
      'a.usdz': packageOf('b.png', BOX),
    }),
  ],
};

const CLIPS = `clips = { dictionary default = { asset[] assetPaths = [@./clip.usda@]; string primPath = "/A"
  double2[] active = [(0, 0)]; double2[] times = [(0, 0), (24, 24)] } }`;

const composition: ClaimGroup = {
  title: 'Composition',
  rows: [
    read(
      'sublayers, with time offset and scale',
      'composed into one stage',
      {
        'a.usda': '#usda 1.0\n( metersPerUnit = 1; timeCodesPerSecond = 24; subLayers = [@./b.usda@ (offset = 24)] )\n',
        'b.usda': `#usda 1.0\ndef Cube "A" { ${MOVED}\n${ORDER} }`,
      },
      (s) => expect(corner(s, '/A', 0, 1.5)[0] - corner(s, '/A', 0, 1)[0]).toBeCloseTo(1.5, 4),
    ),
    read(
      'references and payloads to files, packages and prims, with time offsets',
      'their targets',
      beside('def "A" ( references = @./box.usda@ ) {}\ndef "B" ( payload = @./box.usda@</Box> ) {}'),
      (s) => expect(paths(s)).toEqual(['/A/Side', '/B/Side', '/Rest']),
    ),
    read(
      'inherits, specializes, with implied classes',
      'opinions in USD’s strength order',
      usd(
        'class "C" { double size = 3 }\ndef Cube "A" ( inherits = </C> ) {}\ndef Cube "B" ( specializes = </C> ) { double size = 1 }',
      ),
      (s) =>
        expect(['/A', '/B'].map((p) => volume(s.objects.find((o) => o.path === p)!.mesh))).toEqual([
          expect.closeTo(27, 4),
          expect.closeTo(1, 5),
        ]),
    ),
    read(
      'variant sets',
      'the selected variant, or the one the user chooses; the scene lists all',
      usd(
        'def "A" ( variants = { string v = "x" }; prepend variantSets = "v" ) { variantSet "v" = { "x" { def Cube "X" {} } "y" { def Cube "Y" {} } } }',
      ),
      (s) => {
        expect(s.variants).toEqual([{ set: '/A{v}', options: ['x', 'y'], chosen: 'y' }]);
        expect(paths(s)).toEqual(['/A/Y', '/Rest']);
      },
      { options: { variants: new Map([['/A{v}', 'y']]) } },
    ),
    read(
      'relocates',
      'prims at their new paths',
      {
        'a.usda':
          '#usda 1.0\n( metersPerUnit = 1; relocates = { </A/Side>: </A/Lid> } )\ndef "A" ( references = @./box.usda@ ) {}',
        'box.usda': BOX,
      },
      (s) => expect(paths(s)).toEqual(['/A/Lid']),
    ),
    read(
      'list edits with every qualifier',
      'applied from the weakest layer up',
      beside('def "A" ( delete references = @./gone.usda@; append references = @./box.usda@ ) {}'),
      (s) => expect(paths(s)).toEqual(['/A/Side', '/Rest']),
    ),
    read(
      '`instanceable`',
      'each instance is an object; instances share their mesh',
      beside(
        'def "A" ( instanceable = true; references = @./box.usda@ ) {}\ndef "B" ( instanceable = true; references = @./box.usda@ ) {}',
      ),
      (s) => expect(s.objects[0].mesh).toBe(s.objects[1].mesh),
    ),
    read(
      'expressions with `expressionVariables` in asset paths and variant selections',
      'evaluated',
      {
        'a.usda': `#usda 1.0
( metersPerUnit = 1; expressionVariables = { string N = "box" } )
def "A" ( references = @\`"./\${N}.usda"\`@ ) {}`,
        'box.usda': BOX,
      },
      (s) => expect(paths(s)).toEqual(['/A/Side']),
    ),
    read(
      'value clips: sets, manifests, templates, clip times that advance, hold, reverse and jump',
      'time samples',
      {
        ...usd(`def Cube "A" ( ${CLIPS} ) { double3 xformOp:translate\n${ORDER} }`),
        'clip.usda': `#usda 1.0\ndef "A" { ${MOVED} }`,
      },
      (s) => expect(corner(s, '/A', 0, 1)[0] - corner(s, '/A', 0, 0)[0]).toBeCloseTo(3, 4),
    ),
    leftOut(
      'splines',
      'reported with prim and attribute; the default value is used',
      'usd.unsupported-arc',
      {
        'a.usda':
          '#usda 1.1\n( metersPerUnit = 1 )\ndef Cube "A" { double size = 1\ndouble size.spline = { 0: 1, 24: 3 } }',
      },
      (s) => expect(volume(s.objects[0].mesh)).toBeCloseTo(1, 5),
    ),
    approximated('an invalid time offset or scale', 'no offset or scale', 'usd.layer-offset', {
      'a.usda': '#usda 1.0\n( metersPerUnit = 1; subLayers = [@./box.usda@ (scale = 0)] )\n',
      'box.usda': BOX,
    }),
    leftOut(
      'a missing layer',
      'reported with the places that were searched, more than three in one line with their count; the file can be dropped on the page. A stage of which nothing is left (`usd.empty-stage`) is an error: `render` writes no picture and exits with 3',
      'usd.missing-layer',
      usd('def Cube "A" ( references = @./none.usda@ ) {}'),
      (s) => expect(s.diagnostics[0].missing?.lookedFor).toEqual(['none.usda']),
    ),
    leftOut('a damaged layer', 'reported with the reason', 'usd.unreadable-layer', {
      ...usd('def Cube "A" ( references = @./b.usda@ ) {}'),
      'b.usda': 'no',
    }),
    leftOut(
      'an arc to a missing prim',
      'reported',
      'usd.unresolved-prim',
      usd('def Cube "A" ( references = </None> ) {}'),
    ),
    leftOut('an arc to a layer without a `defaultPrim`', 'reported', 'usd.default-prim', {
      ...usd('def Cube "A" ( references = @./b.usda@ ) {}'),
      'b.usda': '#usda 1.0\n',
    }),
    leftOut(
      'a cycle of arcs or layers',
      'reported; the other arcs or layers apply',
      'usd.cycle',
      usd('def Cube "A" ( references = </A> ) {}'),
    ),
    leftOut(
      'an expression that cannot be evaluated',
      'reported with the reason',
      'usd.expression',
      usd('def Cube "A" ( references = @`none(1)`@ ) {}'),
    ),
    leftOut(
      'inconsistent clips',
      'reported with the reason',
      'usd.clips',
      usd(`def Cube "A" ( ${CLIPS.replace('(0, 0)];', '(0, 7)];')} ) {}`),
    ),
    leftOut('relocates that contradict each other', 'reported', 'usd.relocates', {
      'a.usda': '#usda 1.0\n( metersPerUnit = 1; relocates = { </A/B>: </A/B/C> } )\ndef "A" { def Cube "B" {} }',
    }),
    leftOut(
      'a chosen variant that does not exist',
      'reported with those that exist',
      'usd.variant',
      usd('def Cube "A" {}'),
      undefined,
      { variants: new Map([['/A{v}', 'y']]) },
    ),
    leftOut('a prim that is only declared as an `over`', 'reported', 'usd.undefined-prim', usd('over Cube "A" {}')),
  ],
};

export const usdGroups: readonly ClaimGroup[] = [files, composition, ...shapeGroups, ...materialGroups];
