export { readStl } from './read.ts';
