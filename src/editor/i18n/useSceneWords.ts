import { useStudioState } from '../state/context.tsx';
import { useTexts } from './i18n.ts';

interface Words {
  readonly title: string;
  readonly lookFor: string;
}

/** The title of a scene or project and what to look for: its file's own words; of the examples the page has them in its other language too. */
export function useSceneWords(source: string, own: { readonly title?: string; readonly lookFor?: string }): Words {
  const { example } = useTexts();
  const name = source
    .slice(source.lastIndexOf('/') + 1)
    .replace(/\.slowlight\.json$/, '')
    .replace(/\.\w+$/, '');
  const translated = source.startsWith('examples/') ? example(name) : undefined;
  return translated ?? { title: own.title ?? name, lookFor: own.lookFor ?? '' };
}

/** The words of what is shown: the project's own, where it says what to look for, else those of its scene. */
export function useOpenedWords(): Words {
  const { origin, source, title, lookFor } = useStudioState(({ opened }) => opened);
  const hints = useStudioState(({ picture }) => picture?.scene.hints);
  const speaks = lookFor !== undefined || source === '';
  return useSceneWords(speaks ? origin : source, speaks ? { title, lookFor } : (hints ?? {}));
}
