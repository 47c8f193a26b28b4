import { inEnglish, type LocalizedText, msg } from '../../src/messages/message.ts';
import type { Diagnostic } from '../../src/scene/types.ts';

/** `a.obj: line 2: no such material`, as users read it. */
export const inWords = ({ place, message }: Diagnostic): string => inEnglish(msg`${place}: ${message}`);

/** The English of a text that may be missing. */
export const english = (text: LocalizedText | undefined): string | undefined =>
  text === undefined ? undefined : inEnglish(text);

/** Matches, inside an expected value, a text whose English contains the words. */
export const saying = (words: string | RegExp) => ({
  words,
  asymmetricMatch: (text: LocalizedText | undefined): boolean => {
    const said = english(text);
    return said !== undefined && (typeof words === 'string' ? said.includes(words) : words.test(said));
  },
});
