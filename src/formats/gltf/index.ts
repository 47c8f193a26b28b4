export { readGltf } from './read/read.ts';
