export type * from './layer/layer.ts';
export { readUsd } from './read.ts';
export { readLayer } from './readLayer.ts';
export { parseLayer } from './text/parser.ts';
export { writeTextures, writeUsda, writeUsdc, writeUsdz } from './write/writeUsd.ts';
