import { LIMITS, type Place, refuse } from './place.ts';
import type { Channel, Program, Step, Value } from './program.ts';

/** What a part of a program takes for one pixel. */
interface Cost {
  readonly steps: number;
  /** With all calls written out. */
  readonly size: number;
  /** The most that a loop's inside goes round, of all loops about it. */
  readonly rounds: number;
}

const LOOK = 8;

/** Refuses what would take too long, or calls itself; tells what is looked at. `places`: of the functions. */
export function boundedReads(
  { functions, effect }: Pick<Program, 'functions' | 'effect'>,
  places: readonly Place[],
): ReadonlySet<Channel> {
  const reads = new Set<Channel>();
  const known = new Map<number, Cost>();
  const open = new Set<number>();

  const sum = (costs: readonly Cost[], own = 0): Cost => ({
    steps: own + costs.reduce((all, { steps }) => all + steps, 0),
    size: own + costs.reduce((all, { size }) => all + size, 0),
    rounds: Math.max(1, ...costs.map(({ rounds }) => rounds)),
  });
  const ofValue = (value: Value): Cost => {
    switch (value.op) {
      case 'constant':
      case 'local':
      case 'input':
        return { steps: 0, size: 1, rounds: 1 };
      case 'look':
        reads.add(value.channel);
        return sum([ofValue(value.offset)], LOOK);
      case 'call':
        return sum([...value.args.map(ofValue), ofFunction(value.f)], 1);
      case 'apply':
        return sum(value.args.map(ofValue), 1);
      case 'build':
        return sum(value.parts.map(ofValue), 1);
      default:
        return sum([ofValue(value.of)], 1);
    }
  };
  const ofSteps = (steps: readonly Step[]): Cost => sum(steps.map(ofStep));
  const ofStep = (step: Step): Cost => {
    switch (step.op) {
      case 'set':
      case 'return':
        return sum([ofValue(step.value)], 1);
      case 'if':
        return sum([ofValue(step.test), ofSteps(step.yes), ofSteps(step.no)], 1);
      case 'for': {
        const body = ofSteps(step.body);
        const count = Math.max(step.count, 1);
        return { steps: 1 + count * (body.steps + 2), size: body.size + 3, rounds: count * body.rounds };
      }
      default:
        return { steps: 1, size: 1, rounds: 1 };
    }
  };
  const ofFunction = (index: number): Cost => {
    const at = places[index] ?? { line: 1, column: 1 };
    const name = functions[index]?.name ?? '';
    if (open.has(index)) refuse(at, `${name} calls itself, which no shader can: write a loop`);
    const before = known.get(index);
    if (before) return before;
    open.add(index);
    const cost = ofSteps(functions[index]?.body ?? []);
    open.delete(index);
    if (cost.rounds > LIMITS.nested)
      refuse(
        at,
        `loops within loops of ${name} go round ${cost.rounds} times; more than ${LIMITS.nested} are not taken: take fewer`,
      );
    if (cost.size > LIMITS.size)
      refuse(
        at,
        `${name} has ${cost.size} operations, with those of the functions that it calls; more than ${LIMITS.size} are not taken`,
      );
    if (cost.steps > LIMITS.steps)
      refuse(
        at,
        `${name} takes ${cost.steps} steps for each pixel (a look at a pixel counts ${LOOK}); more than ${LIMITS.steps} are not taken: let loops go round fewer times`,
      );
    known.set(index, cost);
    return cost;
  };

  for (const index of functions.keys()) ofFunction(index);
  reads.clear();
  known.clear();
  ofFunction(effect);
  return reads;
}
