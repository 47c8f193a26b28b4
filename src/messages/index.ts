/**
 * Messages as data: a template in English with its values, translated where it is shown.
 *
 * @module slowlight/messages
 */

export { LANGUAGE_TAGS, LANGUAGES, type Language, type LanguageTag, preferredLanguage } from './languages.ts';
export { type Catalogue, inEnglish, type LocalizedText, type Message, msg, translate } from './message.ts';
export { MessageError, messageOf } from './messageError.ts';
export type { ExampleTexts, Translation } from './translation.ts';
