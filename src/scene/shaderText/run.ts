import { apply, convert } from './arithmetic.ts';
import type { Channel, Input, Program, ProgramFunction, Step, Value } from './program.ts';
import { sizeOf } from './types.ts';

/** What a program is told of the pixel that it works on. */
export interface Surroundings {
  look(channel: Channel, dx: number, dy: number): readonly number[];
  input(name: Input): readonly number[];
}

type Numbers = readonly number[];
type End = 'break' | 'continue' | { readonly value: Numbers } | undefined;

/** The colour that a program gives a pixel, in f64. */
export const run = (program: Program, about: Surroundings): Numbers => call(program, program.effect, [], about);

function call(program: Program, index: number, args: readonly Numbers[], about: Surroundings): Numbers {
  const of = program.functions[index] as ProgramFunction;
  const end = new Call(program, of, args, about).steps(of.body);
  return typeof end === 'object' ? end.value : [];
}

class Call {
  private readonly locals: Numbers[];
  private readonly program: Program;
  private readonly about: Surroundings;

  constructor(program: Program, of: ProgramFunction, args: readonly Numbers[], about: Surroundings) {
    this.program = program;
    this.about = about;
    this.locals = of.locals.map((_, i) => args[i] ?? []);
  }

  steps(steps: readonly Step[]): End {
    for (const step of steps) {
      const end = this.step(step);
      if (end) return end;
    }
    return undefined;
  }

  private step(step: Step): End {
    switch (step.op) {
      case 'set':
        this.set(step.local, step.part, this.value(step.value));
        return undefined;
      case 'if':
        return this.steps(this.value(step.test)[0] ? step.yes : step.no);
      case 'for':
        return this.loop(step);
      case 'return':
        return { value: this.value(step.value) };
      default:
        return step.op;
    }
  }

  private loop({ local, first, by, count, body }: Step & { readonly op: 'for' }): End {
    for (let k = 0; k < count; k++) {
      this.locals[local] = [first + k * by];
      const end = this.steps(body);
      if (end === 'break') return undefined;
      if (typeof end === 'object') return end;
    }
    return undefined;
  }

  private set(local: number, part: number | undefined, value: Numbers): void {
    const before = this.locals[local] ?? [];
    this.locals[local] = part === undefined ? value : before.map((x, i) => (i === part ? (value[0] ?? 0) : x));
  }

  private value(value: Value): Numbers {
    switch (value.op) {
      case 'constant':
        return value.numbers;
      case 'local':
        return this.locals[value.local] ?? [];
      case 'input':
        return this.about.input(value.input);
      case 'look': {
        const [dx = 0, dy = 0] = this.value(value.offset);
        return this.about.look(value.channel, dx, dy);
      }
      case 'parts': {
        const of = this.value(value.of);
        return value.parts.map((part) => of[part] ?? 0);
      }
      case 'column':
        return this.value(value.of).slice(value.type.rows * value.column, value.type.rows * (value.column + 1));
      case 'build': {
        const parts = value.parts.flatMap((part) => this.value(part));
        return parts.length === 1 ? Array.from({ length: sizeOf(value.type) }, () => parts[0] ?? 0) : parts;
      }
      case 'convert':
        return convert(this.value(value.of), value.type);
      case 'apply':
        return apply(
          value.f,
          value.args.map((arg) => this.value(arg)),
          value.args.map(({ type }) => type),
        );
      case 'call':
        return call(
          this.program,
          value.f,
          value.args.map((arg) => this.value(arg)),
          this.about,
        );
    }
  }
}
