import { type FlightState, flightOf, observerOf } from '../../flight/flightState.ts';
import { cutFlight } from '../../flight/recording/edit.ts';
import { FlightPlayback } from '../../flight/recording/playback.ts';
import { type FlightRecording, recordingDuration } from '../../flight/recording/recording.ts';
import { type GraphDocument, own } from '../../graph/document/document.ts';
import { applyCommand, type Command } from '../../graph/edits/commands.ts';
import { type FlightPlan, parseFlightPlan } from '../../lessons/flightPlan.ts';
import { parseInstrument } from '../../lessons/instruments.ts';
import type { LessonValue } from '../../lessons/lesson.ts';
import { isParameter, isVector, type LessonState } from '../../lessons/settings.ts';
import { length } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { setParamCommand } from '../../nodes/project/projectCommands.ts';
import { properVelocity } from '../../physics/lorentz/boost.ts';
import { lookAtOrientation } from '../../scene/view/camera.ts';
import { isProject } from '../projects/projectNames.ts';
import { projectFromAddress } from '../projects/projectSource.ts';
import type { EditorServices } from '../services.tsx';
import { type Editor, isUnsaved, type LoadedProject, projectOfScene, sourceOf } from '../state/editor.ts';
import { sceneUpVector } from '../state/observer.ts';
import { prefersReducedMotion } from '../state/preferences.ts';
import { plannedFlight } from './plannedFlight.ts';
import { replayFlight } from './replayFlight.ts';

type LessonHost = Pick<EditorServices, 'observerController' | 'localFiles'> & { readonly editor: Editor };

/**
 * Shows the state of a step: its example with its parameters as one undoable step, then, when that is drawn, the observer.
 * Throws as `projectFromAddress`, and where the signal is aborted, which ends the wait.
 */
export async function showState(
  { example, settings }: LessonState,
  host: LessonHost,
  signal: AbortSignal,
): Promise<void> {
  const opened = await openExample(example, host.localFiles);
  signal.throwIfAborted();
  const project = { ...opened, document: withParameters(opened.document, settings) };
  const before = host.editor.store.getState().results;
  const isChanged = setProject(host.editor, project);
  const source = sourceOf(project.document);
  const isShown = () => {
    const { picture, pictureSource, results } = host.editor.store.getState();
    const isWanted = pictureSource.origin === project.origin && pictureSource.source === source;
    const isDrawn = picture !== undefined && host.observerController.picture === picture;
    return (!isChanged || results !== before) && isWanted && isDrawn;
  };
  while (!isShown()) {
    await new Promise(requestAnimationFrame);
    signal.throwIfAborted();
  }
  placeObserver(settings, host, signal);
  const panel = settings.get('panel');
  if (typeof panel === 'string') host.editor.update({ instrument: parseInstrument(panel) });
}

/** The example as a project of its own. */
const openExample = async (example: string, localFiles: LessonHost['localFiles']): Promise<LoadedProject> => {
  const address = `examples/${example}`;
  return isProject(address) ? projectFromAddress(address, localFiles) : projectOfScene(address);
};

/** The example's document with the parameters of a state. Throws a CommandError where a node is not there. */
export function withParameters(document: GraphDocument, settings: LessonState['settings']): GraphDocument {
  const commands = [...settings].flatMap(([key, value]) => {
    if (!isParameter(key)) return [];
    const [node = '', param = ''] = key.split('.');
    return [setParamCommand(document, node, param, value)];
  });
  return applyCommand(document, { kind: 'batch', commands }).document;
}

/** Sets parameters of the open project if it is the same but for them, or opens it. Returns whether anything changed. */
function setProject(editor: Editor, project: LoadedProject): boolean {
  const { history } = editor.store.getState();
  const isOpen = history.origin === project.origin && frameOf(history.document) === frameOf(project.document);
  if (!isOpen) editor.openProject(project);
  else {
    const wasUnsaved = isUnsaved(editor.store.getState());
    editor.edit(parameterChanges(history.document, project.document), msg`step of a lesson`);
    // As opening another scene, a lesson alone is no unsaved change.
    if (!wasUnsaved) editor.markSaved();
  }
  return editor.store.getState().history.document !== history.document;
}

