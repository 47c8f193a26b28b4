export { readPanorama } from './read.ts';
