import { radians } from '../math/angle.ts';
import { type LocalizedText, type Message, msg } from '../messages/message.ts';
import { MessageError } from '../messages/messageError.ts';

/**
 * Expressions in number fields: `0.9*c`, `30deg`, `5 km/h`, `2*pi/3`. Evaluated on input to a number in the field's
 * unit, which the document stores. A recursive-descent parser with dimensional analysis.
 */
export type ExpressionResult =
  | { readonly value: number }
  /** `at`: offset in the text [characters]. */
  | { readonly problem: Message; readonly at: number };

/** What an expression may refer to. */
export interface ExpressionContext {
  /** Unit of the field; numbers without a unit are in it. */
  readonly unit?: string;
  /** [m/s]; without it `c` is not defined. */
  readonly speedOfLight?: number;
}

const MAX_LENGTH = 200;
const MAX_DEPTH = 32;

/** Exponents of metre, second, kelvin and radian. */
type Dimensions = readonly [length: number, time: number, temperature: number, angle: number];
interface DimensionedValue {
  readonly value: number;
  readonly of: Dimensions;
}

const NONE: Dimensions = [0, 0, 0, 0];
const LENGTH: Dimensions = [1, 0, 0, 0];
const TIME: Dimensions = [0, 1, 0, 0];
const SPEED: Dimensions = [1, -1, 0, 0];
const ANGLE: Dimensions = [0, 0, 0, 1];

/** In SI units. */
const UNITS: Readonly<Record<string, DimensionedValue>> = {
  m: { value: 1, of: LENGTH },
  km: { value: 1e3, of: LENGTH },
  cm: { value: 1e-2, of: LENGTH },
  mm: { value: 1e-3, of: LENGTH },
  um: { value: 1e-6, of: LENGTH },
  µm: { value: 1e-6, of: LENGTH },
  nm: { value: 1e-9, of: LENGTH },
  au: { value: 149_597_870_700, of: LENGTH },
  ly: { value: 9_460_730_472_580_800, of: LENGTH },
  s: { value: 1, of: TIME },
  ms: { value: 1e-3, of: TIME },
  us: { value: 1e-6, of: TIME },
  µs: { value: 1e-6, of: TIME },
  ns: { value: 1e-9, of: TIME },
  min: { value: 60, of: TIME },
  h: { value: 3600, of: TIME },
  K: { value: 1, of: [0, 0, 1, 0] },
  Hz: { value: 1, of: [0, -1, 0, 0] },
  rad: { value: 1, of: ANGLE },
  deg: { value: radians(1), of: ANGLE },
  '°': { value: radians(1), of: ANGLE },
  turn: { value: 2 * Math.PI, of: ANGLE },
  '%': { value: 0.01, of: NONE },
  pi: { value: Math.PI, of: NONE },
  π: { value: Math.PI, of: NONE },
};

type FunctionSpec = { readonly arity: number; readonly of: (...values: number[]) => number };
const unaryFunction = (of: (value: number) => number): FunctionSpec => ({ arity: 1, of });

/** Of numbers; angles in radians. */
const FUNCTIONS: Readonly<Record<string, FunctionSpec>> = {
  sin: unaryFunction(Math.sin),
  cos: unaryFunction(Math.cos),
  tan: unaryFunction(Math.tan),
  asin: unaryFunction(Math.asin),
  acos: unaryFunction(Math.acos),
  atan: unaryFunction(Math.atan),
  sqrt: unaryFunction(Math.sqrt),
  exp: unaryFunction(Math.exp),
  ln: unaryFunction(Math.log),
  log10: unaryFunction(Math.log10),
  abs: unaryFunction(Math.abs),
  /** γ at speed β. */
  gamma: unaryFunction((beta) => 1 / Math.sqrt((1 - beta) * (1 + beta))),
  /** β at a given γ. */
  beta: unaryFunction((gamma) => Math.sqrt((1 - 1 / gamma) * (1 + 1 / gamma))),
};

/**
 * Evaluates the text of a number field; a fault is part of the result.
 * @example
 * evaluateExpression('0.9*c', { unit: 'm/s', speedOfLight: 10 }); // { value: 9 }
 * evaluateExpression('36 km/h', { unit: 'm/s' }); // { value: 10 }
 * evaluateExpression('2 *'); // { at: 3 }
 */
