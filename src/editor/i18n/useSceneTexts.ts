import { useEditorState } from '../state/context.tsx';
import { useTexts } from './i18n.ts';

interface SceneTexts {
  readonly title: string;
  readonly lookFor: string;
}

/** The title of a scene or project and what to look for: its file's own words; of the examples the page has them in its other language too. */
export function useSceneTexts(source: string, own: { readonly title?: string; readonly lookFor?: string }): SceneTexts {
  const { example } = useTexts();
  const name = source
    .slice(source.lastIndexOf('/') + 1)
    .replace(/\.slowlight\.json$/, '')
    .replace(/\.\w+$/, '');
  const translated = source.startsWith('examples/') ? example(name) : undefined;
  return translated ?? { title: own.title ?? name, lookFor: own.lookFor ?? '' };
}

/** The words of what is shown: the project's own, where it says what to look for, else those of its scene. */
export function useOpenedTexts(): SceneTexts {
  const { origin, source, title, lookFor } = useEditorState(({ pictureSource }) => pictureSource);
  const hints = useEditorState(({ picture }) => picture?.scene.hints);
  const speaks = lookFor !== undefined || source === '';
  return useSceneTexts(speaks ? origin : source, speaks ? { title, lookFor } : (hints ?? {}));
}
