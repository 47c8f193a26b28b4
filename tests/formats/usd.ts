import { readFileSync } from 'node:fs';
import { expect } from 'vitest';
import { packUsdz } from '../../src/formats/usd/writeZip.ts';
import { vertexPosition } from '../../src/scene/motion.ts';
import { volume } from '../support/meshes.ts';
import { approximated, type Files, type Group, leftOut, read, refused } from './row.ts';
import { C, corner, def, FACE, paths, RED, usd } from './usdKit.ts';
import { lookGroups } from './usdLooks.ts';

const fixture = (name: string): Uint8Array =>
  new Uint8Array(readFileSync(new URL(`../../src/formats/usd/crate/fixtures/${name}`, import.meta.url)));

/** The first bytes of a crate of a version. */
const crate = (minor: number): Uint8Array =>
  Uint8Array.from({ length: 96 }, (_, i) => ('PXR-USDC'.charCodeAt(i) || 0) + (i === 9 ? minor : 0));

const package_ = (name: string, text: string): Uint8Array =>
  packUsdz(new Map([[name, new TextEncoder().encode(text)]]));

const BOX = '#usda 1.0\n( defaultPrim = "Box" )\ndef Xform "Box" { def Cube "Side" { double size = 1 } }\n';
const beside = (text: string): Files => ({ ...usd(text), 'box.usda': BOX });

const files: Group = {
  title: 'Files and stages',
  rows: [
    read('text (`.usda`, `.usd`), versions 1.x', 'the stage', usd('def Cube "A" {}'), (s) =>
      expect(paths(s)).toEqual(['/A', '/Rest']),
    ),
    read(
      'binary, “crate” (`.usdc`, `.usd`), versions 0.4 to 0.14',
      'the same, to the last bit, as the layer in text',
      { 'a.usdc': fixture('written.usdc') },
      (s) => expect(s.objects.length).toBeGreaterThan(0),
    ),
    read(
      '`.usdz`, with layers and pictures of its own',
      'its first layer; any file in a package can be named: `box.usdz[lid.usda]`',
      { 'a.usdz': package_('b.usda', usd('def Cube "A" {}')['a.usda'] as string) },
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
        'a.usdc': fixture('meshes.usdc').slice(0, 400),
      },
    ),
    refused('a package that is damaged, compressed, encrypted or zip64', 'with what to do', 'usd.package', {
      'a.usdz': package_('b.usda', BOX).slice(0, 100),
    }),
  ],
};

const CLIPS = `clips = { dictionary default = { asset[] assetPaths = [@./clip.usda@]; string primPath = "/A"
  double2[] active = [(0, 0)]; double2[] times = [(0, 0), (24, 24)] } }`;
const MOVED = 'double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 24: (3, 0, 0) }';
const ORDER = 'uniform token[] xformOpOrder = ["xformOp:translate"]';

