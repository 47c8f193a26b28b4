import { useCallback } from 'react';
import { CancelledError, type Evaluation } from '../../graph/evaluation/evaluator.ts';
import { type NodeProblem, NodeRefusal } from '../../graph/nodeType.ts';
import { fileNodesIn, requestedFiles } from '../../nodes/project/fileNodes.ts';
import type { RequestedFile } from '../../nodes/project/outputFiles.ts';
import { PictureTooLargeError } from '../../pipelines/maxSize.ts';
import { type Translate, useTexts } from '../i18n/i18n.ts';
import type { TranslateMessage } from '../i18n/translations/translateMessage.ts';
import { fileName, projectName } from '../projects/projectNames.ts';
import { type EditorServices, useServices } from '../services.tsx';
import { download } from '../shell/download.ts';
import { useEditor } from '../state/context.tsx';
import type { Editor } from '../state/editor.ts';
import type { MadeFile } from './makeFile.ts';
import { savingStore } from './savingState.ts';
import { UnsupportedInPage } from './unsupportedInPage.ts';

/** Makes the file that a node requests, given by its evaluation id, and downloads it; one at a time. */
export function useSaveFile(): (node: string) => Promise<void> {
  const editor = useEditor();
  const { backend } = useServices();
  const { t, translateMessage } = useTexts();
  return useCallback(
    async (node) => {
      if (savingStore.getState().job) return;
      const abort = new AbortController();
      savingStore.setState({ job: { node, name: node, cancel: () => abort.abort() } });
      try {
        await save({ node, editor, backend, signal: abort.signal, t, translateMessage });
      } catch (error) {
        if (!(error instanceof CancelledError)) notifyError(editor, t, error);
      } finally {
        savingStore.setState({ job: undefined });
      }
    },
    [editor, backend, t, translateMessage],
  );
}

interface SaveFileContext extends Pick<EditorServices, 'backend'> {
  readonly node: string;
  readonly editor: Editor;
  readonly signal: AbortSignal;
  readonly t: Translate;
  readonly translateMessage: TranslateMessage;
}

async function save({ node, editor, backend, signal, t, translateMessage }: SaveFileContext): Promise<void> {
  const { document } = editor.store.getState().history;
  const evaluation = await editor.evaluate(node, signal);
  const file = requireFile(evaluation, requestedFiles(evaluation, fileNodesIn(document)).get(node));
  const told = (change: { name?: string; part?: number }): void =>
    savingStore.setState(({ job }) => ({ job: job && { ...job, ...change } }));
  told({ name: file.name });
  // Loaded on demand.
  const { makeFile } = await import('./makeFile.ts');
  const made = await makeFile(file, { backend, signal, progress: (part) => told({ part }) });
  download(made.content, made.name);
  editor.notify({ kind: 'info', text: savedText(made, { t, translateMessage }) });
}

const MAX_LISTED_LOSSES = 4;

function savedText(
  { name, losses = [] }: MadeFile,
  { t, translateMessage }: Pick<SaveFileContext, 't' | 'translateMessage'>,
): string {
  if (losses.length === 0) return t('notice.saved', { name });
  const more = losses.length > MAX_LISTED_LOSSES ? ` (+ ${losses.length - MAX_LISTED_LOSSES})` : '';
  return t('notice.savedLosing', {
    name,
    losses: losses.slice(0, MAX_LISTED_LOSSES).map(translateMessage).join('; ') + more,
  });
}

/** The file that a node requests; throws what prevents it. */
function requireFile({ target, results }: Evaluation, file: RequestedFile | undefined): RequestedFile {
  if (file) return file;
  const failed = [target, ...results.values()].find((result) => result.status === 'failed');
  if (failed?.status === 'failed') throw new NodeRefusal(failed.problem);
  throw new Error('the node asks for no file');
}

function notifyError(editor: Editor, t: Translate, error: unknown): void {
  if (error instanceof UnsupportedInPage) {
    notifyCommand(editor, (command) => t(error.why, { ...error.fill, command }), t);
    return;
  }
  if (error instanceof PictureTooLargeError) {
    notifyCommand(
      editor,
      (command) => `${t('picture.tooLarge', { ...error.fill })} ${t('notice.elsewhere', { command })}`,
      t,
    );
    return;
  }
  const { message, place, remedy }: Pick<NodeProblem, 'message' | 'remedy'> & { place?: string } =
    error instanceof NodeRefusal ? error.problem : { message: error instanceof Error ? error.message : String(error) };
  editor.notify({ kind: 'error', text: message, ...(place && { place }), ...(remedy && { remedy }) });
}

/** Shows the equivalent command line. */
function notifyCommand(editor: Editor, words: (command: string) => string, t: Translate): void {
  const project = fileName(projectName(editor.store.getState()), '.slowlight.json');
  const command = `slowlight render ${/^[\w.-]+$/.test(project) ? project : `'${project.replaceAll("'", "'\\''")}'`}`;
  editor.notify({
    kind: 'error',
    text: words(command),
    action: { text: t('notice.copyCommand'), act: () => void navigator.clipboard.writeText(command) },
  });
}
