import { LANGUAGES, type LanguageTag } from '../../messages/languages.ts';
import { msg } from '../../messages/message.ts';
import { useEditor } from '../state/context.tsx';
import { loadPreferences, savePreferences } from '../state/preferences.ts';
import { setLanguage } from './languageStore.ts';

/** Changes the page's language, and keeps it. */
export function useChangeLanguage(): (tag: LanguageTag) => void {
  const editor = useEditor();
  return (tag) =>
    void setLanguage(tag).then(
      () => savePreferences({ ...loadPreferences(), language: tag }),
      () =>
        editor.notify({
          kind: 'error',
          text: msg`${LANGUAGES[tag].name} could not be loaded. Is the server still running?`,
        }),
    );
}
