import { useEditorState } from '../state/context.tsx';
import { useTexts } from './languageStore.ts';

interface SceneTexts {
  readonly title: string;
  readonly lookFor: string;
}

/** Title and description of a scene or project: the file's own; for examples also in the page's other language. */
export function useSceneTexts(source: string, own: { readonly title?: string; readonly lookFor?: string }): SceneTexts {
  const { example } = useTexts();
  const name = source
    .slice(source.lastIndexOf('/') + 1)
    .replace(/\.slowlight\.json$/, '')
    .replace(/\.\w+$/, '');
  const translated = source.startsWith('examples/') ? example(name) : undefined;
  return translated ?? { title: own.title ?? name, lookFor: own.lookFor ?? '' };
}

/** Texts of the opened document: the project's own if it says what to look for, otherwise those of its scene. */
export function useOpenedTexts(): SceneTexts {
  const { origin, source, title, lookFor } = useEditorState(({ pictureSource }) => pictureSource);
  const hints = useEditorState(({ picture }) => picture?.scene.hints);
  const speaks = lookFor !== undefined || source === '';
  return useSceneTexts(speaks ? origin : source, speaks ? { title, lookFor } : (hints ?? {}));
}
