import { resolvePath } from '../../formats/files/fileSource.ts';
import { parseLocalName, sceneName } from '../loading/localFiles.ts';
import { type EditorState, sourceOf } from '../state/editor.ts';

const PROJECT_EXTENSION = '.slowlight.json';

/** A project, which is a node graph, by its name. */
export const isProject = (path: string): boolean => path.toLowerCase().endsWith(PROJECT_EXTENSION);

const depth = (path: string): number => path.split('/').length;

/** The project among files: the least deep, then by name. Hidden files are none. */
export const findProject = (paths: readonly string[]): string | undefined =>
  paths
    .filter((path) => isProject(path) && !/(^|\/)(\.|__MACOSX\/)/.test(path))
    .sort((a, b) => depth(a) - depth(b) || (a < b ? -1 : 1))[0];

/** What the project is called: by the person, else after the file that it came from, else after its scene. */
export function projectName({ history, pictureSource }: Pick<EditorState, 'history' | 'pictureSource'>): string {
  if (history.document.title) return history.document.title;
  const { origin } = history;
  const file = sceneName(origin);
  // Of an archive: `yard.zip/project.slowlight.json`.
  const archive = /([^/]+)\.zip\/[^/]*$/i.exec(origin)?.[1];
  if (isProject(file)) return archive ?? file.slice(0, -PROJECT_EXTENSION.length);
  // What could not be shown was never opened.
  return sceneName(pictureSource.source || sourceOf(history.document)).replace(/\.\w+$/, '');
}

/** A name that every system takes for a file. */
export const fileName = (name: string, ending: string): string =>
  `${
    name
      .replace(/[\\/:*?"<>|\p{Cc}\s]+/gu, ' ')
      .trim()
      .slice(0, 80) || 'project'
  }${ending}`;

/**
 * What a project's file calls a scene of this session: `local:3/set/scene.usda` → `set/scene.usda`, what lies with the project in its folder
 * or archive (`origin`) by its path from there, what lies in another archive as the command line has it, `set.zip[scene.usda]`.
 */
export function exportedName(source: string, origin: string): string {
  const local = parseLocalName(source);
  if (!local) return source;
  const path = local.rest.slice(1);
  if (local.rest.startsWith('@')) return path;
  const home = parseLocalName(origin);
  const folder = home?.id.split('.')[0] === local.id.split('.')[0] ? home.rest.slice(1).replace(/[^/]*$/, '') : '';
  if (folder && path.startsWith(folder)) return path.slice(folder.length);
  return path.replace(/^(.*?\.zip)\/(.*)$/i, '$1[$2]');
}

/** Where a file is that a project at `path` calls `name`, among files by their paths: the other way round. */
export const importedPath = (path: string, name: string): string =>
  resolvePath(path, name.replace(/^(.*?\.zip)\[(.*)\]$/i, '$1/$2'));
