/**
 * Files of scenes and pictures: USD, glTF, OBJ, PLY, STL; panoramas; PNG, JPEG, EXR; zips; how pictures and MP4 films cover the sphere. Readers throw an
 * `InputError` that names file, place and value.
 *
 * @module slowlight/formats
 */

export { readSpectrumCsv } from './attributes/spectrumCsv.ts';
export { entryOf } from './entry.ts';
export { type FileSource, memorySource } from './files/fileSource.ts';
export type { FilmFrame, FilmFrames, OpenFilmFrames } from './film/filmFrames.ts';
export { FilmPanorama } from './film/filmPanorama.ts';
export { type DecodedImage, decodeImage } from './image/decodeImage.ts';
export { encodePng } from './image/encodePng.ts';
export { type ExrChannel, type ExrEnvmap, type ExrImage, writeExr } from './image/exr.ts';
export type { DecodePicture, ForeignKind } from './image/foreignPictures.ts';
export { readExr, type SizeCheck } from './image/readExr.ts';
export { type OpenOptions, openScene } from './open.ts';
export type { Interpolation, ReadOptions } from './readOptions.ts';
export { formatOf, panoramaFormat, type SceneFormat, sceneFormats } from './registry.ts';
export { saveScene } from './save.ts';
export { type FileEdit, sphericalMp4Edit, withSphericalMp4 } from './spherical/sphericalMp4.ts';
export { sphericalOf } from './spherical/sphericalOf.ts';
export { sphericalExr, withSphericalPng } from './spherical/sphericalPictures.ts';
export type { ExportedScene } from './write/exportMotion.ts';
export type { RandomAccessFile } from './zip/directory.ts';
export { memoryFile, zipSource } from './zip/zipSource.ts';