/** All of a document but parameters of its own nodes and where they stand. */
function frameOf({ nodes, layout: _, ...rest }: GraphDocument): string {
  const types = Object.entries(nodes).map(([node, { params: _, ...other }]) => [node, other]);
  return JSON.stringify([types.sort(([a], [b]) => (a! < b! ? -1 : 1)), rest]);
}

function parameterChanges(from: GraphDocument, to: GraphDocument): Command {
  const commands = Object.entries(to.nodes).flatMap(([node, { params }]) => {
    const now = own(from.nodes, node)?.params ?? {};
    const names = [...new Set([...Object.keys(now), ...Object.keys(params)])];
    return names.map((param) => setParamCommand(from, node, param, own(params, param)));
  });
  return { kind: 'batch', commands };
}

/** The observer as the scene begins, but for what the state says. One who moves keeps velocity and place. */
function placeObserver(settings: LessonState['settings'], host: LessonHost, signal: AbortSignal): void {
  const { observerController } = host;
  const { picture } = observerController;
  if (!picture) return;
  observerController.restart();
  const vector = (key: string) => {
    const value = settings.get(key);
    return value !== undefined && isVector(value) ? value : undefined;
  };
  const number = (value: LessonValue | undefined) => (typeof value === 'number' ? value : undefined);
  const [beta, position, look] = ['observer.beta', 'observer.position', 'observer.look'].map(vector);
  const t = number(settings.get('time'));
  const u = beta && properVelocity(beta);
  observerController.place({
    ...(t !== undefined && { t }),
    ...(position && { position }),
    ...(u && { u }),
    ...(look && { orientation: lookAtOrientation(look, sceneUpVector(picture.scene)) }),
  });
  const flight = settings.get('flight');
  const plan = typeof flight === 'string' ? parseFlightPlan(flight)! : [];
  if (plan.length === 0) settle(settings, host);
  else fly(plan, settings, host, signal);
}

/** The part of a flight from the observer's place that the state says; where no motion is wanted, where it ends. */
function fly(plan: FlightPlan, settings: LessonState['settings'], host: LessonHost, signal: AbortSignal): void {
  const { observerController: controller } = host;
  const whole = plannedFlight(plan, flightOf(controller.observer), controller.picture!.speedOfLight);
  const duration = recordingDuration(whole);
  const moment = (key: string, otherwise: number) => Math.min(Number(settings.get(key) ?? otherwise), duration);
  const [from, to] = [moment('flight.from', 0), moment('flight.to', duration)];
  const end = (last: FlightState): void => {
    controller.place(observerOf(last));
    settle(settings, host);
  };
  if (from >= to || prefersReducedMotion()) end(stateAtEnd(whole, from, to));
  else
    replayFlight(cutFlight(whole, from, to), controller, signal, (last) => {
      if (last) end(last);
    });
}

/** The last state of a part. A part without duration begins what comes next: after a turn, not before it. */
const stateAtEnd = (whole: FlightRecording, from: number, to: number): FlightState =>
  from < to
    ? new FlightPlayback(cutFlight(whole, from, to)).stateAt(to - from)
    : new FlightPlayback(whole).stateAt(from);

/** Whether time runs, and who has a velocity keeps it. */
function settle(settings: LessonState['settings'], { editor, observerController }: LessonHost): void {
  const isMoving = length(observerController.observer.u) > 0;
  const lock = settings.get('lock');
  editor.update({
    playing: settings.get('playing') === true && !prefersReducedMotion(),
    cruise: isMoving,
    lock: lock === 'free' || lock === 'look' ? lock : isMoving ? 'look' : 'free',
  });
}
