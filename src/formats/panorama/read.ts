import { fromAxisAngle } from '../../math/quat.ts';
import { listed, msg } from '../../messages/message.ts';
import { makeScene, restingAt } from '../../scene/defaults.ts';
import { filmTimeOf } from '../../scene/film/seenFilm.ts';
import type { DomeLight, Scene, SceneCamera } from '../../scene/types.ts';
import { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { inputError } from '../diagnostics/inputError.ts';
import { extensionOf, type FileSource, stemOf } from '../files/fileSource.ts';
import { FILM_EXTENSIONS } from '../film/filmExtensions.ts';
import type { PanoramicFilm } from '../film/readFilm.ts';
import { decodeImage } from '../image/decodeImage.ts';
import { decodeForeign, foreignKind } from '../image/foreignPictures.ts';
import { decodeRadiance } from '../image/radiance/radiance.ts';
import { UniquePrimPaths } from '../read/primPaths.ts';
import type { ReadOptions } from '../readOptions.ts';
import { memoryFile } from '../zip/zipSource.ts';
import { faceFiles } from './faceFiles.ts';
import type { CubeFaces, PanoramaPicture } from './faces.ts';
import { unfoldedCube } from './unfold.ts';
import { unfoldedPicture } from './unfoldPicture.ts';
import { coverageOf, fisheyeOf } from './wholeSphere.ts';

/** The middle of the picture, which is towards +Z of a dome, is where a camera looks at first: towards −Z. */
const AHEAD = fromAxisAngle([0, 1, 0], Math.PI);

/** Vertical field of view of the scene's camera [rad]. */
const FIELD_OF_VIEW = 1.3;

/**
 * Reads a picture or a film of all directions as surroundings at infinity, with a camera in their middle. Throws an InputError that names the file, and what it is instead, where it is none.
 */
export async function readPanorama(source: FileSource, entry: string, options: ReadOptions): Promise<Scene> {
  const notes = new DiagnosticLog(entry);
  const { picture, film, ...rate }: Pick<PanoramicFilm, 'picture'> & Partial<PanoramicFilm> = FILM_EXTENSIONS.includes(
    extensionOf(entry),
  )
    ? await (await import('../film/readFilm.ts')).readFilm(source, entry, options, notes)
    : { picture: await panoramaOf(source, entry, options, notes) };
  const paths = new UniquePrimPaths();
  const texture = { name: entry, ...picture, filter: 'linear', wrapS: 'repeat', wrapT: 'clamp' } as const;
  const dome: DomeLight = {
    ...{ kind: 'dome', path: paths.of('', stemOf(entry)), color: [1, 1, 1], orientation: AHEAD },
    texture: texture as NonNullable<DomeLight['texture']>,
    ...(film && { film }),
  };
  const camera: SceneCamera = { path: paths.of('', 'Camera'), motion: restingAt([0, 0, 0]), fovY: FIELD_OF_VIEW };
  const scene = { name: stemOf(entry), objects: [], lights: [dome], cameras: [camera], diagnostics: notes.list() };
  return makeScene({ ...scene, ...rate, ...filmTimeOf(scene) });
}

async function panoramaOf(
  source: FileSource,
  entry: string,
  options: ReadOptions,
  notes: DiagnosticLog,
): Promise<PanoramaPicture> {
  const bytes = await source.read(entry);
  if (!bytes) throw inputError('file.missing', entry, msg`no such file`);
  const decoded = await decodePicture(bytes, entry, options);
  const coverage = await coverageOf(memoryFile(bytes), entry, notes);
  const lens = options.fisheye ?? fisheyeOf(bytes, entry);
  const layout = { ...(lens && { fisheye: lens }), ...(coverage && { coverage }) };
  const unfolded = unfoldedPicture(decoded, layout, entry, notes);
  if (unfolded) return unfolded;
  const { width, height } = decoded;
  const others = width === height ? faceFiles(entry) : [];
  if (others.length > 0) return unfoldedCube(await facesInFiles(source, entry, others, decoded, options));
  const size = msg`the picture is ${width} × ${height} pixels, and no panorama`;
  const forms = msg`one is twice as wide as high, or has six square faces: in a strip (6:1 or 1:6), a grid (3:2) or a cross (4:3 or 3:4, with empty corners), or in six files such as px.png, nx.png, py.png, ny.png, pz.png, nz.png`;
  throw inputError('panorama.size', entry, msg`${size}; ${forms}`);
}

/** The picture in a file; undefined if there is none. */
async function readPicture(
  source: FileSource,
  path: string,
  options: ReadOptions,
): Promise<PanoramaPicture | undefined> {
  const bytes = await source.read(path);
  return bytes && decodePicture(bytes, path, options);
}

async function decodePicture(
  bytes: Uint8Array,
  path: string,
  { decodePicture: decodeOther }: ReadOptions,
): Promise<PanoramaPicture> {
  const radiance = decodeRadiance(bytes, path);
  if (radiance) return { ...radiance, colorSpace: 'linear' };
  const kind = foreignKind(bytes);
  const image = kind && decodeOther ? await decodeForeign(bytes, kind, path, decodeOther) : decodeImage(bytes, path);
  const { width, height, data } = image;
  return { width, height, data, colorSpace: 'srgb' };
}

/** Of the ways in which the files may be named, the one of which most are there. */
async function facesInFiles(
  source: FileSource,
  entry: string,
  ways: readonly (readonly string[])[],
  known: PanoramaPicture,
  options: ReadOptions,
): Promise<CubeFaces> {
  let missing: readonly string[] = ways[0];
  for (const paths of ways) {
    const pictures: (PanoramaPicture | undefined)[] = [];
    for (const path of paths) pictures.push(path === entry ? known : await readPicture(source, path, options));
    const absent = paths.filter((_, i) => !pictures[i]);
    if (absent.length === 0) return sameFaces(entry, paths, pictures as readonly PanoramaPicture[]);
    if (absent.length < missing.length) missing = absent;
  }
  const message = msg`it is one of the six faces of a cube by its name, but there is no ${listed(missing)}; open all six together`;
  throw inputError('panorama.faces', entry, message);
}

/** Six squares of one size and kind. */
function sameFaces(entry: string, paths: readonly string[], pictures: readonly PanoramaPicture[]): CubeFaces {
  const [{ width: size, colorSpace }] = pictures;
  const odd = pictures.findIndex(
    (each) => each.width !== size || each.height !== size || each.colorSpace !== colorSpace,
  );
  if (odd >= 0) {
    const { width, height } = pictures[odd];
    const message = msg`the faces of a cube must be squares of one size and kind, but ${paths[odd]} has ${width} × ${height} pixels and ${paths[0]} has ${pictures[0].width} × ${pictures[0].height}`;
    throw inputError('panorama.faces', entry, message);
  }
  return pictures.map((picture) => ({ picture, left: 0, top: 0, size, turned: false })) as unknown as CubeFaces;
}
