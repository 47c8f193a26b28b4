import { useCallback } from 'react';
import { CancelledError, type Evaluation } from '../../graph/evaluate.ts';
import { NodeRefusal, type Problem } from '../../graph/nodeType.ts';
import { PictureTooLarge } from '../../nodes/drawing/largest.ts';
import type { ProjectFile } from '../../nodes/files.ts';
import { filesOf, writersIn } from '../../nodes/writers.ts';
import { type Translate, useTexts } from '../i18n/i18n.ts';
import type { Say } from '../i18n/sayings/sayer.ts';
import { fileName, projectName } from '../projects/names.ts';
import { type EditorServices, useServices } from '../services.tsx';
import { download } from '../shell/download.ts';
import { useStudio } from '../state/context.tsx';
import type { Studio } from '../state/studio.ts';
import type { MadeFile } from './make.ts';
import { NotHere } from './notHere.ts';
import { saving } from './saving.ts';

/** Makes the file that a node asks for, named as evaluations name it, and hands it to the person; one at a time. */
export function useSaveFile(): (node: string) => Promise<void> {
  const studio = useStudio();
  const { backend } = useServices();
  const { t, said } = useTexts();
  return useCallback(
    async (node) => {
      if (saving.getState().job) return;
      const abort = new AbortController();
      saving.setState({ job: { node, name: node, cancel: () => abort.abort() } });
      try {
        await save({ node, studio, backend, signal: abort.signal, t, said });
      } catch (error) {
        if (!(error instanceof CancelledError)) tell(studio, t, error);
      } finally {
        saving.setState({ job: undefined });
      }
    },
    [studio, backend, t, said],
  );
}

interface Errand extends Pick<EditorServices, 'backend'> {
  readonly node: string;
  readonly studio: Studio;
  readonly signal: AbortSignal;
  readonly t: Translate;
  readonly said: Say;
}

async function save({ node, studio, backend, signal, t, said }: Errand): Promise<void> {
  const { document } = studio.store.getState().history;
  const evaluation = await studio.evaluate(node, signal);
  const file = wanted(evaluation, filesOf(evaluation, writersIn(document)).get(node));
  const told = (change: { name?: string; part?: number }): void =>
    saving.setState(({ job }) => ({ job: job && { ...job, ...change } }));
  told({ name: file.name });
  // Few visits need it.
  const { makeFile } = await import('./make.ts');
  const made = await makeFile(file, { node, backend, signal, progress: (part) => told({ part }) });
  download(made.content, made.name);
  studio.notify({ kind: 'info', text: savedWords(made, { t, said }) });
}

const MOST_LOSSES = 4;

function savedWords({ name, losses = [] }: MadeFile, { t, said }: Pick<Errand, 't' | 'said'>): string {
  if (losses.length === 0) return t('notice.saved', { name });
  const more = losses.length > MOST_LOSSES ? ` (+ ${losses.length - MOST_LOSSES})` : '';
  return t('notice.savedLosing', { name, losses: losses.slice(0, MOST_LOSSES).map(said).join('; ') + more });
}

/** What a node asks for; else what keeps it from asking. */
function wanted({ target, results }: Evaluation, file: ProjectFile | undefined): ProjectFile {
  if (file) return file;
  const failed = [target, ...results.values()].find((result) => result.status === 'failed');
  if (failed?.status === 'failed') throw new NodeRefusal(failed.problem);
  throw new Error('the node asks for no file');
}

function tell(studio: Studio, t: Translate, error: unknown): void {
  if (error instanceof NotHere) {
    tellCommand(studio, (command) => t(error.why, { ...error.fill, command }), t);
    return;
  }
  if (error instanceof PictureTooLarge) {
    tellCommand(
      studio,
      (command) => `${t('picture.tooLarge', { ...error.fill })} ${t('notice.elsewhere', { command })}`,
      t,
    );
    return;
  }
  const { message, place, remedy }: Pick<Problem, 'message' | 'remedy'> & { place?: string } =
    error instanceof NodeRefusal ? error.problem : { message: error instanceof Error ? error.message : String(error) };
  studio.notify({ kind: 'error', text: message, ...(place && { place }), ...(remedy && { remedy }) });
}

/** How the command line makes it. */
function tellCommand(studio: Studio, words: (command: string) => string, t: Translate): void {
  const project = fileName(projectName(studio.store.getState()), '.slowlight.json');
  const command = `slowlight render ${/^[\w.-]+$/.test(project) ? project : `'${project.replaceAll("'", "'\\''")}'`}`;
  studio.notify({
    kind: 'error',
    text: words(command),
    action: { text: t('notice.copyCommand'), act: () => void navigator.clipboard.writeText(command) },
  });
}
