import { files } from './files.ts';
import { gltf } from './gltf.ts';
import { program } from './program.ts';
import { shaderText } from './shaderText.ts';
import type { MessageCatalogue } from './translateMessage.ts';
import { usd } from './usd.ts';

/** Patterns that join messages and have no words of their own. */
const joiningPatterns = { '{}: {}': '{1}：{2}', '{} or {}': '{1} 或 {2}' };

/** zod's messages about invalid projects. */
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
 * Chinese translations of messages that the program composes in English. Keys are the English texts with {} for each
 * value; {1} in the Chinese stands for the first value. A test finds messages of the source that are missing here.
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