const composition: Group = {
  title: 'Composition',
  rows: [
    read(
      'sublayers, with offset and scale; muted, ordered',
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

const motion: Group = {
  title: 'Placement and motion',
  rows: [
    read(
      'all transform ops, `!invert!`, `!resetXformStack!`',
      'where things are',
      usd(
        `def Xform "X" { double3 xformOp:translate = (9, 0, 0)\n${ORDER}
       def Cube "A" { double3 xformOp:translate = (1, 2, 3)\nuniform token[] xformOpOrder = ["!resetXformStack!", "!invert!xformOp:translate"] } }`,
      ),
      (s) => {
        const { motion: m } = s.objects[0];
        expect(m.kind === 'static' && m.pose.position).toEqual([-1, -2, -3]);
      },
    ),
    read(
      'time samples of transforms',
      'rigid motion; linear between samples, quaternions along the arc',
      usd(`def Cube "A" { ${MOVED}\n${ORDER} }`),
      (s) => {
        expect(s.objects[0].motion.kind).toBe('sampled');
        expect(corner(s, '/A', 0, 0.5)[0] - corner(s, '/A', 0, 0)[0]).toBeCloseTo(1.5, 4);
      },
    ),
    read(
      'time-sampled scale, shear or `points` (and `normals`)',
      'a path for each vertex',
      usd(
        def(
          'Mesh',
          FACE.replace('points =', 'points.timeSamples = { 0:').replace(
            '(0, 1, 0)]',
            '(0, 1, 0)], 24: [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)] }',
          ),
        ),
      ),
      (s) => {
        expect(s.objects[0].motion.kind).toBe('sampled-points');
        expect(corner(s, '/A', 0, 0.5)[2]).toBeCloseTo(0.5, 6);
      },
    ),
    read(
      '`slowlight:motion = "uniform"` or `"hyperbolic"`',
      'exact motion for all times',
      usd(def('Cube', 'token slowlight:motion = "uniform"\nvector3d slowlight:velocity = (2, 0, 0)')),
      (s) => expect(s.objects[0].motion).toMatchObject({ kind: 'uniform', velocity: [2, 0, 0] }),
    ),
    read(
      '`slowlight:birth`, `slowlight:death`, `slowlight:authoredIn`',
      'when it is there; whose shape is written',
      usd(def('Cube', 'double slowlight:birth = 1\ntoken slowlight:authoredIn = "rest"')),
      (s) =>
        expect(s.objects[0]).toMatchObject({
          lifetime: { birth: 1, death: Number.POSITIVE_INFINITY },
          authoredIn: 'rest',
        }),
    ),
    read(
      '`visibility`, `active`, `purpose`',
      'what is invisible, inactive, `proxy` or `guide` is not shown',
      usd(
        'def Cube "A" { token visibility = "invisible" }\ndef Cube "B" ( active = false ) {}\ndef Cube "C" { uniform token purpose = "proxy" }',
      ),
      (s) => expect(paths(s)).toEqual(['/Rest']),
    ),
    approximated(
      '`visibility` that changes with time',
      'held at the start',
      'usd.animated-visibility',
      usd(def('Cube', 'token visibility.timeSamples = { 0: "inherited", 9: "invisible" }')),
      (s) => expect(paths(s)).toContain('/A'),
    ),
    approximated(
      'a path that turns too fast between its samples to be followed',
      'as near as is affordable; samples wanted and error are told',
      'usd.resampling',
      usd(
        def(
          'Cube',
          'double xformOp:rotateZ.timeSamples = { 0: 0, 1: 1e9 }\nuniform token[] xformOpOrder = ["xformOp:rotateZ"]',
        ),
      ),
    ),
    leftOut('an op that `xformOpOrder` names and the prim has not', 'named', 'usd.xform-op', usd(def('Cube', ORDER))),
    leftOut(
      '`slowlight:` attributes that contradict each other or are not known',
      'named',
      'usd.slowlight',
      usd(def('Cube', 'token slowlight:motion = "sideways"')),
    ),
  ],
};

const PYRAMID = `int[] faceVertexCounts = [3, 3, 3, 3]; int[] faceVertexIndices = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]`;

const unseen = (type: string, hint = ''): ReturnType<typeof leftOut> =>
  leftOut(`\`${type}\``, `named${hint}`, 'usd.unsupported-prim', usd(def(type)), (s) =>
    expect(paths(s)).toEqual(['/Rest']),
  );

const geometry: Group = {
  title: 'Shapes',
  rows: [
    read(
      '`Mesh`: polygons, also concave, holes, left-handed',
      'triangles',
      usd(def('Mesh', `${FACE}\nuniform token orientation = "leftHanded"`)),
      (s) => {
        const { mesh } = s.objects[0];
        expect(mesh.indices.length).toBe(6);
        expect([...mesh.normals.subarray(0, 3)].map((x) => x + 0)).toEqual([0, 0, -1]);
      },
    ),
    read(
      'normals, uvs and colours of every interpolation, indexed or not',
      'the same, vertices split where they differ',
      usd(
        def(
          'Mesh',
          `${FACE}
      color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0)] ( interpolation = "faceVarying" )
      int[] primvars:displayColor:indices = [0, 0, 1, 1]`,
        ),
      ),
      (s) => expect([...s.objects[0].mesh.colors!.subarray(0, 3)]).toEqual([1, 0, 0]),
    ),
    read(
      '`subdivisionScheme` `catmullClark`, `loop`, `bilinear`; creases, corners, holes, boundaries',
      'the limit surface, two levels unless asked otherwise',
      usd(def('Mesh', `${PYRAMID}\nuniform token subdivisionScheme = "loop"`)),
      (s) => {
        expect(s.objects[0].mesh.indices.length).toBe(3 * 4 * 16);
        expect(volume(s.objects[0].mesh)).toBeLessThan(1 / 6);
      },
    ),
    read(
      '`Cube`, `Sphere`, `Cylinder`, `Cone`, `Capsule`, `Plane`',
      'meshes',
      usd(
        ['Cube', 'Sphere', 'Cylinder', 'Cone', 'Capsule', 'Plane'].map((type) => `def ${type} "${type}" {}`).join('\n'),
      ),
      (s) => expect(s.objects.length).toBe(7),
    ),
    read(
      '`GeomSubset` of faces; `material:binding`, inherited, `strongerThanDescendants`',
      'runs of triangles with a material',
      usd(def('Mesh', `${FACE}\ndef GeomSubset "S" { int[] indices = [0]\nrel material:binding = </Red> }`) + RED),
      (s) => expect(s.materials[s.objects[0].mesh.groups[0].material].baseColor).toEqual([1, 0, 0]),
    ),
    read(
      '`displayColor`, `displayOpacity`',
      'the material where none is bound',
      usd(def('Cube', 'color3f[] primvars:displayColor = [(1, 0, 0)]\nfloat[] primvars:displayOpacity = [0.5]')),
      (s) => expect(s.materials[0]).toMatchObject({ baseColor: [1, 0, 0], opacity: 0.5 }),
    ),
    approximated(
      'faces, or a number of points, that change with time',
      'the shape is held at the start',
      'usd.topology',
      usd(
        def(
          'Mesh',
          FACE.replace('faceVertexCounts =', 'faceVertexCounts.timeSamples = { 0:').replace('[4];', '[4], 9: [3] };'),
        ),
      ),
      (s) => expect(paths(s)).toContain('/A'),
    ),
    approximated(
      'sizes of `Cube` and others that change with time',
      'held at the start',
      'usd.animated-size',
      usd(def('Cube', 'double size.timeSamples = { 0: 1, 9: 2 }')),
    ),
    approximated(
      'subdivision surfaces with more faces than a scene may have; `loop` with polygons; creases that do not fit',
      'fewer levels, or the polygons',
      'usd.subdivision',
      usd(def('Mesh', `${FACE.replace('"none"', '"loop"')}`)),
    ),
    leftOut(
      'faces of fewer than 3 corners, or with points that are not there',
      'named with how many',
      'usd.faces',
      usd(def('Mesh', `${PYRAMID.replace('2, 0, 3]', '2, 0, 9]')}\nuniform token subdivisionScheme = "none"`)),
      (s) => expect(s.objects[0].mesh.indices.length).toBe(9),
    ),
    leftOut('a `Mesh` without points or faces', 'named', 'usd.empty-mesh', usd(def('Mesh'))),
    leftOut(
      'a primvar whose values do not fit',
      'named with the numbers',
      'usd.primvar',
      usd(def('Mesh', `${FACE}\nnormal3f[] normals = [(0, 0, 1)] ( interpolation = "vertex" )`)),
      (s) => expect(paths(s)).toContain('/A'),
    ),
    leftOut(
      'subsets of points or edges',
      'named',
      'usd.subset',
      usd(
        def(
          'Mesh',
          `${FACE}\ndef GeomSubset "S" { uniform token elementType = "point"\nrel material:binding = </Red> }`,
        ) + RED,
      ),
    ),
    unseen('BasisCurves'),
    unseen('NurbsCurves'),
    unseen('HermiteCurves'),
    unseen('Points'),
    unseen('Volume'),
    unseen('NurbsPatch', '; export it as a mesh'),
    unseen('TetMesh', '; export its surface as a mesh'),
    unseen('Cylinder_1', '; export it as a mesh'),
    unseen('Capsule_1', '; export it as a mesh'),
    leftOut(
      'NaN, infinite or overflowing numbers',
      'what they spoil (points, motions, lights), with how much',
      'file.not-finite',
      usd(def('Mesh', `${PYRAMID.replace('(0, 0, 1)]', '(0, 0, nan)]')}\nuniform token subdivisionScheme = "none"`)),
      (s) => expect(s.objects[0].mesh.indices.length).toBe(3),
    ),
  ],
};

const many = (count: number): string =>
  def(
    'PointInstancer',
    `rel prototypes = </A/P>\nint[] protoIndices = [${Array(count).fill(0).join(', ')}]\npoint3f[] positions = [${Array(count).fill('(3, 0, 0)').join(', ')}]\ndef Cube "P" {}`,
  );

const ONE = '((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))';
const body = (skin: string, rig: string): string => `def SkelRoot "A" { rel skel:skeleton = </A/S>
  rel skel:animationSource = </A/S/Turn>
  def Skeleton "S" { uniform token[] joints = ["a"]; uniform matrix4d[] bindTransforms = [${ONE}]; uniform matrix4d[] restTransforms = [${ONE}]
    def SkelAnimation "Turn" { ${rig} } }
  def Mesh "M" { ${FACE}
    ${skin} } }`;
const BOUND = `int[] primvars:skel:jointIndices = [0, 0, 0, 0] ( elementSize = 1; interpolation = "vertex" )
  float[] primvars:skel:jointWeights = [1, 1, 1, 1] ( elementSize = 1; interpolation = "vertex" )`;
const SLIDE =
  'uniform token[] joints = ["a"]\nfloat3[] translations.timeSamples = { 0: [(0, 0, 0)], 24: [(0, 0, 2)] }\nquatf[] rotations = [(1, 0, 0, 0)]\nhalf3[] scales = [(1, 1, 1)]';
const SHAPE = (offsets: string): string =>
  `uniform token[] skel:blendShapes = ["up"]\nrel skel:blendShapeTargets = </A/M/Up>\ndef BlendShape "Up" { uniform vector3f[] offsets = ${offsets} }`;
const WEIGHT = 'uniform token[] blendShapes = ["up"]\nfloat[] blendShapeWeights.timeSamples = { 0: [0], 24: [1] }';
const UP = '[(0, 0, 2), (0, 0, 2), (0, 0, 2), (0, 0, 2)]';

const instances: Group = {
  title: 'Instances and skeletons',
  rows: [
    read(
      '`PointInstancer`: ids, masks, scales, velocities, instancers in prototypes',
      'an object for each instance: `/Forest[12]/Tree`',
      usd(many(2)),
      (s) => expect(paths(s).slice(0, 2)).toEqual(['/A[0]/P', '/A[1]/P']),
    ),
    leftOut(
      'an instancer that asks for more objects than a scene may have',
      'named with how many',
      'usd.too-many-instances',
      usd(
        `${many(600).replace('"A"', '"B"').replaceAll('/A/P', '/B/P')}\n${def('PointInstancer', `rel prototypes = </B>\nint[] protoIndices = [${Array(600).fill(0).join(', ')}]\npoint3f[] positions = [${Array(600).fill('(0, 0, 0)').join(', ')}]`)}`,
      ),
    ),
    leftOut(
      'arrays or prototypes of an instancer that do not fit together',
      'named; the instances that can be are shown',
      'usd.instancer',
      usd(many(2).replace('[0, 0]', '[0, 7]')),
    ),
    leftOut(
      'lights and cameras in prototypes',
      'named',
      'usd.instancer',
      usd(many(1).replace('def Cube "P" {}', 'def Xform "P" { def Cube "C" {}\ndef SphereLight "L" {} }')),
    ),
    read(
      '`SkelRoot`, `Skeleton`, `SkelAnimation`; linear blending or dual quaternions',
      'meshes that follow their joints',
      usd(body(`${BOUND}\nrel skel:skeleton = </A/S>`, SLIDE)),
      (s) => expect(vertexPosition(s.objects[0], 0, 0.5, C)[2]).toBeCloseTo(1, 5),
    ),
    read(
      '`BlendShape`, with inbetweens',
      'bends its mesh',
      usd(body(SHAPE(UP), `${SLIDE.replace(/float3\[\] tr.*\n/, 'float3[] translations = [(0, 0, 0)]\n')}\n${WEIGHT}`)),
      (s) => expect(vertexPosition(s.objects[0], 0, 0.5, C)[2]).toBeCloseTo(1, 5),
    ),
    leftOut(
      'a skeleton or animation that does not fit together',
      'named; its meshes stay as they are written',
      'usd.skeleton',
      usd(body(BOUND, SLIDE).replace(`bindTransforms = [${ONE}]`, 'bindTransforms = []')),
    ),
    leftOut(
      'joints or weights that do not fit their mesh',
      'named; the mesh stays as it is written',
      'usd.skin',
      usd(body(BOUND.replace('[0, 0, 0, 0]', '[0, 0, 0, 9]'), SLIDE)),
    ),
    leftOut(
      'a blend shape that does not fit its mesh',
      'named; it does not bend it',
      'usd.blend-shape',
      usd(body(SHAPE('[(0, 0, 2)]'), `${SLIDE}\n${WEIGHT}`)),
    ),
  ],
};

export const usdGroups: readonly Group[] = [files, composition, motion, geometry, instances, ...lookGroups];
