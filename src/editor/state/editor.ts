import { createStore, type StoreApi } from 'zustand/vanilla';
import type { GraphDocument, ParamValue } from '../../graph/document/document.ts';
import { type Command, CommandError } from '../../graph/edits/commands.ts';
import {
  endGesture,
  executeCommand,
  type History,
  newHistory,
  redo,
  replaceDocument,
  undo,
} from '../../graph/edits/history.ts';
import { CancelledError, type Evaluation, Evaluator } from '../../graph/evaluation/evaluator.ts';
import type { NodeResult } from '../../graph/evaluation/resultCache.ts';
import type { NodeProblem } from '../../graph/nodeType.ts';
import type { PictureSpec } from '../../nodes/defineNode.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { evaluatedPicture } from '../../nodes/pictures/renderSettings.ts';
import { nearestToOutput, outputNodeId, readNodeParams, readSource } from '../../nodes/project/outputChain.ts';
import { newProject, openFileCommand, setParamCommand } from '../../nodes/project/projectCommands.ts';
import type { Services } from '../../nodes/services.ts';
import type { Backend } from '../../render/settings.ts';
import type { Lock } from '../flight/flight.ts';
import { coalesce } from './coalesce.ts';
import { heavyWorkers } from './heavyWorkers.ts';
import { simulationRuns } from './simulationRuns.ts';

/** What is taking its time. */
export interface LoadingState {
  /** In groups by `outer/inner`. */
  readonly node: string;
  /** The file that it reads; else the node again. */
  readonly source: string;
  /** 0 … 1; undefined where it cannot be known. */
  readonly part: number | undefined;
  readonly stage: (typeof STAGES)[number];
}
const STAGES = ['fetch', 'parse', 'trace', 'simulate'] as const;

export interface Notice {
  readonly id: number;
  readonly kind: 'error' | 'warning' | 'info';
  readonly text: string;
  readonly place?: string;
  readonly remedy?: NodeProblem['remedy'];
  /** What else can be done about it. */
  readonly action?: { readonly text: string; readonly act: () => void };
  /** Of the evaluation: goes away when the problem does. */
  readonly ofDocument: boolean;
}

export type GraphicsStatus = Backend | 'starting' | 'recovering' | 'failed';

/** What the picture was made of. */
export interface PictureSource extends Pick<GraphDocument, 'title' | 'lookFor'> {
  /** Where its project came from. */
  readonly origin: string;
  /** The file that the nearest reading node read; empty where none does. */
  readonly source: string;
  /** The parameters of all reading nodes. */
  readonly reads: ReturnType<typeof readNodeParams>;
}

/** Everything the page shows. The document changes by commands alone; the rest is how it is being looked at. */
export interface EditorState {
  readonly history: History;
  /** What the latest step was when the project was last saved; null: it never was, and there is something to be saved. */
  readonly saved: SaveMark | null;
  /** What the latest evaluation made of each node that it needed; in groups by `outer/inner`. */
  readonly results: Evaluation['results'];
  /** The last good one: it stays while an edit cannot be evaluated. */
  readonly picture?: PictureSpec;
  /** The picture and the results show what work has given so far, which goes on, or was cancelled. */
  readonly interim?: 'running' | 'stopped';
  readonly pictureSource: PictureSource;
  /** The node that could not read its file. */
  readonly unreadableNode?: string;
  readonly loading?: LoadingState;
  readonly notices: readonly Notice[];
  readonly graphics: GraphicsStatus;
  readonly lock: Lock;
  readonly cruise: boolean;
  readonly playing: boolean;
  readonly loop: boolean;
  readonly dialog?: 'gallery' | 'help' | 'share' | 'name' | 'palette';
  /** Only the picture is shown, without the panels. */
  readonly maximized: boolean;
  /** The node graph is shown beside the picture. */
  readonly graph: boolean;
  /** It has nearly all of the room that is else the picture's. */
  readonly graphEnlarged: boolean;
  /** The inspector is to come to the front. */
  readonly inspecting: boolean;
}

