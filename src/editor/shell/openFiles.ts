import { entryOf } from '../../formats/entry.ts';
import { ANY_FORMAT } from '../../formats/formatLists.ts';
import { msg } from '../../messages/message.ts';
import { readNodeParams, readSource } from '../../nodes/project/outputChain.ts';
import { setParamCommand } from '../../nodes/project/projectCommands.ts';
import { type LocalFiles, sceneName } from '../loading/localFiles.ts';
import { missingPaths, suppliesMissingFiles } from '../loading/missingFiles.ts';
import type { PickedFiles } from '../loading/pickedFiles.ts';
import { expandArchives, type UserFiles } from '../loading/userFiles.ts';
import { findProject } from '../projects/projectNames.ts';
import { openErrorOf, projectFromFiles } from '../projects/projectSource.ts';
import type { Editor, EditorState } from '../state/editor.ts';

/**
 * Opens files that the user chose or dropped: a project among them, with the others as its files; files that the open
 * scene lacks, or files without a scene, are added to the open scene; otherwise the best scene among them.
 */
export async function openFiles(picked: PickedFiles, editor: Editor, localFiles: LocalFiles): Promise<void> {
  try {
    await take(await expandArchives(picked), editor, localFiles);
  } catch (error) {
    const name = findProject([...picked.keys()]) ?? [...picked.keys()][0] ?? '';
    editor.notify({ kind: 'error', ...openErrorOf(name, error) });
  }
}

async function take(files: UserFiles, editor: Editor, localFiles: LocalFiles): Promise<void> {
  const paths = [...files.keys()];
  const project = findProject(paths);
  if (project !== undefined) return editor.openProject(await projectFromFiles(files, project, localFiles));
  const state = editor.store.getState();
  const lacking = missingFilesOf(state, paths);
  const entry = entryOf(paths);
  if (lacking.length > 0) {
    const commands = lacking.map(({ node, source }) =>
      setParamCommand(state.history.document, node, 'source', localFiles.addToSet(source, files)),
    );
    editor.edit({ kind: 'batch', commands }, msg`add missing files`);
  } else if (entry) editor.open(localFiles.add(files, entry));
  else if (files.size > 0)
    editor.notify({
      kind: 'error',
      text: msg`None of these files is a scene. Drop a ${ANY_FORMAT} file, a panorama, or a folder or zip that contains one.`,
    });
}

/**
 * The nodes whose scenes lack some of the files: the node that could not be read; otherwise, since missing files are
 * reported for all scenes of the picture together, all reading nodes. Empty if the files are unrelated.
 */
function missingFilesOf({ picture, history, unreadableNode: refused }: EditorState, paths: readonly string[]) {
  const missing = missingPaths(picture?.scene.diagnostics ?? []);
  const isRefused = refused !== undefined;
  return Object.entries(readNodeParams(history.document)).flatMap(([node, params]) => {
    const source = readSource(params);
    if (source === '' || (isRefused && node !== refused)) return [];
    return suppliesMissingFiles(paths, { name: sceneName(source), missing, failed: isRefused })
      ? [{ node, source }]
      : [];
  });
}
