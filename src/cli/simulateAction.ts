import { basename, dirname, extname, resolve } from 'node:path';
import { setImmediate } from 'node:timers/promises';
import { type Books, booksCsv, figuresOf } from '../dynamics/books.ts';
import { stepsOf } from '../dynamics/run.ts';
import { writtenExtensions } from '../formats/save.ts';
import { DocumentError, type GraphDocument } from '../graph/document.ts';
import type { HeavyOrder, RunHeavy } from '../graph/evaluate.ts';
import { flatten } from '../graph/flatten.ts';
import type { Matter } from '../nodes/dynamics/matter.ts';
import { settingsOf } from '../nodes/dynamics/simulate.ts';
import { type Simulated, Simulation } from '../nodes/dynamics/simulation.ts';
import { nodeLibrary } from '../nodes/library.ts';
import { writtenScene } from '../nodes/writtenScene.ts';
import { Checkpoint, contentOf, readCheckpoint } from './checkpoint.ts';
import { openDevice } from './device.ts';
import { reportDiagnostics } from './diagnostics.ts';
import { EXIT, inputProblem, usageError } from './exit.ts';
import { heavyNodes } from './heavyNodes.ts';
import { checkWritable, endIfStopped, heedSignals, stoppedWith, writeWhole } from './output.ts';
import { Progress } from './progress.ts';
import { evaluateNodes, isProject, problemsIn, readProject, told, withParams } from './project.ts';
import { anyScene, BINARY, checkPython, writeAll } from './sceneFiles.ts';
import type { SimulateFlags } from './simulate.ts';

/** Others are let work, and signals heard, so often [ms]. */
const BREATH = 50;

export async function simulate(path: string, flags: SimulateFlags): Promise<void> {
  checkFlags(flags);
  if (!(await isProject(path))) throw usageError(`${path} is no project; what is simulated is said by its nodes`);
  const document = withParams(await readProject(path), flags.set ?? []);
  const node = simulateNode(path, document, flags.node);
  heedSignals();
  const { geometry, books } = await simulated(path, document, node, flags);
  const { scene } = geometry;
  const { output, csv } = flags;
  const written =
    output === undefined
      ? undefined
      : await anyScene(basename(output), (name) => writtenScene({ kind: 'scene', name, scene, sampled: true }, name));
  reportDiagnostics([...scene.diagnostics, ...(written?.diagnostics ?? [])]);
  const files = written ? writeAll(dirname(resolve(output!)), written) : [];
  if (csv !== undefined) writeWhole(csv, new TextEncoder().encode(booksCsv(books)));
  report(books, csv === undefined ? files : [...files, csv], flags);
  if (books.stop) process.exitCode = EXIT.ended;
}

function checkFlags({ output, csv, checkpoint, resume }: SimulateFlags): void {
  if (output === undefined && csv === undefined)
    throw usageError('name what to write: a scene with -o, a table of energies with --csv');
  if (resume && checkpoint === undefined) throw usageError('--resume goes on from a --checkpoint; name it too');
  for (const file of [output, csv, checkpoint]) if (file !== undefined) checkWritable(file);
  if (output === undefined) return;
  const extension = extname(output).slice(1).toLowerCase();
  const known = [...writtenExtensions, BINARY];
  if (!known.includes(extension))
    throw usageError(`${output}: a scene is written as ${known.map((each) => `.${each}`).join(', ')}`);
  if (extension === BINARY) checkPython();
}

/** The one that is to run; in a group `outer/inner`. */
function simulateNode(path: string, document: GraphDocument, wanted: string | undefined): string {
  const all = [...nodesIn(path, document)].filter(({ type }) => type === 'simulate').map(({ id }) => id);
  if (wanted !== undefined && !all.includes(wanted))
    throw usageError(`--node ${wanted}: there is no such Simulate node; there is ${all.join(', ') || 'none'}`);
  if (all.length === 0) throw usageError(`${path}: it has no Simulate node; add one`);
  if (all.length > 1 && wanted === undefined)
    throw usageError(`${path} has several Simulate nodes; name one with --node: ${all.join(', ')}`);
  return wanted ?? all[0];
}

function nodesIn(path: string, document: GraphDocument) {
  try {
    return flatten(document, nodeLibrary).nodes.values();
  } catch (error) {
    if (error instanceof DocumentError) throw inputProblem(`${path}: ${error.message}`);
    throw error;
  }
}

/** What the node gives. It runs here, so that its frames can be kept; all before it as ever. */
async function simulated(
  path: string,
  document: GraphDocument,
  node: string,
  flags: SimulateFlags,
): Promise<Simulated> {
  const threads = heavyNodes();
  const progress = new Progress(`${node}: `);
  const heavy: RunHeavy = (order, work) =>
    order.node === node ? followed(order, flags, progress) : threads(order, work);
  const evaluation = await evaluateNodes(path, document, [node], progress.node, heavy);
  progress.clear();
  endIfStopped();
  const { target } = evaluation;
  if (target.status === 'done') return target.outputs as unknown as Simulated;
  const faults = problemsIn(evaluation).map((fault) => `  ${told(fault)}`);
  throw inputProblem([`${path}: it cannot be simulated`, ...faults].join('\n'));
}

async function followed(
  { inputs, params, node }: HeavyOrder,
  flags: SimulateFlags,
  progress: Progress,
): Promise<Readonly<Record<string, unknown>>> {
  const matter = inputs.matter as readonly Matter[];
  const simulation = new Simulation(matter, settingsOf(params), node);
  const kept = checkpointOf(simulation, matter, params, flags);
  let breath = performance.now();
  try {
    for await (const frame of simulation.run(openDevice)) {
      kept?.add(frame);
      progress.frames(simulation.taken, simulation.frames);
      if (performance.now() - breath < BREATH) continue;
      await setImmediate();
      breath = performance.now();
      if (stoppedWith() !== undefined) break;
    }
  } finally {
    kept?.close();
  }
  if (stoppedWith() !== undefined) {
    const how = kept ? `; --resume goes on from ${flags.checkpoint}` : '; nothing is written';
    progress.note(`stopped after ${simulation.taken} of ${simulation.frames} frames${how}`);
  }
  return { ...simulation.outputs() };
}

/** The file that frames go to; those that are in it are entered. */
function checkpointOf(
  simulation: Simulation,
  matter: readonly Matter[],
  params: HeavyOrder['params'],
  { checkpoint: path, resume }: SimulateFlags,
): Checkpoint | undefined {
  if (path === undefined) return undefined;
  const { order, frames } = simulation;
  const points = order.system.masses.length;
  const { duration: _, rate: __, ...settings } = settingsOf(params);
  const content = contentOf({ matter, settings, every: order.every, steps: stepsOf(order) });
  if (!resume) return new Checkpoint(path, content, points);
  const known = readCheckpoint(path, content, points);
  for (const { state, steps } of known.frames.slice(0, frames)) simulation.enter(state, steps);
  return new Checkpoint(path, content, points, known.end);
}

function report(books: Books, files: readonly string[], { json }: SimulateFlags): void {
  const { method, onGpu = false, speedOfLight, step, times, stop, steps } = books;
  const { until, fastest, drift = 0 } = figuresOf(books);
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
    /** The most that the energy was from the first, of the greatest kinetic energy. */
    energyChange: drift,
    ...(stop && { stop }),
  };
  if (json) console.log(JSON.stringify(summary, null, 2));
  else console.log(files.join('\n'));
}
