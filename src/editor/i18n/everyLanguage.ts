import { words as chinese } from './chinese.ts';
import { words as english } from './english.ts';

/** A text in all languages, to be found by any of them; what is not in the catalogue stands for itself. */
export const inEveryLanguage = (key: string): string =>
  [english, chinese].map((words) => (Object.hasOwn(words, key) ? words[key] : key)).join(' ');
