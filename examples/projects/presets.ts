import type { GraphDocument } from '../../src/graph/document/document.ts';
import { applyCommand, type Command } from '../../src/graph/edits/commands.ts';
import { newProject } from '../../src/nodes/project/projectCommands.ts';

const changed = (document: GraphDocument, ...commands: readonly Command[]): GraphDocument =>
  applyCommand(document, { kind: 'batch', commands }).document;

/** The observer moves ahead from the first picture on. */
const startingAt = (beta: number): readonly Command[] => [
  { kind: 'add-node', node: 'start', type: 'observer', at: [240, 180], params: { beta: [0, 0, -beta] } },
  {
    kind: 'connect',
    edge: { from: { node: 'start', output: 'observer' }, to: { node: 'scene', input: 'observer' } },
  },
];

/** The lattice as a non-relativistic renderer draws it: no light delay, no Doppler shift, no aberration. */
export const plain = (): GraphDocument => ({
  ...changed(
    newProject('lattice.usdc'),
    { kind: 'set-param', node: 'console', param: 'view', value: 'galilean' },
    { kind: 'set-param', node: 'rasterize', param: 'dopplerMix', value: 0 },
    { kind: 'set-param', node: 'rasterize', param: 'beaming', value: 0 },
  ),
  title: 'Plain',
  lookFor:
    'The lattice as any other program draws it: fly through it, and nothing bends. Then put back one thing at a time, and see what each does: View to Seen bends the bars, Doppler mix to 1 colours them, Beaming to 1 makes it bright ahead and dark behind.',
});

/** All effects: the street at 0.9 c from the first picture on. */
export const rush = (): GraphDocument => ({
  ...changed(newProject('street.usdc'), ...startingAt(0.9), {
    kind: 'set-param',
    node: 'camera',
    param: 'fieldOfView',
    value: 75,
  }),
  title: 'Relativistic street',
  lookFor:
    'The street at 0.9 c from the first picture on, and you stay in place (Look), so that there is time to see: houses that lie behind you lean into view, the middle is blue and far away, the rim red and dark. Press Tab for Free to drive on.',
});

/** The hall at 0.9 c, out of faces that are drawn once: the pipeline of images instead of geometry. */
export const captured = (): GraphDocument => ({
  ...changed(
    newProject('hall.usdc'),
    ...startingAt(0.9),
    { kind: 'add-node', node: 'capture', type: 'capture', at: [1080, 180], params: {} },
    {
      kind: 'connect',
      edge: { from: { node: 'camera', output: 'view' }, to: { node: 'capture', input: 'view' } },
    },
    {
      kind: 'connect',
      edge: { from: { node: 'capture', output: 'view' }, to: { node: 'rasterize', input: 'view' } },
    },
    { kind: 'set-param', node: 'camera', param: 'fieldOfView', value: 75 },
  ),
  title: 'Captured hall',
  lookFor:
    'The hall at 0.9 c, taken from six faces that were drawn once, at rest. Look around, and change your velocity (W and S) while you stay in place: what surrounds you is the same, only its directions and its light change, and no geometry is drawn. Look back: the texels of the faces are spread there. Remove the node Capture and compare.',
});

/** One of the three moments of an accelerating vehicle that the immersive paper shows, at its plain boxes. */
const accelerating = (beta: number): GraphDocument => ({
  ...changed(
    newProject('boxes.usdc'),
    ...startingAt(beta),
    { kind: 'set-param', node: 'camera', param: 'fieldOfView', value: 75 },
    // The shape alone: the paper has no light of relativity.
    { kind: 'set-param', node: 'rasterize', param: 'dopplerMix', value: 0 },
    { kind: 'set-param', node: 'rasterize', param: 'beaming', value: 0 },
  ),
  title: `Boxes at ${beta} c`,
  lookFor:
    'One of three moments of an acceleration, at 0.892, 0.949 and 0.968 c and the same place. What is ahead shrinks from one to the next, and more of what lies behind comes into view. Doppler mix and Beaming are 0: put them to 1 for its light.',
});

export const accelerations: Readonly<Record<string, () => GraphDocument>> = Object.fromEntries(
  [0.892, 0.949, 0.968].map((beta) => [`boxes-${1000 * beta}`, () => accelerating(beta)]),
);
