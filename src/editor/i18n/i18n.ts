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
  /** Of the examples, where they are not as their files have them. */
  readonly examples?: typeof exampleTexts;
}

/** A page loads the language that it is in. */
const TEXT_LOADERS: Readonly<Record<Language, () => Promise<Texts>>> = {
  en: () => import('./english.ts'),
  zh: () => import('./chinese.ts'),
};

/** Of sentences that arise in English, in the other languages; loaded after the page's own words, for nothing is said at first. */
const TRANSLATION_LOADERS: Readonly<
  Partial<Record<Language, () => Promise<{ readonly translations: MessageCatalogue }>>>
> = {
  zh: () => import('./translations/index.ts'),
};
const messageTranslators = new Map<Language, TranslateMessage>();
const untranslated: TranslateMessage = (sentence) => sentence;
/** Tells those who show sentences. */
const TRANSLATIONS_LOADED = 'learnt';

/** The language that a browser's list of preferences asks for. */
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

/** Rejects where the language cannot be loaded; the page stays as it is. */
export async function setLanguage(language: Language): Promise<void> {
  for (const [namespace, texts] of Object.entries(await resourcesOf(language))) {
    i18next.addResourceBundle(language, namespace, texts);
  }
  await i18next.changeLanguage(language);
  loadTranslations(language);
}

/** Until it is learnt, and where it cannot be loaded, sentences stay English. */
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

/** The catalogue in the language of the page; the component is drawn again when it changes. */
export function useTexts(): {
  readonly t: Translate;
  readonly language: Language;
  readonly any: (key: string, values?: Readonly<Record<string, string>>) => string;
  readonly said: TranslateMessage;
  readonly example: (name: string) => (typeof exampleTexts)[string] | undefined;
} {
  const { t, i18n } = useTranslation();
  const language = i18n.language === 'zh' ? 'zh' : 'en';
  return {
    t: (key, values) => t(key, values ?? {}),
    language,
    /** For keys that come out of descriptions: what is not in the catalogue stands for itself. */
    any: (key, values) => (i18n.exists(key) ? t(key, values ?? {}) : key),
    /** What the program says of its own accord, which arises in English. */
    said: messageTranslators.get(language) ?? untranslated,
    /** What is said of an example scene or project, where its file does not say it in this language. */
    example: (name) => i18n.getResource(i18n.language, 'examples', name),
  };
}
