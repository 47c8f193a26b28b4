import i18next from 'i18next';
import { initReactI18next, useTranslation } from 'react-i18next';
import { isMessageKey, type MessageKey, messages } from './messages.ts';

export const LANGUAGES = ['en', 'zh'] as const;
export type Language = (typeof LANGUAGES)[number];

/** A text of the catalogue. */
export type Translate = (key: MessageKey, values?: Readonly<Record<string, string | number>>) => string;

const catalogue = (place: 0 | 1) =>
  Object.fromEntries(Object.entries(messages).map(([key, texts]) => [key, texts[place]]));

/** The language that a browser's list of preferences asks for. */
export const preferredLanguage = (wanted: readonly string[]): Language =>
  wanted.map((tag) => tag.slice(0, 2)).find((tag): tag is Language => tag === 'en' || tag === 'zh') ?? 'en';

export interface SceneWords {
  readonly title: string;
  readonly lookFor: string;
}

/** What the examples are called in languages other than their files' own; read with the language. */
const ofExamples: Partial<Record<Language, Readonly<Record<string, SceneWords>>>> = {};
const readExampleWords = async (language: Language): Promise<void> => {
  if (language === 'zh') ofExamples.zh ??= (await import('./exampleWords.ts')).exampleWords;
};

/** Undefined where the file's own words are to be shown. */
export const exampleWordsOf = (name: string, language: Language): SceneWords | undefined =>
  ofExamples[language]?.[name];

export async function startTranslation(language: Language): Promise<void> {
  await readExampleWords(language);
  await i18next.use(initReactI18next).init({
    lng: language,
    fallbackLng: 'en',
    resources: { en: { translation: catalogue(0) }, zh: { translation: catalogue(1) } },
    keySeparator: false,
    nsSeparator: false,
    interpolation: { escapeValue: false },
  });
}

export async function setLanguage(language: Language): Promise<void> {
  await readExampleWords(language);
  await i18next.changeLanguage(language);
}

/** The catalogue in the language of the page; the component is drawn again when it changes. */
export function useTexts(): {
  readonly t: Translate;
  readonly language: Language;
  readonly any: (key: string, values?: Readonly<Record<string, string>>) => string;
} {
  const { t, i18n } = useTranslation();
  return {
    t: (key, values) => t(key, values ?? {}),
    language: i18n.language === 'zh' ? 'zh' : 'en',
    /** For keys that come out of descriptions: what is not in the catalogue stands for itself. */
    any: (key, values) => (isMessageKey(key) ? t(key, values ?? {}) : key),
  };
}
