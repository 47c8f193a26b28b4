// vitest's global set-up of the projects that run what is built, so that they can also be run by themselves.
import { ensureBuilt } from './setup.mjs';

export const setup = () => ensureBuilt('lib', 'app');