export interface Editor {
  readonly store: StoreApi<EditorState>;
  readonly edit: (command: Command, label: string, gesture?: string) => void;
  /** `node`: as an evaluation names it, in groups by `outer/inner`. */
  readonly set: (node: string, param: string, value: ParamValue | undefined, label: string, gesture?: string) => void;
  readonly endGesture: () => void;
  readonly undo: () => void;
  readonly redo: () => void;
  /** Opens a scene file in the project; where nothing there reads files, in a new one. */
  readonly open: (source: string) => void;
  /** Puts another project in place, as a step that can be undone. */
  readonly openProject: (project: LoadedProject) => void;
  /** Says that the project as it stands is kept in a file. */
  readonly markSaved: () => void;
  /** What a node of the project gives, beside what the output needs; nothing that is shown changes. Throws a CancelledError. */
  readonly evaluate: (node: string, signal: AbortSignal) => Promise<Evaluation>;
  /**
   * Stops reading; the scene before it stays, and the document goes back to it. Of what has given something on its way that is kept, until
   * `goOn`.
   */
  readonly cancelLoading: () => void;
  /** With the work that was cancelled, from where it was. */
  readonly resumeWork: () => void;
  /** Gives the key by which the notice can be dismissed. */
  readonly notify: (notice: Omit<Notice, 'id' | 'ofDocument'>) => number;
  readonly dismiss: (id: number) => void;
  readonly update: (
    change: Partial<Omit<EditorState, 'history' | 'saved' | 'picture' | 'results' | 'interim' | 'loading' | 'notices'>>,
  ) => void;
}

/** A project as it is opened. */
export interface LoadedProject {
  readonly document: GraphDocument;
  readonly origin: string;
  /** It was never saved as it is. */
  readonly unsaved: boolean;
}

/** A scene file in a project of its own. */
export const projectOfScene = (source: string): LoadedProject => ({
  document: newProject(source),
  origin: '',
  unsaved: false,
});

export interface EditorOptions {
  readonly services: Services;
  readonly project: LoadedProject;
  readonly playing: boolean;
}

/** The state of the page, around one document. */
export function createEditor({ services, project, playing }: EditorOptions): Editor {
  const store = createStore<EditorState>(() => ({
    history: newHistory(project.document, project.origin),
    saved: project.unsaved ? null : undefined,
    pictureSource: { origin: '', source: '', reads: {} },
    results: new Map(),
    notices: [],
    graphics: 'starting',
    lock: 'free',
    cruise: false,
    playing,
    loop: true,
    maximized: false,
    graph: false,
    graphEnlarged: false,
    inspecting: false,
  }));
  const evaluation = startEvaluation(store, services);
  const go = (next: (history: History) => History): void => {
    const { history } = store.getState();
    const changed = next(history);
    store.setState({ history: changed });
    if (changed.document !== history.document) evaluation.update();
  };
  const edit: Editor['edit'] = (command, label, gesture) => {
    try {
      go((history) => executeCommand(history, command, label, gesture));
    } catch (error) {
      if (!(error instanceof CommandError)) throw error;
      addNotice(store, { kind: 'error', text: error.message, ofDocument: false });
    }
  };
  const openProject: Editor['openProject'] = ({ document, origin, unsaved }) => {
    go((history) => replaceDocument(history, document, origin, 'edit.openProject'));
    store.setState(({ history }) => ({ saved: unsaved ? null : markOf(history) }));
  };
  evaluation.update();
  return {
    store,
    edit,
    set: (id, param, value, label, gesture) =>
      edit(setParamCommand(store.getState().history.document, id, param, value), label, gesture),
    endGesture: () => go(endGesture),
    undo: () => go(undo),
    redo: () => go(redo),
    open: (file) => {
      const before = store.getState();
      const command = openFileCommand(before.history.document, file);
      if (!command) return openProject(projectOfScene(file));
      edit(command, 'edit.open');
      // To look at another scene is no work to be saved.
      if (!isUnsaved(before)) store.setState(({ history }) => ({ saved: markOf(history) }));
    },
    openProject,
    markSaved: () => {
      go(endGesture);
      store.setState(({ history }) => ({ saved: markOf(history) }));
    },
    evaluate: evaluation.ask,
    resumeWork: evaluation.goOn,
    cancelLoading: () => {
      if (evaluation.stop()) return;
      const { history, pictureSource, picture } = store.getState();
      if (!picture || sameReads(readNodeParams(history.document), pictureSource.reads)) return;
      if (history.origin !== pictureSource.origin) go((now) => undoToReads(now, pictureSource.reads));
      else if (sameReads(readNodeParams(undo(history).document), pictureSource.reads)) go(undo);
      else edit(restoreReadsCommand(history.document, pictureSource.reads), 'edit.open');
    },
    notify: (notice) => addNotice(store, { ...notice, ofDocument: false }),
    dismiss: (id) => store.setState(({ notices }) => ({ notices: notices.filter((notice) => notice.id !== id) })),
    update: (change) => store.setState(change),
  };
}

