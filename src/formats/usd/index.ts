export type * from './layer.ts';
export { parseLayer } from './parser.ts';
export { readUsd } from './read.ts';
export { readLayer } from './readLayer.ts';
export { writeTextures, writeUsda, writeUsdz } from './write.ts';
