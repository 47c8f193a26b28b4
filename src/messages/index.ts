export { LANGUAGE_TAGS, LANGUAGES, type Language, type LanguageTag, preferredLanguage } from './languages.ts';
export { type Catalogue, inEnglish, type LocalizedText, type Message, msg, translate } from './message.ts';
export { MessageError, messageOf } from './messageError.ts';
export type { ExampleTexts, Translation } from './translation.ts';