/** By which the latest step of a history is known again, whatever is undone and done again; undefined before the first. */
type SaveMark = History['past'][number]['patches'] | undefined;
const markOf = ({ past }: History): SaveMark => past.at(-1)?.patches;
/** Whether there is anything that no file holds. */
export const isUnsaved = ({ history, saved }: Pick<EditorState, 'history' | 'saved'>): boolean =>
  saved === null || markOf(history) !== saved;

type ReadParams = PictureSource['reads'];
const sameReads = (a: ReadParams, b: ReadParams): boolean => JSON.stringify(a) === JSON.stringify(b);

/** Back to where the same files were read; at most to the beginning. */
function undoToReads(history: History, reads: ReadParams): History {
  let at = undo(history);
  while (at.past.length > 0 && !sameReads(readNodeParams(at.document), reads)) at = undo(at);
  return at;
}

/** Sets the reading nodes to what they were. */
function restoreReadsCommand(document: GraphDocument, before: ReadParams): Command {
  const commands = Object.entries(readNodeParams(document)).flatMap(([node, params]) => {
    const was = before[node] ?? {};
    const names = new Set([...Object.keys(params), ...Object.keys(was)]);
    return [...names].map((param) => setParamCommand(document, node, param, was[param]));
  });
  return { kind: 'batch', commands };
}

/** The file that a document's nearest reading node reads; empty where none does. */
export const sourceOf = (document: GraphDocument): string => readSource(nearestToOutput(document, 'read')?.params);

const NO_OUTPUT_RESULT: NodeResult = {
  status: 'failed',
  problem: {
    severity: 'error',
    code: 'graph.output',
    place: 'the project',
    message: 'it has no output node, so that it makes no picture; undo, or add one',
  },
};
const NO_OUTPUT_EVALUATION: Evaluation = { target: NO_OUTPUT_RESULT, results: new Map([['', NO_OUTPUT_RESULT]]) };

