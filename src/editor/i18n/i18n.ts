import i18next from 'i18next';
import { initReactI18next, useTranslation } from 'react-i18next';
import type { exampleTexts } from './exampleTexts.ts';
import type { TextKey } from './texts.ts';
import { type MessageCatalogue, messageTranslator, type TranslateMessage } from './translations/translateMessage.ts';

export const LANGUAGES = ['en', 'zh'] as const;
export type Language = (typeof LANGUAGES)[number];

/** A text of the catalogue. */
export type Translate = (key: TextKey, values?: Readonly<Record<string, string | number>>) => string;

interface Texts {
  readonly words: Readonly<Record<string, string>>;
  /** Example texts, in languages other than that of the files. */
  readonly examples?: typeof exampleTexts;
}

/** Only the page's language is loaded. */
const TEXT_LOADERS: Readonly<Record<Language, () => Promise<Texts>>> = {
  en: () => import('./english.ts'),
  zh: () => import('./chinese.ts'),
};

/** Translations of messages that are composed in English; loaded after the UI texts, since none is shown at first. */
const TRANSLATION_LOADERS: Readonly<
  Partial<Record<Language, () => Promise<{ readonly translations: MessageCatalogue }>>>
> = {
  zh: () => import('./translations/index.ts'),
};
const messageTranslators = new Map<Language, TranslateMessage>();
const untranslated: TranslateMessage = (sentence) => sentence;
/** Event: translations have been loaded. */
const TRANSLATIONS_LOADED = 'learnt';

/** The best language for a browser's list of preferences. */
export const preferredLanguage = (wanted: readonly string[]): Language =>
  wanted.map((tag) => tag.slice(0, 2)).find((tag): tag is Language => tag === 'en' || tag === 'zh') ?? 'en';

export async function startTranslation(language: Language): Promise<void> {
  await i18next.use(initReactI18next).init({
    lng: language,
    fallbackLng: false,
    resources: { [language]: await resourcesOf(language) },
    keySeparator: false,
    nsSeparator: false,
    interpolation: { escapeValue: false },
    react: { bindI18n: `languageChanged ${TRANSLATIONS_LOADED}` },
  });
  loadTranslations(language);
}

/** Rejects if the language cannot be loaded; the page then stays as it is. */
export async function setLanguage(language: Language): Promise<void> {
  for (const [namespace, texts] of Object.entries(await resourcesOf(language))) {
    i18next.addResourceBundle(language, namespace, texts);
  }
  await i18next.changeLanguage(language);
  loadTranslations(language);
}

/** Messages stay in English until translations are loaded, or if they cannot be. */
function loadTranslations(language: Language): void {
  if (messageTranslators.has(language)) return;
  TRANSLATION_LOADERS[language]?.().then(
    ({ translations }) => {
      messageTranslators.set(language, messageTranslator(translations));
      i18next.emit(TRANSLATIONS_LOADED);
    },
    () => {},
  );
}

async function resourcesOf(language: Language): Promise<{ readonly translation: object; readonly examples: object }> {
  const { words, examples = {} } = await TEXT_LOADERS[language]();
  return { translation: words, examples };
}

/** The UI texts in the current language; components re-render when it changes. */
export function useTexts(): {
  readonly t: Translate;
  readonly language: Language;
  readonly textOrKey: (key: string, values?: Readonly<Record<string, string>>) => string;
  readonly translateMessage: TranslateMessage;
  readonly example: (name: string) => (typeof exampleTexts)[string] | undefined;
} {
  const { t, i18n } = useTranslation();
  const language = i18n.language === 'zh' ? 'zh' : 'en';
  return {
    t: (key, values) => t(key, values ?? {}),
    language,
    /** For keys from node descriptions: a text that is not in the catalogue is returned as it is. */
    textOrKey: (key, values) => (i18n.exists(key) ? t(key, values ?? {}) : key),
    /** Translates a message that the program composed in English. */
    translateMessage: messageTranslators.get(language) ?? untranslated,
    /** Text of an example where its file has none in this language. */
    example: (name) => i18n.getResource(i18n.language, 'examples', name),
  };
}
