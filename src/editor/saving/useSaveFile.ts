import { useCallback } from 'react';
import { CancelledError, type Evaluation } from '../../graph/evaluation/evaluator.ts';
import { type NodeProblem, NodeRefusal } from '../../graph/nodeType.ts';
import { inClauses, type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import { fileNodesIn, requestedFiles } from '../../nodes/project/fileNodes.ts';
import type { RequestedFile } from '../../nodes/project/outputFiles.ts';
import { PictureTooLargeError } from '../../pipelines/maxSize.ts';
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
  return useCallback(
    (node) => saveFile({ node, editor, backend, request: (signal) => requestOf(editor, node, signal) }),
    [editor, backend],
  );
}

interface SaveFileContext extends Pick<EditorServices, 'backend'> {
  /** Who requests the file. */
  readonly node: string;
  readonly editor: Editor;
  readonly request: (signal: AbortSignal) => RequestedFile | Promise<RequestedFile>;
}

/** Makes a file with progress, and downloads it; does nothing while another is made. */
export async function saveFile(context: SaveFileContext): Promise<void> {
  const { node, editor } = context;
  const { job, refusal } = savingStore.getState();
  if (job) return;
  if (refusal !== undefined) editor.dismiss(refusal);
  const abort = new AbortController();
  savingStore.setState({ job: { node, name: node, cancel: () => abort.abort() } });
  try {
    await save(context, abort.signal);
  } catch (error) {
    if (!(error instanceof CancelledError)) savingStore.setState({ refusal: notifyError(editor, error) });
  } finally {
    savingStore.setState({ job: undefined });
  }
}

async function requestOf(editor: Editor, node: string, signal: AbortSignal): Promise<RequestedFile> {
  const { document } = editor.store.getState().history;
  const evaluation = await editor.evaluate(node, signal);
  return requireFile(evaluation, requestedFiles(evaluation, fileNodesIn(document)).get(node));
}

async function save({ editor, backend, request }: SaveFileContext, signal: AbortSignal): Promise<void> {
  const file = await request(signal);
  const told = (change: { name?: string; part?: number }): void =>
    savingStore.setState(({ job }) => ({ job: job && { ...job, ...change } }));
  told({ name: file.name });
  // Loaded on demand.
  const { makeFile } = await import('./makeFile.ts');
  const made = await makeFile(file, { backend, signal, progress: (part) => told({ part }) });
  download(made.content, made.name);
  editor.notify({ kind: 'info', text: savedText(made) });
}

const MAX_LISTED_LOSSES = 4;

function savedText({ name, losses = [] }: MadeFile): Message {
  if (losses.length === 0) return msg`Saved ${name}`;
  const more = losses.length > MAX_LISTED_LOSSES ? ` (+ ${losses.length - MAX_LISTED_LOSSES})` : '';
  const list = inClauses(losses.slice(0, MAX_LISTED_LOSSES));
  return msg`Saved ${name}, which cannot represent everything: ${list}${more}`;
}

/** The file that a node requests; throws what prevents it. */
function requireFile({ target, results }: Evaluation, file: RequestedFile | undefined): RequestedFile {
  if (file) return file;
  const failed = [target, ...results.values()].find((result) => result.status === 'failed');
  if (failed?.status === 'failed') throw new NodeRefusal(failed.problem);
  throw new MessageError(msg`the node asks for no file`);
}

/** Returns the notice. */
function notifyError(editor: Editor, error: unknown): number {
  if (error instanceof UnsupportedInPage) return notifyCommand(editor, error.remedy);
  if (error instanceof PictureTooLargeError) {
    return notifyCommand(
      editor,
      (command) => msg`${error.text} Or save the project and run it where a larger device is available: ${command}`,
    );
  }
  const { message, place, remedy }: Pick<NodeProblem, 'message' | 'remedy'> & { place?: LocalizedText } =
    error instanceof NodeRefusal ? error.problem : { message: messageOf(error) };
  return editor.notify({ kind: 'error', text: message, ...(place && { place }), ...(remedy && { remedy }) });
}

/** Shows the equivalent command line. */
function notifyCommand(editor: Editor, words: (command: string) => Message): number {
  const project = fileName(projectName(editor.store.getState()), '.slowlight.json');
  const command = `slowlight render ${/^[\w.-]+$/.test(project) ? project : `'${project.replaceAll("'", "'\\''")}'`}`;
  return editor.notify({
    kind: 'error',
    text: words(command),
    action: { text: msg`Copy the command`, act: () => void navigator.clipboard.writeText(command) },
  });
}
