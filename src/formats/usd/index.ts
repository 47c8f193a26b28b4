export type * from './layer.ts';
export { parseLayer } from './parser.ts';
export { readUsd } from './read.ts';
