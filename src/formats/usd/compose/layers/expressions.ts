import { type LocalizedText, type Message, msg } from '../../../../messages/message.ts';
import { MessageError } from '../../../../messages/messageError.ts';
import { numbersOf } from '../../layer/attributes.ts';
import type { MetadataValue, Value } from '../../layer/layer.ts';

/** Values of expressions; integers are exact up to 2⁵³. */
export type ExpressionValue = string | number | boolean | null | readonly (string | number | boolean)[];
export type Variables = ReadonlyMap<string, ExpressionValue>;

/** Maximum steps of one evaluation: variables can nest. */
const MAX_STEPS = 1000;
const MAX_LENGTH = 65_536;

/** `` `"…"` `` in place of an asset path or a selection. */
export const isExpression = (text: string): boolean => text.startsWith('`');

/** The value of an expression (OpenUSD, Variable Expressions). Throws an ExpressionFault that says what is wrong. */
export const evaluate = (text: string, variables: Variables): ExpressionValue =>
  new ExpressionEvaluation(text, variables, [], { steps: MAX_STEPS }).whole();

/** Plain text unchanged, expressions evaluated; '' for no value. Throws an ExpressionFault. */
export function expandExpression(text: string, variables: Variables): string {
  if (!isExpression(text)) return text;
  const value = evaluate(text, variables) ?? '';
  if (typeof value !== 'string') throw new VariableExpressionError(msg`it makes ${typeNameOf(value)}, not text`);
  return value;
}

/** The same; returns the expression itself on error, which matches no name. */
export function expandOrKeep(text: string, variables: Variables): string {
  try {
    return expandExpression(text, variables);
  } catch (thrown) {
    if (thrown instanceof VariableExpressionError) return text;
    throw thrown;
  }
}

class VariableExpressionError extends MessageError {}

export const NO_VARIABLES: Variables = new Map();

/** A layer's variables, overridden by those of the referencing stack. */
export function variablesUnder(above: Variables, written: MetadataValue | undefined): Variables {
  if (written?.type !== 'dictionary') return above;
  const own = [...written.data].flatMap(([name, value]) => {
    const made = variableOf(value);
    return made === undefined ? [] : [[name, made] as const];
  });
  return own.length === 0 ? above : new Map([...own, ...above]);
}

function variableOf(value: Value): ExpressionValue | undefined {
  if (value.type === 'blocked') return null;
  if (!('data' in value)) return undefined;
  const { data } = value;
  if (typeof data === 'bigint') return Number(data);
  if (value.type === 'bool[]') return Array.from(value.data, Boolean);
  if (data instanceof BigInt64Array || data instanceof BigUint64Array) return Array.from(data, Number);
  if (Array.isArray(data)) return data.filter((item) => typeof item === 'string');
  if (typeof data === 'string' || typeof data === 'boolean' || typeof data === 'number') return data;
  return value.type === 'int[]' ? Array.from(numbersOf(value) ?? []) : undefined;
}

type ValueKind = 'none' | 'list' | 'number' | 'string' | 'boolean';

const KIND_NAMES: Readonly<Record<ValueKind, LocalizedText>> = {
  none: 'None',
  list: msg`a list`,
  number: msg`an integer`,
  string: msg`a string`,
  boolean: msg`a boolean`,
};

function kindOf(value: ExpressionValue): ValueKind {
  if (value === null) return 'none';
  if (typeof value === 'string') return 'string';
  if (typeof value === 'number') return 'number';
  return typeof value === 'boolean' ? 'boolean' : 'list';
}

const typeNameOf = (value: ExpressionValue): LocalizedText => KIND_NAMES[kindOf(value)];

type LazyValue = () => ExpressionValue;

const ESCAPED: ReadonlyMap<string, string> = new Map([
  ['n', '\n'],
  ['t', '\t'],
  ['r', '\r'],
]);

/** Parses to a tree of closures, so that branches not taken may fail. */
class ExpressionEvaluation {
  private readonly text: string;
  private readonly variables: Variables;
  /** Variables that are being evaluated. */
  private readonly within: readonly string[];
  private readonly budget: { steps: number };
  private at = 0;

  constructor(text: string, variables: Variables, within: readonly string[], budget: { steps: number }) {
    this.text = text;
    this.variables = variables;
    this.within = within;
    this.budget = budget;
  }

