import type { Texture } from '../../src/scene/types.ts';
import { checkeredCube } from './checkeredCube.ts';

/** Every panorama that is painted here, by file name. */
export const panoramas: Readonly<Record<string, () => Texture>> = { 'checkered-cube': checkeredCube };
