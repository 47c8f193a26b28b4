import { createStore, type StoreApi } from 'zustand/vanilla';
import type { RunRecord } from '../../dynamics/runRecord.ts';
import { energyFaultMessage, summarizeRun } from '../../dynamics/runSummary.ts';
import type { Lock } from '../../flight/arc.ts';
import { velocityMode } from '../../flight/modes/velocity.ts';
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
import type { Instrument } from '../../lessons/instruments.ts';
import type { LessonPlace } from '../../lessons/lessonAddress.ts';
import { inEnglish, type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { MessageError, messageOf } from '../../messages/messageError.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { evaluatedPicture } from '../../nodes/pictures/renderSettings.ts';
import { nearestToOutput, outputNodeId, readNodeParams, readSource } from '../../nodes/project/outputChain.ts';
import { newProject, openFileCommand, setParamCommand } from '../../nodes/project/projectCommands.ts';
import { shaderTextFaults } from '../../nodes/project/shaderTextFaults.ts';
import type { Services } from '../../nodes/services.ts';
import type { PictureSpec } from '../../nodes/socketValues.ts';
import type { Backend, ShadingChoice } from '../../render/settings.ts';
import type { PicturePosition } from '../viewport/legend/legendState.ts';
import { coalesce } from './coalesce.ts';
import { heavyWorkers } from './heavyWorkers.ts';
import type { FrameRate } from './preferences.ts';
import { type SimulationRun, simulationRuns } from './simulationRuns.ts';

/** Work in progress. */
export interface LoadingState {
  /** In groups `outer/inner`. */
  readonly node: string;
  /** The file being read; otherwise the node id. */
  readonly source: string;
  /** 0 … 1; undefined if unknown. */
  readonly part: number | undefined;
  readonly stage: LoadingStage;
}
export const STAGE_TITLES = {
  fetch: msg`Reading the file`,
  parse: msg`Building the scene`,
  trace: msg`Tracing light`,
  simulate: msg`Computing steps`,
};
type LoadingStage = keyof typeof STAGE_TITLES;

export interface Notice {
  readonly id: number;
  readonly kind: 'error' | 'warning' | 'info';
  readonly text: LocalizedText;
  readonly place?: LocalizedText;
  readonly remedy?: NodeProblem['remedy'];
  /** An additional action that the notice offers. */
  readonly action?: { readonly text: LocalizedText; readonly act: () => void };
  /** Whether it comes from the evaluation and disappears with the problem. */
  readonly ofDocument: boolean;
}

export type GraphicsStatus = Backend | 'starting' | 'recovering' | 'failed';

/** What the picture was made from. */
export interface PictureSource extends Pick<GraphDocument, 'title' | 'lookFor'> {
  /** Where its project came from. */
  readonly origin: string;
  /** File of the nearest read node; empty if there is none. */
  readonly source: string;
  /** Parameters of all read nodes. */
  readonly reads: ReturnType<typeof readNodeParams>;
}

/** State of the page. The document changes only by commands; the rest is view state. */
export interface EditorState {
  readonly history: History;
  /** The latest step at the time of the last save; null: never saved, with changes to be saved. */
  readonly saved: SaveMark | null;
  /** Results of the latest evaluation for all needed nodes; in groups `outer/inner`. */
  readonly results: Evaluation['results'];
  /** The last valid picture; kept while an edit cannot be evaluated. */
  readonly picture?: PictureSpec;
  /** Whether picture and results are interim: of work in progress, or of cancelled work. */
  readonly interim?: 'running' | 'stopped';
  readonly pictureSource: PictureSource;
  /** The node that could not read its file. */
  readonly unreadableNode?: string;
  readonly loading?: LoadingState;
  readonly notices: readonly Notice[];
  readonly graphics: GraphicsStatus;
  /** How the picture may be shaded. */
  readonly shading: ShadingChoice;
  readonly lock: Lock;
  readonly cruise: boolean;
  /** What the way of flying is called. */
  readonly flightMode: Message;
  /** Whether what is seen is held still. */
  readonly held?: boolean;
  /** Whether the world is shown from outside, beside the picture. */
  readonly outsideView?: boolean;
  /** Whether the rim of the picture darkens while it flows fast. */
  readonly vignette?: boolean;
  /** Pictures drawn per second at most; absent: as many as the screen shows. */
  readonly frameRate?: FrameRate | undefined;
  readonly playing: boolean;
  readonly loop: boolean;
  readonly dialog?: 'gallery' | 'help' | 'share' | 'name' | 'palette';
  /** The tool that is used over the picture. */
  readonly tool?: 'inspect' | 'measure';
  /** Where a menu is open for what the picture shows there. */
  readonly pictureMenu?: PicturePosition | undefined;
  /** Whether only the picture is shown, without panels. */
  readonly maximized: boolean;
  /** Whether the node graph is shown. */
  readonly graph: boolean;
  /** Whether it takes nearly all of the picture's space. */
  readonly graphEnlarged: boolean;
  /** Whether the inspector is to be brought to the front. */
  readonly inspecting: boolean;
  /** The lessons, while they are shown. */
  readonly lesson?: LessonPlace | undefined;
  /** A panel that a lesson brought to the front, and what it shows. */
  readonly instrument?: Instrument | undefined;
}

export interface Editor {
  readonly store: StoreApi<EditorState>;
  readonly edit: (command: Command, label: LocalizedText, gesture?: string) => void;
  /** `node`: evaluation id, in groups `outer/inner`. */
  readonly set: (
    node: string,
    param: string,
    value: ParamValue | undefined,
    label: LocalizedText,
    gesture?: string,
  ) => void;
  readonly endGesture: () => void;
  readonly undo: () => void;
  readonly redo: () => void;
  /** Opens a scene file in the project, or in a new project if it has no read node. */
  readonly open: (source: string) => void;
  /** Replaces the project, as an undoable step. */
  readonly openProject: (project: LoadedProject) => void;
  /** Marks the current state as saved. */
  readonly markSaved: () => void;
  /** Evaluates a node for its own sake; what is displayed does not change. Throws a CancelledError. */
  readonly evaluate: (node: string, signal: AbortSignal) => Promise<Evaluation>;
  /**
   * Stops loading: the previous scene stays, and the document reverts to it. Work with interim results keeps them until
   * `resumeWork`.
   */
  readonly cancelLoading: () => void;
  /** Continues cancelled work from where it stopped. */
  readonly resumeWork: () => void;
  /** Returns the id by which the notice can be dismissed. */
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
  /** Whether it has unsaved changes. */
  readonly unsaved: boolean;
}

/** A new project with a scene file. */
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

/** Creates the state of the page around one document. */
export function createEditor({ services, project, playing }: EditorOptions): Editor {
  const store = createStore<EditorState>(() => ({
    history: newHistory(project.document, project.origin),
    saved: project.unsaved ? null : undefined,
    pictureSource: { origin: '', source: '', reads: {} },
    results: new Map(),
    notices: [],
    graphics: 'starting',
    shading: 'auto',
    lock: 'free',
    cruise: false,
    flightMode: velocityMode.title,
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
      addNotice(store, { kind: 'error', text: messageOf(error), ofDocument: false });
    }
  };
  const openProject: Editor['openProject'] = ({ document, origin, unsaved }) => {
    go((history) => replaceDocument(history, document, origin, msg`open a project`));
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
      edit(command, msg`open a scene`);
      // Opening another scene alone is not an unsaved change.
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
      else edit(restoreReadsCommand(history.document, pictureSource.reads), msg`open a scene`);
    },
    notify: (notice) => addNotice(store, { ...notice, ofDocument: false }),
    dismiss: (id) => store.setState(({ notices }) => ({ notices: notices.filter((notice) => notice.id !== id) })),
    update: (change) => store.setState(change),
  };
}

/** Identifies the latest step of a history across undo and redo; undefined before the first. */
type SaveMark = History['past'][number]['patches'] | undefined;
const markOf = ({ past }: History): SaveMark => past.at(-1)?.patches;
/** Whether there are unsaved changes. */
export const isUnsaved = ({ history, saved }: Pick<EditorState, 'history' | 'saved'>): boolean =>
  saved === null || markOf(history) !== saved;

type ReadParams = PictureSource['reads'];
const sameReads = (a: ReadParams, b: ReadParams): boolean => JSON.stringify(a) === JSON.stringify(b);

/** Undoes to the step at which the same files were read, or to the beginning. */
function undoToReads(history: History, reads: ReadParams): History {
  let at = undo(history);
  while (at.past.length > 0 && !sameReads(readNodeParams(at.document), reads)) at = undo(at);
  return at;
}

/** Restores the parameters of the read nodes. */
function restoreReadsCommand(document: GraphDocument, before: ReadParams): Command {
  const commands = Object.entries(readNodeParams(document)).flatMap(([node, params]) => {
    const was = before[node] ?? {};
    const names = new Set([...Object.keys(params), ...Object.keys(was)]);
    return [...names].map((param) => setParamCommand(document, node, param, was[param]));
  });
  return { kind: 'batch', commands };
}

/** File of the read node nearest to the output; empty if there is none. */
export const sourceOf = (document: GraphDocument): string => readSource(nearestToOutput(document, 'read')?.params);

const NO_OUTPUT_RESULT: NodeResult = {
  status: 'failed',
  problem: {
    severity: 'error',
    code: 'graph.output',
    place: msg`the project`,
    message: msg`it has no output node, so that it makes no picture; undo, or add one`,
  },
};
const NO_OUTPUT_EVALUATION: Evaluation = { target: NO_OUTPUT_RESULT, results: new Map([['', NO_OUTPUT_RESULT]]) };

/**
 * Keeps the picture up to date: each evaluation adopts running work of the previous one that it needs, and cancels the
 * rest.
 */
function startEvaluation(store: StoreApi<EditorState>, services: Services) {
  const evaluator = new Evaluator(nodeLibrary, { heavy: heavyWorkers() });
  const quick: Services = {
    ...services,
    renderStill: () => Promise.reject(new MessageError(msg`it waits for what is under way`)),
  };
  let abort = new AbortController();
  let latest = 0;
  /** Whether cancelled work is kept at its interim result. */
  let isStopped = false;
  /** Whether the picture shows an interim result of the running work. */
  let seen = false;

  const update = async (): Promise<void> => {
    const { document } = store.getState().history;
    const reads = readNodeParams(document);
    const turn = ++latest;
    let over = false;
    seen = false;
    const progress = (node: string, part: number | undefined, what?: string) => {
      const stage = Object.hasOwn(STAGE_TITLES, what ?? '') ? (what as LoadingStage) : 'parse';
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
    const interims = isStopped ? ({ interims: 'stopped' } as const) : undefined;
    const how = { signal, progress, onInterim, ...interims };
    try {
      const result = output === undefined ? NO_OUTPUT_EVALUATION : evaluator.evaluate(document, output, services, how);
      before.abort();
      const evaluation = await result;
      if (turn !== latest) return;
      isStopped &&= isInterim(evaluation);
      const faults = await shaderTextFaults(document, (node) => evaluation.results.has(node));
      if (turn === latest) applyEvaluation(store, evaluation, faults);
    } catch (error) {
      if (!(error instanceof CancelledError)) throw error;
      if (turn === latest) store.setState(({ interim }) => ({ loading: undefined, interim: interim && 'stopped' }));
    } finally {
      over = true;
    }
  };
  const ask = (node: string, signal: AbortSignal): Promise<Evaluation> => {
    const { document } = store.getState().history;
    // The displayed output's results stay cached.
    const output = outputNodeId(document);
    return evaluator.evaluate(document, output === undefined ? [node] : [node, output], services, { signal });
  };
  /** Cancels running work; returns whether the picture shows its interim result and stays. */
  const stop = (): boolean => {
    abort.abort();
    if (!seen) return false;
    isStopped = true;
    void update();
    return true;
  };
  const goOn = (): void => {
    isStopped = false;
    void update();
  };
  return { update: () => void update(), stop, goOn, ask };
}

const isInterim = ({ results }: Evaluation): boolean =>
  [...results.values()].some((result) => result.status === 'done' && result.interim);

/** Runs whose end has been reported, so that an edit elsewhere does not report them again. */
const judgedRuns = new WeakSet<RunRecord>();

/** `faults`: of nodes that were not evaluated; they are marked, without a notice. */
function applyEvaluation(
  store: StoreApi<EditorState>,
  evaluation: Evaluation,
  faults: ReadonlyMap<string, NodeProblem>,
): void {
  const { document } = store.getState().history;
  const reads = readNodeParams(document);
  const failed = [...evaluation.results].flatMap(([node, result]) =>
    result.status === 'failed' ? [{ node, problem: result.problem }] : [],
  );
  const fresh = simulationRuns(evaluation.results).filter(({ record }) => !judgedRuns.has(record));
  for (const { record } of fresh) judgedRuns.add(record);
  const shown = pictureUpdate(store, evaluation);
  store.setState(({ notices }) => ({
    ...shown,
    loading: undefined,
    interim: isInterim(evaluation) ? 'stopped' : undefined,
    unreadableNode: failed.find(({ node }) => Object.hasOwn(reads, node))?.node,
    results: withFaults(evaluation.results, faults),
    notices: notices.filter((notice) => !notice.ofDocument),
  }));
  for (const notice of simulationNotices(fresh)) addNotice(store, { kind: 'warning', ...notice, ofDocument: true });
  for (const { message, place, remedy } of failed.map(({ problem }) => problem)) {
    addNotice(store, { kind: 'error', text: message, place, remedy, ofDocument: true });
  }
}

const withFaults = (results: Evaluation['results'], faults: ReadonlyMap<string, NodeProblem>): Evaluation['results'] =>
  faults.size === 0
    ? results
    : new Map([...results, ...[...faults].map(([node, problem]) => [node, { status: 'failed', problem }] as const)]);

/** What went wrong with runs: of one run all of it, of several how many they are. */
function simulationNotices(runs: readonly SimulationRun[]): readonly Pick<Notice, 'text' | 'place'>[] {
  const wrong = runs.flatMap(({ node, record }) => {
    const { stop } = record;
    const { fault } = summarizeRun(record);
    const ended = stop && msg`it ended at t = ${stop.t.toPrecision(4)} s: ${stop.message}`;
    const texts = [fault && energyFaultMessage(fault), ended].filter((text) => text !== undefined);
    return texts.length > 0 ? [texts.map((text) => ({ text, place: node }))] : [];
  });
  if (wrong.length < 2) return wrong.flat();
  const text = msg`Simulations that ended early, or whose energy went wrong: ${wrong.length} of ${runs.length}. The Energy panel says of each what and why.`;
  return [{ text }];
}

/** Errors that interim results cause downstream are reported only when the work has ended. */
function applyInterim(store: StoreApi<EditorState>, evaluation: Evaluation): void {
  const done = [...evaluation.results].filter(([, { status }]) => status === 'done');
  store.setState({ ...pictureUpdate(store, evaluation), interim: 'running', results: new Map(done) });
}

/** The picture and what it was made from, if there is one. */
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

const saying = ({ kind, text, place = '' }: Omit<Notice, 'id'>): string =>
  [kind, inEnglish(place), inEnglish(text)].join('\n');

let notices = 0;
function addNotice(store: StoreApi<EditorState>, notice: Omit<Notice, 'id'>): number {
  const id = ++notices;
  // Said again, it moves to the end.
  const others = ({ notices }: EditorState) => notices.filter((other) => saying(other) !== saying(notice));
  store.setState((state) => ({ notices: [...others(state).slice(-3), { ...notice, id }] }));
  return id;
}
