import { resolvePath } from '../../formats/files/fileSource.ts';
import { type LocalFiles, parseLocalName, sceneName } from '../loading/localFiles.ts';
import { type EditorState, sourceOf } from '../state/editor.ts';

const PROJECT_EXTENSION = '.slowlight.json';

/** Whether a file name is that of a project (a node graph). */
export const isProject = (path: string): boolean => path.toLowerCase().endsWith(PROJECT_EXTENSION);

const depth = (path: string): number => path.split('/').length;

/** The project among files: the least deep one, then by name; hidden files are skipped. */
export const findProject = (paths: readonly string[]): string | undefined =>
  paths
    .filter((path) => isProject(path) && !/(^|\/)(\.|__MACOSX\/)/.test(path))
    .sort((a, b) => depth(a) - depth(b) || (a < b ? -1 : 1))[0];

/** Name of a project: the user's title, else its file's name, else its scene's. */
export function projectName({ history, pictureSource }: Pick<EditorState, 'history' | 'pictureSource'>): string {
  if (history.document.title) return history.document.title;
  const { origin } = history;
  const file = sceneName(origin);
  // In an archive: `yard.zip/project.slowlight.json`.
  const archive = /([^/]+)\.zip\/[^/]*$/i.exec(origin)?.[1];
  if (isProject(file)) return archive ?? file.slice(0, -PROJECT_EXTENSION.length);
  // If nothing could be displayed yet, the document's source counts.
  return sceneName(pictureSource.source || sourceOf(history.document)).replace(/\.\w+$/, '');
}

/** A file name that is valid on all systems. */
export const fileName = (name: string, ending: string): string =>
  `${
    name
      .replace(/[\\/:*?"<>|\p{Cc}\s]+/gu, ' ')
      .trim()
      .slice(0, 80) || 'project'
  }${ending}`;

/**
 * The name under which a saved project refers to a scene of this session: `local:3/set/scene.usda` → `set/scene.usda`;
 * files in the project's folder or archive (`origin`) by their path relative to it; entries of another archive in the
 * command line's notation, `set.zip[scene.usda]`.
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

/** The inverse: path of the file that a project at `path` calls `name`. */
export const importedPath = (path: string, name: string): string =>
  resolvePath(path, name.replace(/^(.*?\.zip)\[(.*)\]$/i, '$1/$2'));

/** The file of this session that a name typed into a project means: one beside the project, else one opened under that name; other names stay. */
export function namedFile(name: string, origin: string, local: LocalFiles): string {
  const home = parseLocalName(origin)?.rest.slice(1);
  const beside = home === undefined ? name : importedPath(home, name);
  return home !== undefined && local.paths(origin).includes(beside)
    ? local.sibling(origin, beside)
    : (local.find(importedPath('', name)) ?? name);
}
