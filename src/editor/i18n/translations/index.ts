import { files } from './files.ts';
import { gltf } from './gltf.ts';
import { program } from './program.ts';
import { shaderText } from './shaderText.ts';
import type { MessageCatalogue } from './translateMessage.ts';
import { usd } from './usd.ts';

/** Joins of sentences, which have no words but these. */
const joiningPatterns = { '{}: {}': '{1}：{2}', '{} or {}': '{1} 或 {2}' };

/** What zod says of a project that is not as it should be. */
const zodMessages = {
  'Invalid input': '内容无效',
  'Invalid input: expected {}': '应为{1}',
  'Invalid input: expected {}, received {}': '应为{1}，而不是{2}',
  'Invalid option: expected one of {}': '应为以下之一：{1}',
  'Unrecognized key: {}': '没有 {1} 这一项',
  'Unrecognized keys: {}': '没有 {1} 这些项',
  'Invalid key in {}': '{1} 中有不允许的名称',
  'Too big: expected {} to have {}': '过大：{1}应有 {2}',
  'Too big: expected {} to be {}': '过大：{1}应为 {2}',
  'Too small: expected {} to have {}': '过小：{1}应有 {2}',
  'Too small: expected {} to be {}': '过小：{1}应为 {2}',
  record: '表',
  object: '对象',
  array: '列表',
  number: '数',
};

/**
 * What the program says of what it cannot do, and of what came of it, in Chinese. In the source a sentence is in English, where it arises; here it is
 * the key, with {} for each value, and {1} in the Chinese stands for the first of them. A test finds the sentences of the source that are missing here.
 */
export const translations: MessageCatalogue = {
  ...joiningPatterns,
  ...zodMessages,
  ...program,
  ...usd,
  ...gltf,
  ...files,
  ...shaderText,
};
