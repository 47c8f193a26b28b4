import { anyOf, listed } from '../messages/message.ts';
import { sceneFormats } from './registry.ts';

// Lists of the readable formats, for help, messages and the page.
const names = sceneFormats.map(({ shortName }) => shortName);

/** `USD, glTF, OBJ, PLY, STL` */
export const FORMAT_NAMES = listed(names);

/** `USD, glTF, OBJ, PLY or STL` */
export const ANY_FORMAT = anyOf(names);

/** `USD, glTF, .obj, .ply or .stl`: by extension if there is only one. */
export const ANY_FORMAT_FILE = anyOf(
  sceneFormats.map(({ shortName, extensions }) => (extensions.length > 1 ? shortName : `.${extensions[0]}`)),
);
