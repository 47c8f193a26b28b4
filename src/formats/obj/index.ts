export { readObj } from './read.ts';