export function evaluateExpression(text: string, { unit, speedOfLight }: ExpressionContext = {}): ExpressionResult {
  if (text.length > MAX_LENGTH) return { problem: msg`longer than ${MAX_LENGTH} characters`, at: MAX_LENGTH };
  try {
    const parser = new ExpressionParser(tokenizeExpression(text), speedOfLight);
    return { value: toFieldUnit(parser.parse(), unit, speedOfLight) };
  } catch (error) {
    if (error instanceof ParseError) return { problem: error.text, at: error.at };
    throw error;
  }
}

class ParseError extends MessageError {
  readonly at: number;
  constructor(text: Message, at: number) {
    super(text);
    this.at = at;
  }
}

/** A quantity in the field's unit. */
function toFieldUnit(
  { value, of }: DimensionedValue,
  unit: string | undefined,
  speedOfLight: number | undefined,
): number {
  const field = unit === undefined ? undefined : unitOf(unit, speedOfLight);
  const result = sameDimensions(of, NONE) ? value : value / (field?.value ?? 1);
  // A field without a unit accepts angles, in radians.
  const fits =
    sameDimensions(of, NONE) || sameDimensions(of, field?.of ?? NONE) || (!field && sameDimensions(of, ANGLE));
  if (!fits) throw new ParseError(msg`a value in ${unitName(of)} where ${unit ?? msg`a plain number`} is wanted`, 0);
  if (!Number.isFinite(result)) throw new ParseError(msg`this is no finite number`, 0);
  return result;
}

/** A field's unit, `m/s` or `c`; undefined for units that are not parsed, such as EV. */
function unitOf(unit: string, speedOfLight: number | undefined): DimensionedValue | undefined {
  try {
    return new ExpressionParser(tokenizeExpression(unit), speedOfLight).parse();
  } catch (error) {
    if (error instanceof ParseError) return undefined;
    throw error;
  }
}

const sameDimensions = (a: Dimensions, b: Dimensions): boolean => a.every((power, i) => power === b[i]);

function unitName(of: Dimensions): LocalizedText {
  const parts = ['m', 's', 'K', 'rad'].flatMap((name, i) =>
    of[i] === 0 ? [] : [of[i] === 1 ? name : `${name}^${of[i]}`],
  );
  return parts.join('·') || msg`no unit`;
}

interface ExpressionToken {
  readonly kind: 'number' | 'name' | 'sign' | 'end';
  readonly text: string;
  readonly at: number;
}

const TOKEN = /\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|(°|%|[\p{L}µ][\p{L}\d]*)|([-+*/^(),·×÷−]))/uy;
const SIGNS: Readonly<Record<string, string>> = { '·': '*', '×': '*', '÷': '/', '−': '-' };

function tokenizeExpression(text: string): ExpressionToken[] {
  const found: ExpressionToken[] = [];
  const end = text.trimEnd().length;
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < end) {
    const at = TOKEN.lastIndex;
    const match = TOKEN.exec(text);
    if (!match) throw new ParseError(msg`"${text.slice(at).trim()[0]}" is not understood`, at);
    const [, number, name, sign] = match;
    if (number !== undefined) found.push({ kind: 'number', text: number, at });
    else if (name !== undefined) found.push({ kind: 'name', text: name, at });
    else found.push({ kind: 'sign', text: SIGNS[sign!] ?? sign!, at });
  }
  return [...found, { kind: 'end', text: '', at: end }];
}

/** sum = product {± product}; product = signed {(×|÷) signed}; signed = [±] power {power}; power = factor [^ [±] factor]. */
class ExpressionParser {
  private readonly tokens: readonly ExpressionToken[];
  private readonly speedOfLight: number | undefined;
  private at = 0;
  private depth = 0;

  constructor(list: readonly ExpressionToken[], speedOfLight: number | undefined) {
    this.tokens = list;
    this.speedOfLight = speedOfLight;
  }

  parse(): DimensionedValue {
    const result = this.sum();
    if (this.next.kind !== 'end') throw this.unexpected();
    return result;
  }

  private get next(): ExpressionToken {
    return this.tokens[this.at]!;
  }

  private unexpected(): ParseError {
    const { text, at, kind } = this.next;
    return new ParseError(
      kind === 'end' ? msg`something is missing at the end` : msg`"${text}" does not belong here`,
      at,
    );
  }

  private sign(...wanted: readonly string[]): string | undefined {
    const { kind, text } = this.next;
    if (kind !== 'sign' || !wanted.includes(text)) return undefined;
    this.at++;
    return text;
  }

