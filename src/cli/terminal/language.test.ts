import { afterEach, expect, test } from 'vitest';
import { inLines, msg } from '../../messages/message.ts';
import { chosenLanguage, localized, setLanguage } from './language.ts';

afterEach(() => setLanguage('en'));

test.each([
  [undefined, {}, 'en'],
  [undefined, { LANG: 'zh_CN.UTF-8' }, 'zh'],
  [undefined, { LANG: 'fr_FR.UTF-8' }, 'en'],
  [undefined, { LANG: 'en_GB.UTF-8', LC_MESSAGES: 'zh_CN' }, 'zh'],
  [undefined, { LC_MESSAGES: 'en_GB.UTF-8', LC_ALL: 'zh_CN' }, 'zh'],
  [undefined, { LANG: 'zh_CN.UTF-8', LC_ALL: '' }, 'zh'],
  [undefined, { LANG: 'zh_CN.UTF-8', LC_CTYPE: 'en_GB' }, 'zh'],
  [undefined, { LC_ALL: 'de_DE.UTF-8', LANGUAGE: 'fr:zh_CN:en' }, 'zh'],
  [undefined, { LC_ALL: 'zh_CN.UTF-8', LANGUAGE: 'en:zh' }, 'en'],
  [undefined, { LANG: 'zh_CN.UTF-8', LANGUAGE: 'fr' }, 'en'],
  // Programs that set C want what they can parse.
  [undefined, { LC_ALL: 'C', LANGUAGE: 'zh', LANG: 'zh_CN.UTF-8' }, 'en'],
  [undefined, { LC_ALL: 'C.UTF-8', LANGUAGE: 'zh' }, 'en'],
  [undefined, { LANGUAGE: 'zh' }, 'en'],
  ['zh', { LC_ALL: 'C' }, 'zh'],
  ['en', { LC_ALL: 'zh_CN.UTF-8', LANGUAGE: 'zh' }, 'en'],
  // The error about it is in the language of the environment.
  ['fr', { LANG: 'zh_CN.UTF-8' }, 'zh'],
  [true, {}, 'en'],
])('--lang %s with %o is %s', (flag, environment, language) => {
  expect(chosenLanguage(flag, environment)).toBe(language);
});

test('lines are in the language that was set last', async () => {
  const lines = inLines([msg`done`, 'a.png', msg`an internal error`]);
  expect(localized(lines)).toBe('done\na.png\nan internal error');
  await setLanguage('zh');
  expect(localized(lines)).toBe('完成\na.png\n内部错误');
});
