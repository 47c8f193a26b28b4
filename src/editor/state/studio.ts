import { createStore, type StoreApi } from 'zustand/vanilla';
import { type Command, CommandError } from '../../graph/commands.ts';
import type { GraphDocument, GraphNode, ParamValue } from '../../graph/document.ts';
import { inside } from '../../graph/edits/fragment.ts';
import { placeOf } from '../../graph/edits/place.ts';
import { CancelledError, type Evaluation, Evaluator } from '../../graph/evaluate.ts';
import { endGesture, execute, type History, newHistory, redo, undo } from '../../graph/history.ts';
import type { Problem } from '../../graph/nodeType.ts';
import type { Picture } from '../../nodes/define.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { pictureOf } from '../../nodes/picture.ts';
import { newProject, openCommand } from '../../nodes/project.ts';
import type { Services } from '../../nodes/services.ts';
import type { Backend } from '../../render/settings.ts';
import type { Lock } from '../flight/flight.ts';
import { heavyWorkers } from './heavyWorkers.ts';

export interface Loading {
  readonly source: string;
  /** 0 … 1; undefined where it cannot be known. */
  readonly part: number | undefined;
  readonly stage: 'fetch' | 'parse';
}

export interface Notice {
  readonly id: number;
  readonly kind: 'error' | 'info';
  readonly text: string;
  readonly place?: string;
  readonly remedy?: Problem['remedy'];
  /** Of the evaluation: goes away when the problem does. */
  readonly ofDocument: boolean;
}

export type Graphics = Backend | 'starting' | 'recovering' | 'failed';

/** Everything the page shows. The document changes by commands alone; the rest is how it is being looked at. */
export interface StudioState {
  readonly history: History;
  /** The last good one: it stays while an edit cannot be evaluated. */
  readonly picture?: Picture;
  /** The file that `picture` was made of. */
  readonly openSource: string;
  /** How it was read: the parameters of the node that did. */
  readonly openRead?: GraphNode['params'];
  readonly loading?: Loading;
  readonly notices: readonly Notice[];
  readonly graphics: Graphics;
  readonly lock: Lock;
  readonly cruise: boolean;
  readonly playing: boolean;
  readonly loop: boolean;
  readonly dialog?: 'gallery' | 'help';
  /** Only the picture is shown, without the panels. */
  readonly maximized: boolean;
}

export interface Studio {
  readonly store: StoreApi<StudioState>;
  readonly edit: (command: Command, label: string, gesture?: string) => void;
  /** `node`: as an evaluation names it, in groups by `outer/inner`. */
  readonly set: (node: string, param: string, value: ParamValue | undefined, label: string, gesture?: string) => void;
  readonly endGesture: () => void;
  readonly undo: () => void;
  readonly redo: () => void;
  readonly open: (source: string) => void;
  /** Stops reading; the scene before it stays, and the document goes back to it. */
  readonly cancelLoading: () => void;
  readonly notify: (notice: Omit<Notice, 'id' | 'ofDocument'>) => void;
  readonly dismiss: (id: number) => void;
  readonly change: (change: Partial<Omit<StudioState, 'history' | 'picture' | 'loading' | 'notices'>>) => void;
}

export interface StudioOptions {
  readonly services: Services;
  readonly source: string;
  readonly playing: boolean;
}