  private sum(): DimensionedValue {
    let sum = this.product();
    for (let at = this.next.at, sign = this.sign('+', '-'); sign; at = this.next.at, sign = this.sign('+', '-')) {
      const term = this.product();
      if (!sameDimensions(sum.of, term.of))
        throw new ParseError(msg`${unitName(sum.of)} and ${unitName(term.of)} do not add`, at);
      sum = { value: sign === '+' ? sum.value + term.value : sum.value - term.value, of: sum.of };
    }
    return sum;
  }

  private product(): DimensionedValue {
    let product = this.signed();
    for (let sign = this.sign('*', '/'); sign; sign = this.sign('*', '/'))
      product = multiplyQuantities(product, this.signed(), sign === '*' ? 1 : -1);
    return product;
  }

  private signed(): DimensionedValue {
    return this.deeper(() => {
      const sign = this.sign('+', '-');
      if (!sign) return this.measured();
      const { value, of } = this.signed();
      return { value: sign === '-' ? -value : value, of };
    });
  }

  /** A factor with its units or parenthesized factors: `5 km`, `2pi`, `3(1 + 2)`. */
  private measured(): DimensionedValue {
    let value = this.power();
    while (this.next.kind === 'name' || (this.next.kind === 'sign' && this.next.text === '('))
      value = multiplyQuantities(value, this.power(), 1);
    return value;
  }

  private power(): DimensionedValue {
    const base = this.factor();
    const { at } = this.next;
    if (!this.sign('^')) return base;
    const sign = this.sign('+', '-') === '-' ? -1 : 1;
    const { value, of } = this.factor();
    if (!sameDimensions(of, NONE)) throw new ParseError(msg`an exponent is a plain number`, at);
    if (!sameDimensions(base.of, NONE) && !Number.isInteger(value))
      throw new ParseError(msg`what has a unit is raised to whole numbers only`, at);
    return { value: base.value ** (sign * value), of: scaleDimensions(base.of, sign * value) };
  }

  private factor(): DimensionedValue {
    const token = this.next;
    if (token.kind === 'number') {
      this.at++;
      return { value: Number(token.text), of: NONE };
    }
    if (token.kind === 'name') return this.named(token);
    if (this.sign('(') === undefined) throw this.unexpected();
    const inner = this.deeper(() => this.sum());
    if (this.sign(')') === undefined) throw new ParseError(msg`a bracket is not closed`, token.at);
    return inner;
  }

  private named({ text, at }: ExpressionToken): DimensionedValue {
    this.at++;
    const bracket = this.next.kind === 'sign' && this.next.text === '(';
    if (bracket && Object.hasOwn(FUNCTIONS, text)) return this.called(FUNCTIONS[text]!, text, at);
    if (text === 'c' && this.speedOfLight !== undefined) return { value: this.speedOfLight, of: SPEED };
    if (Object.hasOwn(UNITS, text)) return UNITS[text]!;
    throw new ParseError(msg`"${text}" is neither a unit nor a function`, at);
  }

  private called({ arity, of }: FunctionSpec, name: string, at: number): DimensionedValue {
    this.sign('(');
    const values = [this.deeper(() => this.sum())];
    while (this.sign(',')) values.push(this.deeper(() => this.sum()));
    if (this.sign(')') === undefined) throw new ParseError(msg`a bracket is not closed`, at);
    if (values.length !== arity)
      throw new ParseError(msg`${name} takes ${arity === 1 ? msg`one value` : msg`${arity} values`}`, at);
    if (values.some((value) => !sameDimensions(value.of, NONE) && !sameDimensions(value.of, ANGLE)))
      throw new ParseError(msg`${name} is of plain numbers and angles`, at);
    return { value: of(...values.map(({ value }) => value)), of: NONE };
  }

  private deeper(parse: () => DimensionedValue): DimensionedValue {
    if (++this.depth > MAX_DEPTH) throw new ParseError(msg`too many brackets in one another`, this.next.at);
    const result = parse();
    this.depth--;
    return result;
  }
}

const multiplyQuantities = (a: DimensionedValue, b: DimensionedValue, power: 1 | -1): DimensionedValue => ({
  value: power === 1 ? a.value * b.value : a.value / b.value,
  of: [0, 1, 2, 3].map((i) => a.of[i]! + power * b.of[i]!) as unknown as Dimensions,
});

const scaleDimensions = (of: Dimensions, power: number): Dimensions =>
  sameDimensions(of, NONE) ? NONE : (of.map((p) => p * power) as unknown as Dimensions);
