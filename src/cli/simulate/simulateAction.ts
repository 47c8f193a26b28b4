import { basename, dirname, extname, resolve } from 'node:path';
import { setImmediate } from 'node:timers/promises';
import { stepSchedule } from '../../dynamics/run.ts';
import { type RunRecord, runRecordCsv } from '../../dynamics/runRecord.ts';
import { energyFaultMessage, summarizeRun } from '../../dynamics/runSummary.ts';
import { dotted } from '../../formats/files/fileSource.ts';
import { writtenExtensions } from '../../formats/save.ts';
import { flatten } from '../../graph/analysis/flatten.ts';
import { DocumentError, type GraphDocument } from '../../graph/document/document.ts';
import type { HeavyRequest, RunHeavy } from '../../graph/evaluation/evaluator.ts';
import { inLines, listed, msg } from '../../messages/message.ts';
import type { Matter } from '../../nodes/dynamics/matter.ts';
import { simulationSettings } from '../../nodes/dynamics/simulate.ts';
import { Simulation, type SimulationOutputs } from '../../nodes/dynamics/simulation.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { exportSceneFile } from '../../nodes/project/exportSceneFile.ts';
import { writeExportedFiles } from '../files/exportScene.ts';
import {
  checkWritable,
  handleSignals,
  requestedExitCode,
  throwIfStopped,
  writeFileAtomically,
} from '../files/outputFile.ts';
import { openDevice } from '../gpu/device.ts';
import { heavyNodes } from '../project/heavyNodes.ts';
import { evaluateNodes, isProject, problemsIn, readProject, withParams } from '../project/project.ts';
import { placed, reportDiagnostics } from '../terminal/diagnostics.ts';
import { EXIT, inputProblem, usageError } from '../terminal/exitCodes.ts';
import { toJson } from '../terminal/json.ts';
import { Progress } from '../terminal/progress.ts';
import { Checkpoint, contentHash, readCheckpoint } from './checkpoint.ts';
import type { SimulateFlags } from './simulateFlags.ts';
import { teamThreads } from './teamThreads.ts';

/** Interval at which the event loop runs, for signals and other threads [ms]. */
const YIELD_INTERVAL = 50;

export async function simulate(path: string, flags: SimulateFlags): Promise<void> {
  checkFlags(flags);
  if (!(await isProject(path))) throw usageError(msg`${path} is no project; what is simulated is said by its nodes`);
  const document = withParams(await readProject(path), flags.set ?? []);
  const node = chooseSimulateNode(path, document, flags.node);
  handleSignals();
  const { geometry, books } = await runSimulation(path, document, node, flags);
  const { scene } = geometry;
  const { output, csv } = flags;
  const written =
    output === undefined
      ? undefined
      : await exportSceneFile({ kind: 'scene', name: basename(output), scene, sampled: true }, basename(output));
  reportDiagnostics([...scene.diagnostics, ...(written?.diagnostics ?? [])]);
  const files = written ? writeExportedFiles(dirname(resolve(output!)), written) : [];
  if (csv !== undefined) writeFileAtomically(csv, new TextEncoder().encode(runRecordCsv(books)));
  report(books, csv === undefined ? files : [...files, csv], flags);
  if (books.stop) process.exitCode = EXIT.ended;
}

function checkFlags({ output, csv, checkpoint, resume }: SimulateFlags): void {
  if (output === undefined && csv === undefined)
    throw usageError(msg`name what to write: a scene with -o, a table of energies with --csv`);
  if (resume && checkpoint === undefined) throw usageError(msg`--resume goes on from a --checkpoint; name it too`);
  for (const file of [output, csv, checkpoint]) if (file !== undefined) checkWritable(file);
  if (output === undefined) return;
  const extension = extname(output).slice(1).toLowerCase();
  if (!writtenExtensions.includes(extension))
    throw usageError(msg`${output}: a scene is written as ${dotted(writtenExtensions)}`);
}

/** Id of the Simulate node to run; `outer/inner` in a group. */
function chooseSimulateNode(path: string, document: GraphDocument, requested: string | undefined): string {
  const all = [...nodesIn(path, document)].filter(({ type }) => type === 'simulate').map(({ id }) => id);
  if (requested !== undefined && !all.includes(requested))
    throw usageError(msg`--node ${requested}: there is no such Simulate node; there is ${listed(all) || msg`none`}`);
  if (all.length === 0) throw usageError(msg`${path}: it has no Simulate node; add one`);
  if (all.length > 1 && requested === undefined)
    throw usageError(msg`${path} has several Simulate nodes; name one with --node: ${listed(all)}`);
  return requested ?? all[0];
}

