import { ENGLISH, type Translation } from './translation.ts';

/** A language of the program. */
export interface Language {
  /** In the language itself. */
  readonly name: string;
  /** BCP 47, for documents and dates. */
  readonly locale: string;
  /** Gives all its texts. */
  readonly load: () => Promise<Translation>;
}

/** All languages, by their tags. English is in the code; each other is one file, which is loaded when it is wanted. */
const LANGUAGE_LIST = {
  en: { name: 'English', locale: 'en-GB', load: async () => ENGLISH },
  zh: { name: '中文', locale: 'zh-CN', load: async () => (await import('./languages/chinese.ts')).chinese },
} as const satisfies Readonly<Record<string, Language>>;
/** The tag of a language: `en`, `zh`. */
export type LanguageTag = keyof typeof LANGUAGE_LIST;
/**
 * All languages by tag.
 * @example
 * const { messages } = await LANGUAGES.zh.load();
 * messages['at rest']; // '静止'
 */
export const LANGUAGES: Readonly<Record<LanguageTag, Language>> = LANGUAGE_LIST;
/**
 * The tags of all languages, in the order of menus.
 * @example
 * LANGUAGE_TAGS; // ['en', …]
 */
export const LANGUAGE_TAGS = Object.keys(LANGUAGE_LIST) as readonly LanguageTag[];

export const isLanguageTag = (tag: unknown): tag is LanguageTag =>
  typeof tag === 'string' && Object.hasOwn(LANGUAGE_LIST, tag);

/**
 * The first of the wanted locales (`zh-CN`, `de_AT.UTF-8`) whose language is here; English if none is.
 * @example
 * preferredLanguage(['fr-FR', 'zh-CN', 'en']); // 'zh'
 */
export const preferredLanguage = (wanted: readonly string[]): LanguageTag =>
  wanted.map((locale) => /^[a-z]+/.exec(locale.toLowerCase())?.[0]).find(isLanguageTag) ?? 'en';