  whole(): ExpressionValue {
    if (!this.take('`')) this.fail(msg`it does not begin with '\`'`);
    const value = this.expression();
    if (!this.take('`') || this.at < this.text.length) this.fail(msg`it does not end with '\`' there`);
    return value();
  }

  private fail(message: Message): never {
    throw new VariableExpressionError(msg`${message} (character ${this.at} of ${this.text.slice(0, 80)})`);
  }

  private take(text: string): boolean {
    if (!this.text.startsWith(text, this.at)) return false;
    this.at += text.length;
    return true;
  }

  private space(): void {
    while (/\s/.test(this.text[this.at] ?? '')) this.at++;
  }

  private expression(): LazyValue {
    if (--this.budget.steps < 0) this.fail(msg`it takes too many steps`);
    if (this.text.startsWith('${', this.at)) return this.variable((value) => value);
    const literal = this.literal();
    if (literal) return literal;
    if (this.take('[')) return this.list();
    const name = this.match(/[A-Za-z_]\w*/y);
    if (name === undefined || !this.take('(')) return this.fail(msg`here is no expression`);
    const of = FUNCTIONS.get(name) ?? this.fail(msg`there is no function ${name}`);
    const args = this.items(')');
    const [least, most] = of.takes;
    if (args.length < least || args.length > most) this.fail(msg`${name} does not take ${args.length} arguments`);
    return () => of.call(args, this.variables);
  }

  private match(pattern: RegExp): string | undefined {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text)?.[0];
    this.at += found?.length ?? 0;
    return found;
  }

  private literal(): LazyValue | undefined {
    const quote = this.text[this.at];
    if (quote === '"' || quote === "'") return this.string(quote);
    const word = this.match(/(?:True|true|False|false|None|none)\b|-?\d+/y);
    if (word === undefined) return undefined;
    if (/^n/i.test(word)) return () => null;
    if (/^[tf]/i.test(word)) return () => /^t/i.test(word);
    const number = Number(word);
    return Number.isSafeInteger(number) ? () => number : this.fail(msg`${word} is too large`);
  }

  private string(quote: string): LazyValue {
    this.at++;
    const parts: (string | LazyValue)[] = [];
    while (!this.take(quote)) {
      if (this.at >= this.text.length) this.fail(msg`the text is not closed with ${quote}`);
      if (this.text.startsWith('${', this.at)) parts.push(this.variable(textOnly, true));
      else {
        const isEscaped = this.take('\\');
        const c = this.text[this.at++] ?? '';
        parts.push((isEscaped ? ESCAPED.get(c) : undefined) ?? c);
      }
    }
    return () => {
      const made = parts.map((part) => (typeof part === 'string' ? part : part())).join('');
      return made.length <= MAX_LENGTH ? made : this.fail(msg`it makes too long a text`);
    };
  }

  /** `${NAME}`, `${NAME:fallback}`; in a string, undefined variables stay as written. */
  private variable(use: (value: ExpressionValue, name: string) => ExpressionValue, inText = false): LazyValue {
    const start = this.at;
    this.take('${');
    const name = this.match(/[A-Za-z_]\w*/y) ?? this.fail(msg`a variable has a name of letters, digits and _`);
    const fallback = this.take(':') ? (this.literal() ?? this.fail(msg`a fallback value is missing`)) : undefined;
    if (!this.take('}')) this.fail(msg`the variable is not closed with '}'`);
    const written = this.text.slice(start, this.at);
    return () => {
      const value = this.variables.get(name);
      if (value !== undefined) return use(this.valueOf(name, value), name);
      if (fallback) return use(fallback(), name);
      return inText ? written : this.fail(msg`there is no value for the variable ${name}`);
    };
  }

  private valueOf(name: string, value: ExpressionValue): ExpressionValue {
    if (typeof value !== 'string' || !isExpression(value)) return value;
    if (this.within.includes(name)) this.fail(msg`the variable ${name} is made of itself`);
    return new ExpressionEvaluation(value, this.variables, [...this.within, name], this.budget).whole();
  }

  private list(): LazyValue {
    const items = this.items(']');
    return () => {
      const values = items.map((item) => item());
      const isOneKind = values.every((v) => v !== null && !Array.isArray(v) && typeof v === typeof values[0]);
      return isOneKind ? (values as (string | number | boolean)[]) : this.fail(msg`a list holds items of one kind`);
    };
  }

  private items(end: string): LazyValue[] {
    const items: LazyValue[] = [];
    this.space();
    if (this.take(end)) return items;
    for (;;) {
      this.space();
      items.push(this.expression());
      this.space();
      if (this.take(end)) return items;
      if (!this.take(',')) this.fail(msg`'${end}' is missing`);
    }
  }
}