/** Keeps the picture in step with the document: each evaluation takes over what of the last one's work it needs too, and ends the rest. */
function startEvaluation(store: StoreApi<EditorState>, services: Services) {
  const evaluator = new Evaluator(nodeLibrary, { heavy: heavyWorkers() });
  const quick: Services = {
    ...services,
    renderStill: () => Promise.reject(new Error('it waits for what is under way')),
  };
  let abort = new AbortController();
  let latest = 0;
  /** Work that was cancelled stays as far as it came. */
  let held = false;
  /** The picture is of what the work has given that goes on now. */
  let seen = false;

  const update = async (): Promise<void> => {
    const { document } = store.getState().history;
    const reads = readNodeParams(document);
    const turn = ++latest;
    let over = false;
    seen = false;
    const progress = (node: string, part: number | undefined, what?: string) => {
      const stage = STAGES.find((each) => each === what) ?? 'parse';
      if (turn === latest) store.setState({ loading: { node, source: readSource(reads[node]) || node, part, stage } });
    };
    const before = abort;
    abort = new AbortController();
    const { signal } = abort;
    const output = outputNodeId(document);
    const onInterim = coalesce(async () => {
      if (over || turn !== latest || output === undefined) return;
      const soFar = await evaluator.evaluate(document, output, quick, { signal, interims: 'all' });
      if (over || turn !== latest) return;
      seen = true;
      applyInterim(store, soFar);
    });
    const interims = held ? ({ interims: 'stopped' } as const) : undefined;
    const how = { signal, progress, onInterim, ...interims };
    try {
      const result = output === undefined ? NO_OUTPUT_EVALUATION : evaluator.evaluate(document, output, services, how);
      before.abort();
      const evaluation = await result;
      if (turn !== latest) return;
      held &&= isInterim(evaluation);
      applyEvaluation(store, evaluation);
    } catch (error) {
      if (!(error instanceof CancelledError)) throw error;
      if (turn === latest) store.setState(({ interim }) => ({ loading: undefined, interim: interim && 'stopped' }));
    } finally {
      over = true;
    }
  };
  const ask = (node: string, signal: AbortSignal): Promise<Evaluation> => {
    const { document } = store.getState().history;
    // What the screen shows stays in reach.
    const output = outputNodeId(document);
    return evaluator.evaluate(document, output === undefined ? [node] : [node, output], services, { signal });
  };
  /** Ends what goes on; whether the picture is made of that, and stays. */
  const stop = (): boolean => {
    abort.abort();
    if (!seen) return false;
    held = true;
    void update();
    return true;
  };
  const goOn = (): void => {
    held = false;
    void update();
  };
  return { update: () => void update(), stop, goOn, ask };
}

const isInterim = ({ results }: Evaluation): boolean =>
  [...results.values()].some((result) => result.status === 'done' && result.interim);

function applyEvaluation(store: StoreApi<EditorState>, evaluation: Evaluation): void {
  const { document } = store.getState().history;
  const reads = readNodeParams(document);
  const failed = [...evaluation.results].flatMap(([node, result]) =>
    result.status === 'failed' ? [{ node, problem: result.problem }] : [],
  );
  const known = new Set(simulationRuns(store.getState().results).map(({ record }) => record));
  const stops = simulationRuns(evaluation.results).filter(({ record }) => record.stop && !known.has(record));
  const shown = pictureUpdate(store, evaluation);
  store.setState(({ notices }) => ({
    ...shown,
    loading: undefined,
    interim: isInterim(evaluation) ? 'stopped' : undefined,
    unreadableNode: failed.find(({ node }) => Object.hasOwn(reads, node))?.node,
    results: evaluation.results,
    notices: notices.filter((notice) => !notice.ofDocument),
  }));
  for (const { node, record } of stops) {
    const text = `it ended at t = ${record.stop!.t.toPrecision(4)} s: ${record.stop!.message}`;
    addNotice(store, { kind: 'warning', text, place: node, ofDocument: true });
  }
  for (const { message, place, remedy } of failed.map(({ problem }) => problem)) {
    addNotice(store, { kind: 'error', text: message, place, remedy, ofDocument: true });
  }
}

/** What cannot be made of an interim is told when the work has ended. */
function applyInterim(store: StoreApi<EditorState>, evaluation: Evaluation): void {
  const done = [...evaluation.results].filter(([, { status }]) => status === 'done');
  store.setState({ ...pictureUpdate(store, evaluation), interim: 'running', results: new Map(done) });
}

/** Of a picture, where there is one, and what it was made of. */
function pictureUpdate(store: StoreApi<EditorState>, evaluation: Evaluation): Partial<EditorState> {
  const { document, origin } = store.getState().history;
  const picture = evaluatedPicture(evaluation);
  const { title, lookFor } = document;
  return picture
    ? {
        picture,
        pictureSource: { origin, title, lookFor, source: sourceOf(document), reads: readNodeParams(document) },
      }
    : {};
}

let notices = 0;
function addNotice(store: StoreApi<EditorState>, notice: Omit<Notice, 'id'>): number {
  const id = ++notices;
  store.setState((state) => ({ notices: [...state.notices.slice(-3), { ...notice, id }] }));
  return id;
}
