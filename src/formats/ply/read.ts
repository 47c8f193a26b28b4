import { msg } from '../../messages/message.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import { makeMesh } from '../../scene/mesh/makeMesh.ts';
import type { PolygonValues } from '../../scene/mesh/polygons.ts';
import { InputError, type Material, type Mesh, type Scene, type Texture } from '../../scene/types.ts';
import { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { missingTexture } from '../diagnostics/missingFiles.ts';
import { type FileSource, resolvePath } from '../files/fileSource.ts';
import { decodeImage } from '../image/decodeImage.ts';
import { meshScene } from '../read/meshScene.ts';
import { type PlyContents, readContents } from './contents.ts';
import { type Element, readHeader } from './header.ts';
import { plyValueReader } from './valueReader.ts';

/** Faces without normals are smooth below this angle [rad], as for USD. */
const SMOOTH_ANGLE = Math.PI / 3;

/**
 * Reads PLY (Stanford triangle format), text or binary of either byte order, as one resting mesh. Throws an InputError that
 * names file, line or byte, and value where it cannot.
 */
export async function readPly(source: FileSource, entry: string): Promise<Scene> {
  const bytes = await source.read(entry);
  if (!bytes) throw inputError('file.missing', entry, msg`no such file`);
  const notes = new DiagnosticLog(entry);
  const header = readHeader(bytes, entry);
  const splats = header.elements.find(isSplats);
  if (splats) {
    const message = msg`its ${splats.rows} points are Gaussian splats, which are not shown; export it as a mesh`;
    notes.add('warning', 'ply.splats', '', message);
    return meshScene(entry, [], [], notes);
  }
  const values = plyValueReader(bytes, header, entry);
  const contents = readContents(header, values, entry);
  if (values.extraValues > 0) {
    const message = msg`its rows have ${values.extraValues} values more than its header declares; they are left out`;
    notes.add('warning', 'ply.extra-values', '', message);
  }
  const mesh = meshOf(contents, notes);
  if (!mesh) return meshScene(entry, [], [], notes);
  const texture = header.texture === undefined ? undefined : await readTexture(source, entry, header.texture, notes);
  return meshScene(entry, [{ name: '', mesh }], [materialOf(texture, contents)], notes);
}

/** Properties by which splats are known: as trained (Kerbl et al. 2023), and as SuperSplat packs them. */
const SPLATS = [
  ['f_dc_0', 'opacity', 'scale_0', 'rot_0'],
  ['packed_position', 'packed_rotation', 'packed_scale', 'packed_color'],
];

const isSplats = ({ properties }: Element): boolean =>
  SPLATS.some((names) => names.every((name) => properties.some((property) => property.name === name)));

function meshOf(contents: PlyContents, notes: DiagnosticLog): Mesh | undefined {
  const { points, normals, colors, faceColors } = contents;
  if (contents.faceCounts.length === 0) {
    notes.add('warning', 'ply.points', '', msg`its ${points.length / 3} points have no faces; points are not shown`);
    return undefined;
  }
  const uvs = uvsOf(contents);
  const shownColors: PolygonValues | undefined = colors
    ? { per: 'point', values: colors }
    : faceColors && { per: 'face', values: faceColors.values() };
  const { mesh, skippedFaces } = makeMesh({
    points,
    faceCounts: contents.faceCounts.values(),
    faceIndices: contents.faceIndices.values(),
    ...(normals ? { normals: { per: 'point', values: normals } } : { smoothAngle: SMOOTH_ANGLE }),
    ...(uvs && { uvs }),
    ...(shownColors && { colors: shownColors }),
    // PLY does not define an orientation, and files differ.
    doubleSided: true,
  });
  if (skippedFaces > 0)
    notes.add('warning', 'ply.faces', '', msg`${skippedFaces} faces have fewer than 3 corners; they are left out`);
  return mesh.indices.length > 0 ? mesh : undefined;
}

function uvsOf({ uvs, cornerUvs }: PlyContents): PolygonValues | undefined {
  if (cornerUvs) return { per: 'corner', values: cornerUvs.values() };
  return uvs && { per: 'point', values: uvs };
}

/** White where a texture or vertex colours give the colour. */
function materialOf(texture: Texture | undefined, { colors, faceColors }: PlyContents): Material {
  const isColored = texture ?? colors ?? faceColors;
  return makeMaterial({
    name: 'default',
    ...(isColored && { baseColor: [1, 1, 1] }),
    ...(texture && { baseColorTexture: texture }),
  });
}

async function readTexture(
  source: FileSource,
  entry: string,
  name: string,
  notes: DiagnosticLog,
): Promise<Texture | undefined> {
  const path = resolvePath(entry, name);
  const bytes = await source.read(path);
  if (!bytes) {
    const { code, message, missing } = missingTexture(name, [path]);
    notes.add('warning', code, '', message, { missing });
    return undefined;
  }
  try {
    const image = decodeImage(bytes, path);
    return { name, ...image, colorSpace: 'srgb', filter: 'linear', wrapS: 'repeat', wrapT: 'repeat' };
  } catch (thrown) {
    if (!(thrown instanceof InputError)) throw thrown;
    notes.add('warning', 'file.unreadable-texture', '', msg`${thrown.text}; shown without it`);
    return undefined;
  }
}
