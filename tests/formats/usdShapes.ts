import { expect } from 'vitest';
import { vertexPosition } from '../../src/scene/motion/motion.ts';
import { isStreamed } from '../../src/scene/streaming/samplePoints.ts';
import type { SampledPointsMotion, Scene } from '../../src/scene/types.ts';
import { volume } from '../support/meshes.ts';
import { approximated, type ClaimGroup, leftOut, read } from './claim.ts';
import { C, corner, crateFixture, def, FACE, MOVED, ORDER, paths, RED, usd } from './usdKit.ts';

/** The square whose first corner moves up and down. */
const waving = (more: string): string => {
  const at = (z: number): string => `[(0, 0, ${z}), (1, 0, 0), (1, 1, 0), (0, 1, 0)]`;
  const samples = `points.timeSamples = { 0: ${at(0)}, 12: ${at(1)}, 24: ${at(0)} }`;
  return `${FACE.replace(/points = .*/, samples)}\n${more}`;
};

function deforming({ objects: [{ motion }] }: Scene): SampledPointsMotion {
  if (motion.kind !== 'sampled-points') throw new Error(motion.kind);
  return motion;
}

const modelDrawnAs = (mode: string, more = ''): string =>
  `def Xform "M" ( kind = "component" ) { uniform token model:drawMode = "${mode}"\n${more}\ndef Cube "A" {} }`;

const motion: ClaimGroup = {
  title: 'Placement and motion',
  rows: [
    read(
      'all transform ops, `!invert!`, `!resetXformStack!`',
      'placement',
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
      'rigid motion; linear between samples, quaternions by spherical interpolation',
      usd(`def Cube "A" { ${MOVED}\n${ORDER} }`),
      (s) => {
        expect(s.objects[0].motion.kind).toBe('sampled');
        expect(corner(s, '/A', 0, 0.5)[0] - corner(s, '/A', 0, 0)[0]).toBeCloseTo(1.5, 4);
      },
    ),
    read(
      'time-sampled scale, shear or `points` (and `normals`)',
      'one path per vertex',
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
      '`points` between samples, with `--interpolation cubic`',
      'cubics, using `velocities` if the file has them; straight lines without the flag; the distance between the two is reported',
      usd(def('Mesh', waving(''))),
      (s) => expect(deforming(s).velocities).toHaveLength(3),
      { says: 'usd.between-samples', options: { interpolation: 'cubic' } },
    ),
    approximated(
      '`velocities` that do not match the points, with cubic interpolation',
      'slopes are computed from the points',
      'usd.velocities',
      usd(def('Mesh', waving('vector3f[] velocities.timeSamples = { 0: [(0, 0, 1)] }'))),
      (s) => expect(deforming(s).velocities).toHaveLength(3),
      { interpolation: 'cubic' },
    ),
    approximated(
      'too many samples of `points` for memory, in binary layers',
      'the samples stay in the file and are read ahead of the light cone; subdivision surfaces are drawn as their polygons',
      'usd.subdivision',
      { 'a.usdc': crateFixture('../../fixtures/caches.usdc') },
      (s) => expect(isStreamed(deforming(s).points)).toBe(true),
      { sampleMemory: 0 },
    ),
    read(
      '`slowlight:motion = "uniform"` or `"hyperbolic"`',
      'exact motion at all times',
      usd(def('Cube', 'token slowlight:motion = "uniform"\nvector3d slowlight:velocity = (2, 0, 0)')),
      (s) => expect(s.objects[0].motion).toMatchObject({ kind: 'uniform', velocity: [2, 0, 0] }),
    ),
    read(
      '`slowlight:birth`, `slowlight:death`, `slowlight:authoredIn`',
      'the lifetime of the object; the frame in which its shape is given',
      usd(def('Cube', 'double slowlight:birth = 1\ntoken slowlight:authoredIn = "rest"')),
      (s) =>
        expect(s.objects[0]).toMatchObject({
          lifetime: { birth: 1, death: Number.POSITIVE_INFINITY },
          authoredIn: 'rest',
        }),
    ),
    read(
      '`visibility`, `active`, `purpose`',
      'prims that are invisible, inactive, `proxy` or `guide` are not shown',
      usd(
        'def Cube "A" { token visibility = "invisible" }\ndef Cube "B" ( active = false ) {}\ndef Cube "C" { uniform token purpose = "proxy" }\ndef Cube "D" { uniform token purpose = "guide" }',
      ),
      (s) => expect(paths(s)).toEqual(['/Rest']),
    ),
    read(
      '`visibility` over time, with that of the prims above',
      'lifetimes, half-open: an object for each time in which it is visible, `/Thing/piece1` and so on; of lights with a place too',
      usd(def('Cube', 'token visibility.timeSamples = { 0: "inherited", 9: "invisible", 24: "inherited" }')),
      (s) => expect(paths(s)).toEqual(expect.arrayContaining(['/A/piece1', '/A/piece2'])),
    ),
    approximated(
      '`visibility` over time of a distant or dome light',
      'held at its initial value',
      'usd.animated-visibility',
      usd('def DistantLight "Sun" { token visibility.timeSamples = { 0: "inherited", 9: "invisible" } }'),
      (s) => expect(s.lights).toHaveLength(1),
    ),
    approximated(
      'a path that rotates too fast between its samples to be resampled within tolerance',
      'as close as the sample limit allows; the number of samples needed and the error are reported',
      'usd.resampling',
      usd(
        def(
          'Cube',
          'double xformOp:rotateZ.timeSamples = { 0: 0, 1: 1e9 }\nuniform token[] xformOpOrder = ["xformOp:rotateZ"]',
        ),
      ),
    ),
    leftOut('an op in `xformOpOrder` that the prim does not have', 'reported', 'usd.xform-op', usd(def('Cube', ORDER))),
    leftOut(
      '`slowlight:` attributes that contradict each other or are unknown',
      'reported',
      'usd.slowlight',
      usd(def('Cube', 'token slowlight:motion = "sideways"')),
    ),
  ],
};

