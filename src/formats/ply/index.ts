export { readPly } from './read.ts';
