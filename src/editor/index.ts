export { type StartOptions, startEditor } from './start.tsx';
