import { projectName } from '../projects/projectNames.ts';
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
  if (!translated) return { title: own.title ?? name, lookFor: own.lookFor ?? '' };
  const isRenamed = translated.of !== undefined && own.title !== undefined && own.title !== translated.of;
  return { title: isRenamed ? own.title! : translated.title, lookFor: translated.lookFor };
}

/** The project's name; of an example in the page's language, until the user gives it another. */
export function useProjectName(): string {
  const name = useEditorState(projectName);
  const { origin, document } = useEditorState(({ history }) => history);
  const { title } = useSceneTexts(origin, { title: name });
  return document.title ? title : name;
}

/** Texts of the opened document: the project's own if it says what to look for, otherwise those of its scene. */
export function useOpenedTexts(): SceneTexts {
  const { origin, source, title, lookFor } = useEditorState(({ pictureSource }) => pictureSource);
  const hints = useEditorState(({ picture }) => picture?.scene.hints);
  const speaks = lookFor !== undefined || source === '';
  return useSceneTexts(speaks ? origin : source, speaks ? { title, lookFor } : (hints ?? {}));
}