/** The state of the page, around one document. */
export function createStudio({ services, source, playing }: StudioOptions): Studio {
  const store = createStore<StudioState>(() => ({
    history: newHistory(newProject(source)),
    openSource: '',
    notices: [],
    graphics: 'starting',
    lock: 'free',
    cruise: false,
    playing,
    loop: true,
    maximized: false,
  }));
  const evaluation = evaluating(store, services);
  const go = (next: (history: History) => History): void => {
    const { history } = store.getState();
    const changed = next(history);
    store.setState({ history: changed });
    if (changed.document !== history.document) evaluation.update();
  };
  const edit: Studio['edit'] = (command, label, gesture) => {
    try {
      go((history) => execute(history, command, label, gesture));
    } catch (error) {
      if (!(error instanceof CommandError)) throw error;
      addNotice(store, { kind: 'error', text: error.message, ofDocument: false });
    }
  };
  evaluation.update();
  return {
    store,
    edit,
    set: (id, param, value, label, gesture) => {
      const { group, node } = placeOf(store.getState().history.document, id) ?? { node: id };
      const change = { kind: 'set-param', node, param, ...(value === undefined ? {} : { value }) } as const;
      edit(inside(group, change), label, gesture);
    },
    endGesture: () => go(endGesture),
    undo: () => go(undo),
    redo: () => go(redo),
    open: (file) => edit(openCommand(store.getState().history.document, file), 'edit.open'),
    cancelLoading: () => {
      evaluation.cancel();
      const { history, openRead } = store.getState();
      if (!openRead || isSame(readOf(history.document), openRead)) return;
      if (isSame(readOf(undo(history).document), openRead)) go(undo);
      else edit(readAgain(history.document, openRead), 'edit.open');
    },
    notify: (notice) => addNotice(store, { ...notice, ofDocument: false }),
    dismiss: (id) => store.setState(({ notices }) => ({ notices: notices.filter((notice) => notice.id !== id) })),
    change: (change) => store.setState(change),
  };
}

const readOf = (document: GraphDocument): GraphNode['params'] => document.nodes.read?.params ?? {};
const isSame = (a: GraphNode['params'], b: GraphNode['params']): boolean => JSON.stringify(a) === JSON.stringify(b);

/** Sets the reading node to what it was. */
const readAgain = (document: GraphDocument, before: GraphNode['params']): Command => ({
  kind: 'batch',
  commands: [...new Set([...Object.keys(readOf(document)), ...Object.keys(before)])].map((param) => {
    const value = before[param];
    return { kind: 'set-param', node: 'read', param, ...(value === undefined ? {} : { value }) };
  }),
});

export const sourceOf = (document: GraphDocument): string => String(document.nodes.read?.params.source ?? '');

/** Keeps the picture in step with the document: one evaluation at a time, and a new file ends the reading of the last. */
function evaluating(store: StoreApi<StudioState>, services: Services) {
  const evaluator = new Evaluator(nodeLibrary, { heavy: heavyWorkers() });
  let abort = new AbortController();
  let reading = '';
  let latest = 0;

  const update = async (): Promise<void> => {
    const { document } = store.getState().history;
    const source = sourceOf(document);
    const request = JSON.stringify(readOf(document));
    if (request !== reading) abort.abort();
    if (abort.signal.aborted) abort = new AbortController();
    reading = request;
    const turn = ++latest;
    const progress = (_node: string, part: number | undefined, stage?: string) => {
      if (turn === latest) store.setState({ loading: { source, part, stage: stage === 'fetch' ? 'fetch' : 'parse' } });
    };
    try {
      const result = await evaluator.evaluate(document, 'output', services, { signal: abort.signal, progress });
      if (turn === latest) settle(store, document, result);
    } catch (error) {
      if (!(error instanceof CancelledError)) throw error;
      if (turn === latest) store.setState({ loading: undefined });
    }
  };
  return { update: () => void update(), cancel: () => abort.abort() };
}

function settle(store: StoreApi<StudioState>, document: GraphDocument, evaluation: Evaluation): void {
  const picture = pictureOf(evaluation);
  const problems = [...evaluation.results.values()].flatMap((result) =>
    result.status === 'failed' ? [result.problem] : [],
  );
  store.setState(({ notices }) => ({
    loading: undefined,
    notices: notices.filter((notice) => !notice.ofDocument),
    ...(picture ? { picture, openSource: sourceOf(document), openRead: readOf(document) } : {}),
  }));
  for (const { message, place, remedy } of problems) {
    addNotice(store, { kind: 'error', text: message, place, remedy, ofDocument: true });
  }
}

let notices = 0;
function addNotice(store: StoreApi<StudioState>, notice: Omit<Notice, 'id'>): void {
  const id = ++notices;
  store.setState((state) => ({ notices: [...state.notices.slice(-3), { ...notice, id }] }));
}
