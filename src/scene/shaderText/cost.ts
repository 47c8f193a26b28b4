import { msg } from '../../messages/message.ts';
import type { ShaderChannel, ShaderExpression, ShaderProgram, ShaderStatement } from './program.ts';
import { refuse, SHADER_TEXT_LIMITS, type SourceLocation } from './sourceLocation.ts';

/** Cost of a part of a program per pixel. */
interface ShaderCost {
  readonly steps: number;
  /** With all calls inlined. */
  readonly size: number;
  /** Largest number of iterations of a loop body, with all enclosing loops. */
  readonly rounds: number;
}

const SAMPLE_COST = 8;
/** Of a 4 × 4 matrix. */
const INVERSE_COST = 200;

/** Throws for programs that take too long or recurse; returns the channels sampled. `places`: of the functions. */
export function checkCost(
  { functions, effect }: Pick<ShaderProgram, 'functions' | 'effect'>,
  places: readonly SourceLocation[],
): readonly ShaderChannel[] {
  const reads = new Set<ShaderChannel>();
  const known = new Map<number, ShaderCost>();
  const open = new Set<number>();

  const sum = (costs: readonly ShaderCost[], own = 0): ShaderCost => ({
    steps: own + costs.reduce((all, { steps }) => all + steps, 0),
    size: own + costs.reduce((all, { size }) => all + size, 0),
    rounds: Math.max(1, ...costs.map(({ rounds }) => rounds)),
  });
  const ofValue = (value: ShaderExpression): ShaderCost => {
    switch (value.op) {
      case 'constant':
      case 'local':
      case 'input':
        return { steps: 0, size: 1, rounds: 1 };
      case 'look':
        reads.add(value.channel);
        return sum([ofValue(value.offset)], SAMPLE_COST);
      case 'call':
        return sum([...value.args.map(ofValue), ofFunction(value.f)], 1);
      case 'apply':
        return sum(value.args.map(ofValue), value.f === 'inverse' ? INVERSE_COST : 1);
      case 'build':
        return sum(value.parts.map(ofValue), 1);
      default:
        return sum([ofValue(value.of)], 1);
    }
  };
  const ofSteps = (steps: readonly ShaderStatement[]): ShaderCost => sum(steps.map(ofStep));
  const ofStep = (step: ShaderStatement): ShaderCost => {
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
  const ofFunction = (index: number): ShaderCost => {
    const at = places[index] ?? { line: 1, column: 1 };
    const name = functions[index]?.name ?? '';
    if (open.has(index)) refuse(at, msg`${name} calls itself, which no shader can: write a loop`);
    const before = known.get(index);
    if (before) return before;
    open.add(index);
    const cost = ofSteps(functions[index]?.body ?? []);
    open.delete(index);
    if (cost.rounds > SHADER_TEXT_LIMITS.nested)
      refuse(
        at,
        msg`loops within loops of ${name} go round ${cost.rounds} times; more than ${SHADER_TEXT_LIMITS.nested} are not taken: take fewer`,
      );
    if (cost.size > SHADER_TEXT_LIMITS.size)
      refuse(
        at,
        msg`${name} has ${cost.size} operations, with those of the functions that it calls; more than ${SHADER_TEXT_LIMITS.size} are not taken`,
      );
    if (cost.steps > SHADER_TEXT_LIMITS.steps)
      refuse(
        at,
        msg`${name} takes ${cost.steps} steps for each pixel (a look at a pixel counts ${SAMPLE_COST}); more than ${SHADER_TEXT_LIMITS.steps} are not taken: let loops go round fewer times`,
      );
    known.set(index, cost);
    return cost;
  };

  for (const index of functions.keys()) ofFunction(index);
  reads.clear();
  known.clear();
  ofFunction(effect);
  return [...reads];
}
