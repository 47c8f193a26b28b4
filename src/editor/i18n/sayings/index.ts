import { files } from './files.ts';
import { gltf } from './gltf.ts';
import { program } from './program.ts';
import { shaderText } from './shaderText.ts';
import { usd } from './usd.ts';

/** Joins of sentences, which have no words but these. */
const joins = { '{}: {}': '{1}：{2}', '{} or {}': '{1} 或 {2}' };

/**
 * What the program says of what it cannot do, and of what came of it, in Chinese. In the source a sentence is in English, where it arises; here it is
 * the key, with {} for each value, and {1} in the Chinese stands for the first of them. A test finds the sentences of the source that are missing here.
 */
export const sayings: Readonly<Record<string, string>> = {
  ...joins,
  ...program,
  ...usd,
  ...gltf,
  ...files,
  ...shaderText,
};