/** A square, from code 9 on a triangle elsewhere. */
const CHANGING_FACE = `int[] faceVertexCounts.timeSamples = { 0: [4], 9: [3] }
  int[] faceVertexIndices.timeSamples = { 0: [0, 1, 2, 3], 9: [0, 1, 2] }
  point3f[] points.timeSamples = { 0: [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], 9: [(0, 0, 1), (1, 0, 1), (1, 1, 1)] }
  uniform token subdivisionScheme = "none"`;
const CHANGING_VELOCITIES = `vector3f[] velocities.timeSamples = {
  0: [(0, 0, 2), (0, 0, 2), (0, 0, 2), (0, 0, 2)], 9: [(0, 0, 2), (0, 0, 2), (0, 0, 2)] }`;

const PYRAMID = `int[] faceVertexCounts = [3, 3, 3, 3]; int[] faceVertexIndices = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]
  point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]`;

const unseen = (types: readonly string[], becomes: string): ReturnType<typeof leftOut> =>
  leftOut(
    types.map((type) => `\`${type}\``).join(', '),
    becomes,
    'usd.unsupported-prim',
    types.map((type) => usd(def(type))),
    (s) => expect(paths(s)).toEqual(['/Rest']),
  );

const geometry: ClaimGroup = {
  title: 'Shapes',
  rows: [
    read(
      '`Mesh`: polygons (also concave), holes, left-handed orientation',
      'triangles',
      usd(def('Mesh', `${FACE}\nuniform token orientation = "leftHanded"`)),
      (s) => {
        const { mesh } = s.objects[0];
        expect(mesh.indices.length).toBe(6);
        expect([...mesh.normals.subarray(0, 3)].map((x) => x + 0)).toEqual([0, 0, -1]);
      },
    ),
    read(
      'normals, uvs and colours with every interpolation, indexed or not',
      'the same; vertices are split where values differ',
      [
        ['constant', '[0]'],
        ['uniform', '[0]'],
        ['varying', '[0, 0, 1, 1]'],
        ['vertex', '[0, 0, 1, 1]'],
        ['faceVarying', '[0, 0, 1, 1]'],
      ].map(([interpolation, indices]) =>
        usd(
          def(
            'Mesh',
            `${FACE}
      color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0)] ( interpolation = "${interpolation}" )
      int[] primvars:displayColor:indices = ${indices}`,
          ),
        ),
      ),
      (s) => expect([...s.objects[0].mesh.colors!.subarray(0, 3)]).toEqual([1, 0, 0]),
    ),
    read(
      '`subdivisionScheme` `catmullClark`, `loop`, `bilinear`; creases, corners, holes, boundaries',
      'the limit surface, at two levels (up to four for meshes of few faces, fewer for fine ones) unless set otherwise',
      usd(def('Mesh', `${PYRAMID}\nuniform token subdivisionScheme = "loop"`)),
      (s) => {
        expect(s.objects[0].mesh.indices.length).toBe(3 * 4 * 4 ** 4);
        expect(volume(s.objects[0].mesh)).toBeLessThan(1 / 6);
      },
    ),
    read(
      '`Cube`, `Sphere`, `Cylinder`, `Cone`, `Capsule`, `Plane`',
      'meshes; the round ones are seen as round as they are, and written so',
      usd(
        ['Cube', 'Sphere', 'Cylinder', 'Cone', 'Capsule', 'Plane'].map((type) => `def ${type} "${type}" {}`).join('\n'),
      ),
      (s) => {
        expect(s.objects.length).toBe(7);
        const round = s.objects.flatMap(({ mesh }) => mesh.quadric?.shape.kind ?? []);
        expect(round).toEqual(['sphere', 'cylinder', 'cone', 'capsule']);
      },
    ),
    read(
      '`GeomSubset` of faces; `material:binding`, inherited, `strongerThanDescendants`',
      'ranges of triangles with a material each',
      usd(def('Mesh', `${FACE}\ndef GeomSubset "S" { int[] indices = [0]\nrel material:binding = </Red> }`) + RED),
      (s) => expect(s.materials[s.objects[0].mesh.groups[0].material].baseColor).toEqual([1, 0, 0]),
    ),
    read(
      '`displayColor`, `displayOpacity`',
      'the material if none is bound',
      usd(def('Cube', 'color3f[] primvars:displayColor = [(1, 0, 0)]\nfloat[] primvars:displayOpacity = [0.5]')),
      (s) => expect(s.materials[0]).toMatchObject({ baseColor: [1, 0, 0], opacity: 0.5 }),
    ),
    read(
      'topology, number of points and faces of subsets over time, with `velocities`',
      'a sequence of meshes (`/Thing/piece1` …), each alive from its sample to the next; its points are those of its sample and move on with their velocities until the next',
      usd(def('Mesh', `${CHANGING_FACE}\n${CHANGING_VELOCITIES}`)),
      (s) => expect(s.objects.filter(({ pieceOf }) => pieceOf === '/A')).toHaveLength(2),
      { says: 'usd.topology' },
    ),
    approximated(
      'the same without `velocities`',
      'each mesh rests until the next, so it shows no Doppler effect of its own; where the number of points stays, they go straight from sample to sample',
      'usd.topology',
      usd(def('Mesh', CHANGING_FACE)),
      (s) =>
        expect(s.objects.filter(({ motion }) => motion.kind === 'static').map(({ path }) => path)).toEqual(
          expect.arrayContaining(['/A/piece1', '/A/piece2']),
        ),
    ),
    approximated(
      'topology over time of skinned meshes',
      'held at its initial state',
      'usd.topology',
      usd(def('Mesh', `${CHANGING_FACE}\nrel skel:skeleton = </None>`)),
      (s) => expect(paths(s)).toContain('/A'),
    ),
    approximated(
      'animated sizes of `Cube` and the other primitives',
      'held at its initial value',
      'usd.animated-size',
      usd(def('Cube', 'double size.timeSamples = { 0: 1, 9: 2 }')),
    ),
    approximated(
      '`loop` with faces other than triangles; creases or corners that do not match the mesh',
      'drawn as polygons; the surface without those creases or corners',
      'usd.subdivision',
      [
        FACE.replace('"none"', '"loop"'),
        `${FACE.replace('"none"', '"bilinear"')}\nint[] creaseIndices = [0, 9]\nint[] creaseLengths = [2]\nfloat[] creaseSharpnesses = [1]`,
        `${FACE.replace('"none"', '"bilinear"')}\nint[] cornerIndices = [0]`,
      ].map((mesh) => usd(def('Mesh', mesh))),
    ),
    leftOut(
      'faces with fewer than 3 corners or with point indices out of range',
      'reported with their number',
      'usd.faces',
      usd(def('Mesh', `${PYRAMID.replace('2, 0, 3]', '2, 0, 9]')}\nuniform token subdivisionScheme = "none"`)),
      (s) => expect(s.objects[0].mesh.indices.length).toBe(9),
    ),
    leftOut('a `Mesh` without points or faces', 'reported', 'usd.empty-mesh', usd(def('Mesh'))),
    leftOut(
      'a primvar with the wrong number of values',
      'reported with the numbers',
      'usd.primvar',
      usd(def('Mesh', `${FACE}\nnormal3f[] normals = [(0, 0, 1)] ( interpolation = "vertex" )`)),
      (s) => expect(paths(s)).toContain('/A'),
    ),
    leftOut(
      'subsets of points or edges',
      'reported',
      'usd.subset',
      usd(
        def(
          'Mesh',
          `${FACE}\ndef GeomSubset "S" { uniform token elementType = "point"\nrel material:binding = </Red> }`,
        ) + RED,
      ),
    ),
    read(
      '`Points` with widths, also over time, and with velocities',
      'spheres of 8 to 512 triangles, by their number; without widths they are one unit wide. Velocities with one sample of points move them over the time of the stage',
      usd(def('Points', 'point3f[] points = [(0, 0, 0), (4, 0, 0)]\nfloat[] widths = [1, 2]')),
      (s) => expect(s.objects[0].mesh.indices.length / 3).toBe(2 * 512),
    ),
    read(
      '`BasisCurves` (linear; bezier, bspline, catmullRom; nonperiodic, periodic, pinned) and `NurbsCurves` (rational), also over time; widths, colours and uvs constant, uniform, varying or per vertex',
      'tubes with lids; ribbons across their normals where they have some',
      [
        usd(
          def(
            'BasisCurves',
            'int[] curveVertexCounts = [4]\npoint3f[] points = [(0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)]\nfloat[] widths = [0.1]',
          ),
        ),
        usd(
          def(
            'NurbsCurves',
            'int[] curveVertexCounts = [3]\nint[] order = [3]\ndouble[] knots = [0, 0, 0, 1, 1, 1]\npoint3f[] points = [(0, 0, 0), (0, 1, 0), (1, 1, 0)]\nfloat[] widths = [0.1]',
          ),
        ),
      ],
      (s) => expect(s.objects[0].mesh.positions.length).toBeGreaterThan(3 * 90),
    ),
    approximated(
      '`Points` or curves whose number changes with time, or that are too many',
      'held at the start; the first curves, or points evenly',
      'usd.topology',
      usd(def('Points', 'point3f[] points.timeSamples = { 0: [(0, 0, 0)], 9: [(0, 0, 0), (1, 0, 0)] }')),
    ),
    leftOut(
      'curves that need more points than they have',
      'reported with both numbers',
      'usd.strands',
      usd(def('BasisCurves', 'int[] curveVertexCounts = [4]\npoint3f[] points = [(0, 0, 0)]')),
    ),
    read(
      '`model:drawMode` of components, and where `model:applyDrawMode` says so',
      'instead of the model: lines along its axes (`origin`), the edges of its box (`bounds`; by `extentsHint`, else by what is below), or pictures on `cards` (`cross`, `box`)',
      usd(modelDrawnAs('bounds')),
      (s) => expect(paths(s)).toEqual(['/M/bounds', '/Rest']),
    ),
    approximated(
      'cards that are placed by their pictures (`model:cardGeometry = "fromTexture"`)',
      'a cross; reported',
      'usd.draw-mode',
      usd(modelDrawnAs('cards', 'uniform token model:cardGeometry = "fromTexture"')),
    ),
    unseen(['HermiteCurves', 'Volume'], 'reported'),
    unseen(['NurbsPatch', 'TetMesh', 'Cylinder_1', 'Capsule_1'], 'reported; export it, or its surface, as a mesh'),
    leftOut(
      'NaN, infinite or overflowing numbers',
      'what depends on them (points, motions, lights) is left out; the amount is reported',
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

const instances: ClaimGroup = {
  title: 'Instances and skeletons',
  rows: [
    read(
      '`PointInstancer`: ids, masks, scales, velocities, instancers in prototypes',
      'one object per instance: `/Forest[12]/Tree`',
      usd(many(2)),
      (s) => expect(paths(s).slice(0, 2)).toEqual(['/A[0]/P', '/A[1]/P']),
    ),
    leftOut(
      'an instancer with more objects than the limit for a scene',
      'reported with their number',
      'usd.too-many-instances',
      usd(
        `${many(600).replace('"A"', '"B"').replaceAll('/A/P', '/B/P')}\n${def('PointInstancer', `rel prototypes = </B>\nint[] protoIndices = [${Array(600).fill(0).join(', ')}]\npoint3f[] positions = [${Array(600).fill('(0, 0, 0)').join(', ')}]`)}`,
      ),
    ),
    leftOut(
      'inconsistent arrays or prototypes of an instancer',
      'reported; the valid instances are shown',
      'usd.instancer',
      usd(many(2).replace('[0, 0]', '[0, 7]')),
    ),
    leftOut(
      'lights and cameras in prototypes',
      'reported',
      'usd.instancer',
      usd(many(1).replace('def Cube "P" {}', 'def Xform "P" { def Cube "C" {}\ndef SphereLight "L" {} }')),
    ),
    read(
      '`SkelRoot`, `Skeleton`, `SkelAnimation`; linear blend or dual quaternion skinning',
      'skinned meshes',
      usd(body(`${BOUND}\nrel skel:skeleton = </A/S>`, SLIDE)),
      (s) => expect(vertexPosition(s.objects[0], 0, 0.5, C)[2]).toBeCloseTo(1, 5),
    ),
    read(
      'spheres, cubes, cylinders, cones, capsules, points and curves with constant influences of joints',
      'follow the joints as a whole',
      usd(
        body(`${BOUND}\nrel skel:skeleton = </A/S>`, SLIDE)
          .replace(`def Mesh "M" { ${FACE}`, 'def Cube "M" {')
          .replaceAll('"vertex"', '"constant"')
          .replace('[0, 0, 0, 0]', '[0]')
          .replace('[1, 1, 1, 1]', '[1]'),
      ),
      (s) => expect(corner(s, '/A/M', 0, 0.5)[2] - corner(s, '/A/M', 0, 0)[2]).toBeCloseTo(1, 5),
    ),
    leftOut(
      'points and curves whose points follow different joints',
      'reported; they stay as they are written',
      'usd.skin',
      usd(
        body(`${BOUND}\nrel skel:skeleton = </A/S>`, SLIDE).replace(
          `def Mesh "M" { ${FACE}`,
          'def Points "M" { point3f[] points = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0)]',
        ),
      ),
    ),
    read(
      '`BlendShape`, with inbetween shapes',
      'deforms its mesh',
      usd(body(SHAPE(UP), `${SLIDE.replace(/float3\[\] tr.*\n/, 'float3[] translations = [(0, 0, 0)]\n')}\n${WEIGHT}`)),
      (s) => expect(vertexPosition(s.objects[0], 0, 0.5, C)[2]).toBeCloseTo(1, 5),
    ),
    leftOut(
      'an inconsistent skeleton or animation',
      'reported; its meshes are shown undeformed',
      'usd.skeleton',
      usd(body(BOUND, SLIDE).replace(`bindTransforms = [${ONE}]`, 'bindTransforms = []')),
    ),
    leftOut(
      'joints or weights that do not match their mesh',
      'reported; the mesh is shown undeformed',
      'usd.skin',
      usd(body(BOUND.replace('[0, 0, 0, 0]', '[0, 0, 0, 9]'), SLIDE)),
    ),
    leftOut(
      'a blend shape that does not match its mesh',
      'reported; it is not applied',
      'usd.blend-shape',
      usd(body(SHAPE('[(0, 0, 2)]'), `${SLIDE}\n${WEIGHT}`)),
    ),
  ],
};

export const shapeGroups: readonly ClaimGroup[] = [motion, geometry, instances];
