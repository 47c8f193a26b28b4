import { formatBytes } from '../../src/formats/diagnostics/inputError.ts';
import { MAX_LINE } from '../../src/formats/files/textLines.ts';
import { MAX_FRAMES as MAX_FILM_FRAMES, MAX_WIDTH as MAX_FILM_WIDTH } from '../../src/formats/film/filmTrack.ts';
import { MAX_UNPACKED, MAX_DEPTH as NODE_DEPTH } from '../../src/formats/gltf/load/checkReferences.ts';
import { MAX_INSTANCES } from '../../src/formats/gltf/read/instances.ts';
import { MAX_VERTICES } from '../../src/formats/gltf/read/read.ts';
import { MAX_MORPH_TARGETS } from '../../src/formats/gltf/write/writeMeshes.ts';
import { MAX_SIDE as MAX_PICTURE_SIDE, MAX_PIXELS } from '../../src/formats/image/decodeImage.ts';
import { MAX_PARTS } from '../../src/formats/obj/geometry.ts';
import { MAX_FILES, MAX_MATERIALS } from '../../src/formats/obj/materials.ts';
import { MAX_BYTES } from '../../src/formats/open.ts';
import { MAX_PROPERTIES } from '../../src/formats/ply/header.ts';
import { MAX_BLENDED } from '../../src/formats/read/blendBudget.ts';
import { MAX_OBJECTS } from '../../src/formats/read/limits.ts';
import { MAX_CORNERS } from '../../src/formats/read/meshScene.ts';
import { MAX_SPHERES } from '../../src/formats/read/strands/pointSpheres.ts';
import { MAX_SURFACE_POINTS } from '../../src/formats/read/strands/sweep.ts';
import { MAX_SOLIDS } from '../../src/formats/stl/text.ts';
import {
  MAX_CLIP_SAMPLES,
  MAX_PRIMS,
  MAX_DEPTH as NAMESPACE_DEPTH,
} from '../../src/formats/usd/compose/composeStage.ts';
import { MAX_LAYERS } from '../../src/formats/usd/compose/layers/layerStore.ts';
import { MAX_NODES } from '../../src/formats/usd/compose/primIndex/primIndexer.ts';
import { MAX_SUBDIVISION_LEVELS, POINT_BUDGET, SAMPLE_MEMORY } from '../../src/formats/usd/read.ts';
import { DRAWN_FACE_BUDGET, FACE_BUDGET } from '../../src/formats/usd/schema/geometry/subdivisionLevels.ts';
import { MAX_UDIM_ATLAS_SIDE as MAX_ATLAS_SIDE } from '../../src/formats/usd/schema/materials/udim.ts';
import { MAX_INFLUENCES } from '../../src/formats/usd/schema/skel/binding.ts';
import { MAX_DEPTH as TEXT_DEPTH } from '../../src/formats/usd/text/parser.ts';
import { MAX_TOTAL } from '../../src/formats/zip/directory.ts';
import { inEnglish } from '../../src/messages/message.ts';
import { MAX_PER_CODE } from '../../src/scene/validation/diagnosticCodes.ts';

const count = (n: number): string => n.toLocaleString('en');
const bytes = (n: number): string => inEnglish(formatBytes(n)).replace(/\.0+(?= )/, '');

/** Limits of a scene, from the readers' constants. */
export const readerLimits: readonly { readonly what: string; readonly most: string }[] = [
  { what: 'all files of a scene together', most: bytes(MAX_BYTES) },
  { what: 'unpacked size of a zip', most: bytes(MAX_TOTAL) },
  { what: 'objects of a scene, instances included', most: count(MAX_OBJECTS) },
  { what: 'messages of one code', most: count(MAX_PER_CODE) },
  { what: 'a picture', most: `${count(MAX_PICTURE_SIDE)} pixels a side, ${count(MAX_PIXELS)} in all` },
  {
    what: 'a film',
    most: `${count(MAX_FILM_FRAMES)} frames; wider ones than ${count(MAX_FILM_WIDTH)} pixels are made smaller`,
  },
  { what: 'USD: layers of a stage', most: count(MAX_LAYERS) },
  { what: 'USD: prims of a stage', most: count(MAX_PRIMS) },
  { what: 'USD: opinions on one prim', most: count(MAX_NODES) },
  { what: 'USD: depth of the namespace', most: `${count(NAMESPACE_DEPTH)}; in one text ${count(TEXT_DEPTH)}` },
  { what: 'USD: time samples from value clips', most: count(MAX_CLIP_SAMPLES) },
  { what: 'USD: points of deforming meshes, all samples in memory', most: bytes(POINT_BUDGET) },
  { what: 'USD: samples held in memory that could be streamed from their binary layer', most: bytes(SAMPLE_MEMORY) },
  { what: 'USD: faces of subdivision surfaces', most: `${count(FACE_BUDGET)}, of ${MAX_SUBDIVISION_LEVELS} levels` },
  {
    what: 'USD: the same, instances counted, unless levels are requested',
    most: count(DRAWN_FACE_BUDGET),
  },
  { what: 'USD: joints that influence one point', most: count(MAX_INFLUENCES) },
  { what: 'spheres of one USD Points, or of all points of a glTF file', most: count(MAX_SPHERES) },
  {
    what: 'points of the tubes or ribbons of one USD prim of curves, or of all lines of a glTF file',
    most: count(MAX_SURFACE_POINTS),
  },
  { what: 'USD: side of the picture combined from tiles', most: `${count(MAX_ATLAS_SIDE)} pixels` },
  { what: 'glTF: unpacked size of accessors and compressed data', most: bytes(MAX_UNPACKED) },
  { what: 'glTF: vertices', most: count(MAX_VERTICES) },
  { what: 'glTF: depth of the node hierarchy', most: count(NODE_DEPTH) },
  { what: 'glTF: instances of one node', most: count(MAX_INSTANCES) },
  { what: 'USD, glTF: joints of skins at all nodes of their time grids', most: bytes(MAX_BLENDED) },
  { what: 'glTF, written: samples of a deforming mesh that is no skin', most: count(MAX_MORPH_TARGETS) },
  { what: 'OBJ, PLY: corners of a face', most: count(MAX_CORNERS) },
  {
    what: 'OBJ: objects and groups; materials; material files',
    most: `${count(MAX_PARTS)}; ${count(MAX_MATERIALS)}; ${count(MAX_FILES)}`,
  },
  { what: 'PLY: elements; properties of each', most: count(MAX_PROPERTIES) },
  { what: 'STL: solids', most: count(MAX_SOLIDS) },
  { what: 'OBJ, PLY, STL: a line of text', most: bytes(MAX_LINE) },
];
