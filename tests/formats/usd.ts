import { expect } from 'vitest';
import { packUsdz } from '../../src/formats/usd/write/packUsdz.ts';
import { volume } from '../support/meshes.ts';
import { approximated, type ClaimGroup, type Files, leftOut, read, refused } from './claim.ts';
import { corner, crateFixture, MOVED, ORDER, paths, usd } from './usdKit.ts';
import { materialGroups } from './usdMaterials.ts';
import { shapeGroups } from './usdShapes.ts';

/** The header of a crate file of a version. */
const crate = (minor: number): Uint8Array =>
  Uint8Array.from({ length: 96 }, (_, i) => ('PXR-USDC'.charCodeAt(i) || 0) + (i === 9 ? minor : 0));

/** A package of one file. */
const packageOf = (name: string, text: string): Uint8Array =>
  packUsdz(new Map([[name, new TextEncoder().encode(text)]]));

const BOX = '#usda 1.0\n( defaultPrim = "Box" )\ndef Xform "Box" { def Cube "Side" { double size = 1 } }\n';
const beside = (text: string): Files => ({ ...usd(text), 'box.usda': BOX });

const files: ClaimGroup = {
  title: 'Files and stages',
  rows: [
    read('text (`.usda`, `.usd`), versions 1.x', 'the stage', usd('def Cube "A" {}'), (s) =>
      expect(paths(s)).toEqual(['/A', '/Rest']),
    ),
    read(
      'binary, “crate” (`.usdc`, `.usd`), versions 0.4 to 0.14',
      'the same, to the last bit, as the layer in text',
      { 'a.usdc': crateFixture('written.usdc') },
      (s) => expect(s.objects.length).toBeGreaterThan(0),
    ),
    read(
      '`.usdz`, with layers and pictures of its own',
      'its first layer; any file in a package can be named: `box.usdz[lid.usda]`',
      { 'a.usdz': packageOf('b.usda', usd('def Cube "A" {}')['a.usda'] as string) },
      (s) => expect(paths(s)).toEqual(['/A', '/Rest']),
    ),
    read(
      '`upAxis`, `metersPerUnit`, `timeCodesPerSecond` (or `framesPerSecond`), `startTimeCode`, `endTimeCode`',
      'the axes stay, lengths become metres, times seconds',
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
      '1 unit = 1 cm, as USD has it',
      { 'a.usda': '#usda 1.0\ndef Cube "A" {}' },
      (s) => expect(s.metersPerUnit).toBe(0.01),
      { says: 'usd.units' },
    ),
    read(
      '`customLayerData`’s dictionary `slowlight`',
      'speed of light, title, what to look for, the observer’s velocity, the time to open at',
      {
        'a.usda':
          '#usda 1.0\n( metersPerUnit = 1; customLayerData = { dictionary slowlight = { double speedOfLight = 10; double3 beta = (0, 0, -0.9) } } )\ndef Cube "A" {}',
      },
      (s) => expect(s.hints).toEqual({ speedOfLight: 10, beta: [0, 0, -0.9] }),
    ),
    refused('text of a later version than 1.x', 'with its version', 'usd.version', { 'a.usda': '#usda 2.0\n' }),
    refused('text that is damaged, or not UTF-8', 'with line and column', 'usd.syntax', {
      'a.usda': '#usda 1.0\ndef Cube "A" {',
    }),
    refused('a crate before 0.4', 'with the command that writes it anew', 'usd.version', { 'a.usdc': crate(3) }),
    refused(
      'a crate that is damaged or cut off, array edits, splines of a later version',
      'with place and value, and the command that writes it as text',
      'usd.crate',
      {
        'a.usdc': crateFixture('meshes.usdc').slice(0, 400),
      },
    ),
    refused('units or rates that are not positive numbers', 'with the value', 'usd.metadata', {
      'a.usda': '#usda 1.0\n( metersPerUnit = -1 )\n',
    }),
    refused('a package that is damaged, encrypted or zip64', 'as any zip', 'zip.damaged', {
      'a.usdz': packageOf('b.usda', BOX).slice(0, 100),
    }),
    refused('a package whose files are compressed, or that holds no layer', 'with what to do', 'usd.package', {
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
      'sublayers, with offset and scale',
      'one stage',
      {
        'a.usda': '#usda 1.0\n( metersPerUnit = 1; timeCodesPerSecond = 24; subLayers = [@./b.usda@ (offset = 24)] )\n',
        'b.usda': `#usda 1.0\ndef Cube "A" { ${MOVED}\n${ORDER} }`,
      },
      (s) => expect(corner(s, '/A', 0, 1.5)[0] - corner(s, '/A', 0, 1)[0]).toBeCloseTo(1.5, 4),
    ),
    read(
      'references and payloads, to files, packages and prims, with offsets',
      'what they lead to',
      beside('def "A" ( references = @./box.usda@ ) {}\ndef "B" ( payload = @./box.usda@</Box> ) {}'),
      (s) => expect(paths(s)).toEqual(['/A/Side', '/B/Side', '/Rest']),
    ),
    read(
      'inherits, specializes, with implied classes',
      'opinions in USD’s order of strength',
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
      'the variant that is selected, or chosen: the scene lists them',
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
      'prims where they are moved to',
      {
        'a.usda':
          '#usda 1.0\n( metersPerUnit = 1; relocates = { </A/Side>: </A/Lid> } )\ndef "A" ( references = @./box.usda@ ) {}',
        'box.usda': BOX,
      },
      (s) => expect(paths(s)).toEqual(['/A/Lid']),
    ),
    read(
      'list edits of every qualifier',
      'applied from the weakest layer up',
      beside('def "A" ( delete references = @./gone.usda@; append references = @./box.usda@ ) {}'),
      (s) => expect(paths(s)).toEqual(['/A/Side', '/Rest']),
    ),
    read(
      '`instanceable`',
      'each instance is an object; they share their mesh',
      beside(
        'def "A" ( instanceable = true; references = @./box.usda@ ) {}\ndef "B" ( instanceable = true; references = @./box.usda@ ) {}',
      ),
      (s) => expect(s.objects[0].mesh).toBe(s.objects[1].mesh),
    ),
    read(
      'expressions with `expressionVariables` in asset paths and selections',
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
      'value clips: sets, manifests, templates, times that run, rest, turn and jump',
      'samples',
      {
        ...usd(`def Cube "A" ( ${CLIPS} ) { double3 xformOp:translate\n${ORDER} }`),
        'clip.usda': `#usda 1.0\ndef "A" { ${MOVED} }`,
      },
      (s) => expect(corner(s, '/A', 0, 1)[0] - corner(s, '/A', 0, 0)[0]).toBeCloseTo(3, 4),
    ),
    leftOut(
      'splines',
      'named with prim and attribute; the default value counts',
      'usd.unsupported-arc',
      {
        'a.usda':
          '#usda 1.1\n( metersPerUnit = 1 )\ndef Cube "A" { double size = 1\ndouble size.spline = { 0: 1, 24: 3 } }',
      },
      (s) => expect(volume(s.objects[0].mesh)).toBeCloseTo(1, 5),
    ),
    approximated('an offset or scale of times that cannot be', 'none', 'usd.layer-offset', {
      'a.usda': '#usda 1.0\n( metersPerUnit = 1; subLayers = [@./box.usda@ (scale = 0)] )\n',
      'box.usda': BOX,
    }),
    leftOut(
      'a layer that is not there',
      'named with where it was looked for; it can be dropped on the page',
      'usd.missing-layer',
      usd('def Cube "A" ( references = @./none.usda@ ) {}'),
      (s) => expect(s.diagnostics[0].missing?.lookedFor).toEqual(['none.usda']),
    ),
    leftOut('a layer that is damaged', 'named with what is wrong', 'usd.unreadable-layer', {
      ...usd('def Cube "A" ( references = @./b.usda@ ) {}'),
      'b.usda': 'no',
    }),
    leftOut(
      'an arc to a prim that is not there',
      'named',
      'usd.unresolved-prim',
      usd('def Cube "A" ( references = </None> ) {}'),
    ),
    leftOut('an arc to a layer without a `defaultPrim`', 'named', 'usd.default-prim', {
      ...usd('def Cube "A" ( references = @./b.usda@ ) {}'),
      'b.usda': '#usda 1.0\n',
    }),
    leftOut(
      'a circle of arcs or layers',
      'named; the rest of them counts',
      'usd.cycle',
      usd('def Cube "A" ( references = </A> ) {}'),
    ),
    leftOut(
      'an expression that cannot be evaluated',
      'named with the reason',
      'usd.expression',
      usd('def Cube "A" ( references = @`none(1)`@ ) {}'),
    ),
    leftOut(
      'clips that do not fit together',
      'named with the reason',
      'usd.clips',
      usd(`def Cube "A" ( ${CLIPS.replace('(0, 0)];', '(0, 7)];')} ) {}`),
    ),
    leftOut('relocates that contradict each other', 'named', 'usd.relocates', {
      'a.usda': '#usda 1.0\n( metersPerUnit = 1; relocates = { </A/B>: </A/B/C> } )\ndef "A" { def Cube "B" {} }',
    }),
    leftOut(
      'a variant that is chosen and not there',
      'named with those that are',
      'usd.variant',
      usd('def Cube "A" {}'),
      undefined,
      { variants: new Map([['/A{v}', 'y']]) },
    ),
    leftOut('a prim that is only an `over`', 'named', 'usd.undefined-prim', usd('over Cube "A" {}')),
  ],
};

export const usdGroups: readonly ClaimGroup[] = [files, composition, ...shapeGroups, ...materialGroups];
