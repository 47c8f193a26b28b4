import { isLanguageTag, LANGUAGES, type LanguageTag, preferredLanguage } from '../../messages/languages.ts';
import { type LocalizedText, translate } from '../../messages/message.ts';
import { ENGLISH, type Translation } from '../../messages/translation.ts';

let translation: Translation = ENGLISH;

/** Sets the language of everything that is printed from now on; English before. */
export async function setLanguage(tag: LanguageTag): Promise<void> {
  translation = await LANGUAGES[tag].load();
}

/** A text in the user's language. */
export const localized = (text: LocalizedText): string => translate(text, translation.messages);

/** The language of `--lang`, if it names one, else that of the environment. */
export const chosenLanguage = (flag: unknown, environment: NodeJS.ProcessEnv): LanguageTag =>
  isLanguageTag(flag) ? flag : preferredLanguage(environmentLocales(environment));

/**
 * Locales of the environment, the preferred first, as gettext finds them: LC_ALL, LC_MESSAGES or LANG, the first that is
 * set; LANGUAGE, a list, comes before it, unless it is C or POSIX.
 * https://www.gnu.org/software/gettext/manual/html_node/Locale-Environment-Variables.html
 */
function environmentLocales({ LC_ALL, LC_MESSAGES, LANG, LANGUAGE }: NodeJS.ProcessEnv): readonly string[] {
  const locale = LC_ALL || LC_MESSAGES || LANG || 'C';
  if (/^(C|POSIX)(\.|$)/.test(locale)) return [];
  return LANGUAGE ? LANGUAGE.split(':') : [locale];
}
