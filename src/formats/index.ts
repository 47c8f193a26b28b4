export { type ExrChannel, type ExrImage, writeExr } from './exr.ts';
export { readExr } from './exrRead.ts';
export { readGltf } from './gltf/index.ts';
export { type DecodedImage, decodeImage } from './images.ts';
export { type OpenOptions, openScene } from './open.ts';
export { encodePng } from './png.ts';
export { formatOf, type ReadOptions, type SceneFormat, sceneFormats } from './registry.ts';
export { extensionOf, type FileSource, memorySource, normalizePath, resolvePath } from './source.ts';
export { parseLayer, readLayer, readUsd, writeTextures, writeUsda, writeUsdz } from './usd/index.ts';
