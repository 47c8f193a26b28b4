import { words as chinese } from './chinese.ts';
import { words as english } from './english.ts';

/** A text in all languages, for search; keys that are not in the catalogue are returned as they are. */
export const inEveryLanguage = (key: string): string =>
  [english, chinese].map((words) => (Object.hasOwn(words, key) ? words[key] : key)).join(' ');
