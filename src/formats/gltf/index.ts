export { readGltf } from './read.ts';
