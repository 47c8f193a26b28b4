import i18next from 'i18next';
import { initReactI18next, useTranslation } from 'react-i18next';
import type { exampleWords } from './exampleWords.ts';
import type { MessageKey } from './messages.ts';
import { type Catalogue, type Say, sayer } from './sayings/sayer.ts';

export const LANGUAGES = ['en', 'zh'] as const;
export type Language = (typeof LANGUAGES)[number];

/** A text of the catalogue. */
export type Translate = (key: MessageKey, values?: Readonly<Record<string, string | number>>) => string;

interface Texts {
  readonly words: Readonly<Record<string, string>>;
  /** Of the examples, where they are not as their files have them. */
  readonly examples?: typeof exampleWords;
}

/** A page loads the language that it is in. */
const TEXTS: Readonly<Record<Language, () => Promise<Texts>>> = {
  en: () => import('./english.ts'),
  zh: () => import('./chinese.ts'),
};

/** Of sentences that arise in English, in the other languages; loaded after the page's own words, for nothing is said at first. */
const SAYINGS: Readonly<Partial<Record<Language, () => Promise<{ readonly sayings: Catalogue }>>>> = {
  zh: () => import('./sayings/index.ts'),
};
const sayers = new Map<Language, Say>();
const asItIs: Say = (sentence) => sentence;
/** Tells those who show sentences. */
const LEARNT = 'learnt';

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
    react: { bindI18n: `languageChanged ${LEARNT}` },
  });
  learn(language);
}

/** Rejects where the language cannot be loaded; the page stays as it is. */
export async function setLanguage(language: Language): Promise<void> {
  for (const [namespace, texts] of Object.entries(await resourcesOf(language))) {
    i18next.addResourceBundle(language, namespace, texts);
  }
  await i18next.changeLanguage(language);
  learn(language);
}

/** Until it is learnt, and where it cannot be loaded, sentences stay English. */
function learn(language: Language): void {
  if (sayers.has(language)) return;
  SAYINGS[language]?.().then(
    ({ sayings }) => {
      sayers.set(language, sayer(sayings));
      i18next.emit(LEARNT);
    },
    () => {},
  );
}

async function resourcesOf(language: Language): Promise<{ readonly translation: object; readonly examples: object }> {
  const { words, examples = {} } = await TEXTS[language]();
  return { translation: words, examples };
}

/** The catalogue in the language of the page; the component is drawn again when it changes. */
export function useTexts(): {
  readonly t: Translate;
  readonly language: Language;
  readonly any: (key: string, values?: Readonly<Record<string, string>>) => string;
  readonly said: Say;
  readonly example: (name: string) => (typeof exampleWords)[string] | undefined;
} {
  const { t, i18n } = useTranslation();
  const language = i18n.language === 'zh' ? 'zh' : 'en';
  return {
    t: (key, values) => t(key, values ?? {}),
    language,
    /** For keys that come out of descriptions: what is not in the catalogue stands for itself. */
    any: (key, values) => (i18n.exists(key) ? t(key, values ?? {}) : key),
    /** What the program says of its own accord, which arises in English. */
    said: sayers.get(language) ?? asItIs,
    /** What is said of an example scene or project, where its file does not say it in this language. */
    example: (name) => i18n.getResource(i18n.language, 'examples', name),
  };
}
