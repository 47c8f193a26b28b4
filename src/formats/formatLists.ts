import type { Words } from '../scene/settings/setting.ts';
import { sceneFormats } from './registry.ts';

/** `a, b or c`; at least one. */
export const alternatives = (words: readonly string[], separator = ', ', last = ' or '): string =>
  [words.slice(0, -1).join(separator), words.at(-1)].filter(Boolean).join(last);

// Lists of the readable formats, for help, messages and the page.
const names = sceneFormats.map(({ shortName }) => shortName);

/** `USD, glTF, OBJ, PLY, STL` */
export const FORMAT_NAMES: Words = [names.join(', '), names.join('、')];

/** `USD, glTF, OBJ, PLY or STL` */
export const ANY_FORMAT: Words = [alternatives(names), alternatives(names, '、', ' 或 ')];

/** `USD, glTF, .obj, .ply or .stl`: by extension if there is only one. */
export const ANY_FORMAT_FILE = alternatives(
  sceneFormats.map(({ shortName, extensions }) => (extensions.length > 1 ? shortName : `.${extensions[0]}`)),
);
