export { writeCrate } from './crate/write/writeCrate.ts';
export type * from './layer/layer.ts';
export { readUsd } from './read.ts';
export { readLayer } from './readLayer.ts';
export { parseLayer } from './text/parser.ts';
export { sceneLayer } from './write/sceneLayer.ts';
export { writeTextures, writeUsda, writeUsdc, writeUsdz } from './write/writeUsd.ts';
