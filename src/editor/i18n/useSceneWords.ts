import { exampleWords } from './exampleWords.ts';
import { useTexts } from './i18n.ts';

interface Words {
  readonly title: string;
  readonly lookFor: string;
}

/** A scene's title and what to look for: its file's own words; of the examples the page has them in its other language too. */
export function useSceneWords(source: string, own: { readonly title?: string; readonly lookFor?: string }): Words {
  const { language } = useTexts();
  const name = source.slice(source.lastIndexOf('/') + 1).replace(/\.\w+$/, '');
  const translated = language === 'zh' && source.startsWith('examples/') ? exampleWords[name] : undefined;
  return translated ?? { title: own.title ?? name, lookFor: own.lookFor ?? '' };
}