function nodesIn(path: string, document: GraphDocument) {
  try {
    return flatten(document, nodeLibrary).nodes.values();
  } catch (error) {
    if (error instanceof DocumentError) throw inputProblem(msg`${path}: ${error.text}`);
    throw error;
  }
}

/** Evaluates the Simulate node in this thread, so that its frames can be checkpointed; nodes before it as usual. */
async function runSimulation(
  path: string,
  document: GraphDocument,
  node: string,
  flags: SimulateFlags,
): Promise<SimulationOutputs> {
  const threads = heavyNodes();
  const progress = new Progress(node);
  const heavy: RunHeavy = (request, work) =>
    request.node === node ? runWithCheckpoint(request, flags, progress) : threads(request, work);
  const evaluation = await evaluateNodes(path, document, [node], progress.node, heavy);
  progress.clear();
  throwIfStopped();
  const { target } = evaluation;
  if (target.status === 'done') return target.outputs as unknown as SimulationOutputs;
  const faults = problemsIn(evaluation).map((fault) => msg`  ${placed(fault)}`);
  throw inputProblem(inLines([msg`${path}: it cannot be simulated`, ...faults]));
}

async function runWithCheckpoint(
  { inputs, params, node }: HeavyRequest,
  flags: SimulateFlags,
  progress: Progress,
): Promise<Readonly<Record<string, unknown>>> {
  const matter = inputs.matter as readonly Matter[];
  const simulation = new Simulation(matter, simulationSettings(params), node);
  const saved = openCheckpoint(simulation, matter, params, flags);
  let lastYield = performance.now();
  try {
    for await (const frame of simulation.run({ openGpu: openDevice, teamThreads })) {
      saved?.add(frame);
      progress.frames(simulation.recordedFrames, simulation.frames);
      if (performance.now() - lastYield < YIELD_INTERVAL) continue;
      await setImmediate();
      lastYield = performance.now();
      if (requestedExitCode() !== undefined) break;
    }
  } finally {
    saved?.close();
  }
  if (requestedExitCode() !== undefined) {
    const stopped = msg`stopped after ${simulation.recordedFrames} of ${simulation.frames} frames`;
    const how = saved ? msg`--resume goes on from ${flags.checkpoint ?? ''}` : msg`nothing is written`;
    progress.note(msg`${stopped}; ${how}`);
  }
  return { ...simulation.outputs() };
}

/** Opens the checkpoint, if any; with `--resume` its frames are added to the simulation. */
function openCheckpoint(
  simulation: Simulation,
  matter: readonly Matter[],
  params: HeavyRequest['params'],
  { checkpoint: path, resume }: SimulateFlags,
): Checkpoint | undefined {
  if (path === undefined) return undefined;
  const { runOptions, frames } = simulation;
  const points = runOptions.system.masses.length;
  const { duration: _, rate: __, ...settings } = simulationSettings(params);
  const content = contentHash({ matter, settings, every: runOptions.every, steps: stepSchedule(runOptions) });
  if (!resume) return new Checkpoint(path, content, points);
  const existing = readCheckpoint(path, content, points);
  for (const { state, tally } of existing.frames.slice(0, frames)) simulation.addFrame(state, tally);
  return new Checkpoint(path, content, points, existing.end);
}

function report(books: RunRecord, files: readonly string[], { json }: SimulateFlags): void {
  const { method, onGpu = false, speedOfLight, step, times, stop, steps, corrected } = books;
  const { until, fastest, change = 0, drift, dragLoss, fault } = summarizeRun(books);
  const summary = {
    files,
    method,
    onGpu,
    speedOfLight: Number.isFinite(speedOfLight) ? speedOfLight : 'infinite',
    step,
    steps: steps.at(-1),
    frames: times.length,
    until,
    fastest,
    /** Largest deviation of the energy from its first value, over the largest kinetic energy, whatever its cause. */
    energyChange: change,
    /** The same with what drag took added: the method's error. Absent where moving objects, or drag on a GPU, hide it. */
    ...(drift !== undefined && { energyDrift: drift }),
    /** [J] */
    ...(dragLoss !== undefined && { dragLoss }),
    /** Steps that the energy correction changed. */
    ...(corrected !== undefined && { corrected }),
    /** The energy went wrong. */
    ...(fault && { energyFault: { ...fault, message: energyFaultMessage(fault) } }),
    ...(stop && { stop }),
  };
  if (json) console.log(toJson(summary));
  else console.log(files.join('\n'));
}
