import { useCallback } from 'react';
import { createStore, useStore } from 'zustand';
import { LANGUAGES, type LanguageTag } from '../../messages/languages.ts';
import { type Translate, translate } from '../../messages/message.ts';
import { ENGLISH, type ExampleTexts, type Translation } from '../../messages/translation.ts';

/** The page's language. */
const languageStore = createStore<{ readonly language: LanguageTag; readonly translation: Translation }>(() => ({
  language: 'en',
  translation: ENGLISH,
}));

/** Rejects if the language cannot be loaded; the page then stays as it is. */
export async function setLanguage(language: LanguageTag): Promise<void> {
  languageStore.setState({ language, translation: await LANGUAGES[language].load() });
}

/** The texts of the page in its language; components re-render when it changes. */
export function useTexts(): {
  readonly t: Translate;
  readonly language: LanguageTag;
  /** Texts of an example in the page's language, where they are not those of its file. */
  readonly example: (name: string) => ExampleTexts | undefined;
} {
  const { language, translation } = useStore(languageStore);
  return {
    t: useCallback((text) => translate(text, translation.messages), [translation]),
    language,
    example: useCallback((name) => translation.examples[name], [translation]),
  };
}
