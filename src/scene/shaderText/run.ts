import { applyOperation, type Components, convertComponents, reshapeMatrix } from './arithmetic.ts';
import type {
  ShaderChannel,
  ShaderExpression,
  ShaderFunction,
  ShaderInput,
  ShaderProgram,
  ShaderStatement,
} from './program.ts';
import { componentCount } from './types.ts';

/** Inputs of a program at the current pixel. */
export interface PixelContext {
  look(channel: ShaderChannel, dx: number, dy: number): readonly number[];
  input(name: ShaderInput): readonly number[];
}

type ControlFlow = 'break' | 'continue' | { readonly value: Components } | undefined;

/** Evaluates a program at a pixel, in f64. */
export const runShaderProgram = (program: ShaderProgram, about: PixelContext): Components =>
  callFunction(program, program.effect, [], about);

function callFunction(
  program: ShaderProgram,
  index: number,
  args: readonly Components[],
  about: PixelContext,
): Components {
  const of = program.functions[index] as ShaderFunction;
  const end = new FunctionCall(program, of, args, about).steps(of.body);
  return typeof end === 'object' ? end.value : [];
}

class FunctionCall {
  private readonly locals: Components[];
  private readonly program: ShaderProgram;
  private readonly about: PixelContext;

  constructor(program: ShaderProgram, of: ShaderFunction, args: readonly Components[], about: PixelContext) {
    this.program = program;
    this.about = about;
    this.locals = of.locals.map((_, i) => args[i] ?? []);
  }

  steps(steps: readonly ShaderStatement[]): ControlFlow {
    for (const step of steps) {
      const end = this.step(step);
      if (end) return end;
    }
    return undefined;
  }

  private step(step: ShaderStatement): ControlFlow {
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

  private loop({ local, first, by, count, body }: ShaderStatement & { readonly op: 'for' }): ControlFlow {
    for (let k = 0; k < count; k++) {
      this.locals[local] = [first + k * by];
      const end = this.steps(body);
      if (end === 'break') return undefined;
      if (typeof end === 'object') return end;
    }
    return undefined;
  }

  private set(local: number, part: number | undefined, value: Components): void {
    const before = this.locals[local] ?? [];
    this.locals[local] = part === undefined ? value : before.map((x, i) => (i === part ? (value[0] ?? 0) : x));
  }

  private value(value: ShaderExpression): Components {
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
        return parts.length === 1 ? Array.from({ length: componentCount(value.type) }, () => parts[0] ?? 0) : parts;
      }
      case 'convert':
        return convertComponents(this.value(value.of), value.type);
      case 'reshape':
        return reshapeMatrix(this.value(value.of), value.of.type, value.type);
      case 'apply':
        return applyOperation(
          value.f,
          value.args.map((arg) => this.value(arg)),
          value.args.map(({ type }) => type),
        );
      case 'call':
        return callFunction(
          this.program,
          value.f,
          value.args.map((arg) => this.value(arg)),
          this.about,
        );
    }
  }
}