function textOnly(value: ExpressionValue, name: string): string {
  if (value === null) return '';
  if (typeof value !== 'string')
    throw new VariableExpressionError(msg`the variable ${name} is ${typeNameOf(value)}, not text`);
  return value;
}

interface ExpressionFunction {
  readonly takes: readonly [least: number, most: number];
  call(args: readonly LazyValue[], variables: Variables): ExpressionValue;
}

function requireBoolean(value: ExpressionValue, who: string): boolean {
  if (typeof value !== 'boolean')
    throw new VariableExpressionError(msg`${who} asks for True or False, not ${typeNameOf(value)}`);
  return value;
}

const comparison = (name: string, holds: (order: number) => boolean): [string, ExpressionFunction] => [
  name,
  {
    takes: [2, 2],
    call: ([first, second]) => {
      const [a, b] = [first(), second()];
      if (Array.isArray(a) || Array.isArray(b) || typeof a !== typeof b || (a === null) !== (b === null))
        throw new VariableExpressionError(msg`${name} cannot compare ${typeNameOf(a)} with ${typeNameOf(b)}`);
      return holds(a === b ? 0 : (a as string) < (b as string) ? -1 : 1);
    },
  },
];

const FUNCTIONS: ReadonlyMap<string, ExpressionFunction> = new Map<string, ExpressionFunction>([
  [
    'if',
    {
      takes: [2, 3],
      call: ([condition, then, otherwise]) => {
        const holds = requireBoolean(condition(), 'if');
        const [a, b] = [then(), otherwise?.() ?? null];
        if (a !== null && b !== null && kindOf(a) !== kindOf(b))
          throw new VariableExpressionError(msg`both values of if are of one kind`);
        return holds ? a : b;
      },
    },
  ],
  ['and', { takes: [2, Infinity], call: (args) => args.every((arg) => requireBoolean(arg(), 'and')) }],
  ['or', { takes: [2, Infinity], call: (args) => args.some((arg) => requireBoolean(arg(), 'or')) }],
  ['not', { takes: [1, 1], call: ([arg]) => !requireBoolean(arg(), 'not') }],
  comparison('eq', (order) => order === 0),
  comparison('neq', (order) => order !== 0),
  comparison('lt', (order) => order < 0),
  comparison('leq', (order) => order <= 0),
  comparison('gt', (order) => order > 0),
  comparison('geq', (order) => order >= 0),
  ['defined', { takes: [1, Infinity], call: (args, variables) => args.every((arg) => variables.has(textOf(arg()))) }],
  ['len', { takes: [1, 1], call: ([arg]) => (typeof arg() === 'string' ? utf8(arg()).length : listOf(arg()).length) }],
  [
    'contains',
    {
      takes: [2, 2],
      call: ([within, item]) => {
        const [all, one] = [within(), item()];
        if (typeof all === 'string') return all.includes(textOf(one));
        const list = listOf(all);
        if (one === null || Array.isArray(one) || (list.length > 0 && typeof list[0] !== typeof one))
          throw new VariableExpressionError(msg`contains cannot look for ${typeNameOf(one)} there`);
        return list.includes(one as string);
      },
    },
  ],
  [
    'at',
    {
      takes: [2, 2],
      call: ([within, index]) => {
        const [all, i] = [within(), index()];
        if (typeof i !== 'number') throw new VariableExpressionError(msg`at takes an integer, not ${typeNameOf(i)}`);
        const found = (typeof all === 'string' ? all : listOf(all)).at(i);
        if (found === undefined) throw new VariableExpressionError(msg`there is no item ${i}`);
        return found;
      },
    },
  ],
]);

const utf8 = (value: ExpressionValue): Uint8Array => new TextEncoder().encode(textOf(value));

function textOf(value: ExpressionValue): string {
  if (typeof value !== 'string') throw new VariableExpressionError(msg`text is asked for, not ${typeNameOf(value)}`);
  return value;
}

function listOf(value: ExpressionValue): readonly (string | number | boolean)[] {
  if (!Array.isArray(value))
    throw new VariableExpressionError(msg`a list or text is asked for, not ${typeNameOf(value)}`);
  return value;
}
