// vitest's global set-up of the projects that test the build, so that they can be run individually.
import { ensureBuilt } from './setup.mjs';

export const setup = () => ensureBuilt('lib', 'app', 'api');
