import { fromHalf, toHalf } from '../../../math/half.ts';
import { msg } from '../../../messages/message.ts';
import type { Dictionary, Extrapolation, Spline, SplineKnot, SplineLoop, Tangent } from '../layer/layer.ts';
import type { Scanner } from './scanner.ts';
import { parseDictionary } from './values.ts';

type Rounding = (x: number) => number;
const identity: Rounding = (x) => x;

/** Number types of splines, and their rounding. */
const ROUNDINGS: ReadonlyMap<string, Rounding> = new Map([
  ['double', identity],
  ['float', Math.fround],
  ['half', (x) => fromHalf(toHalf(x))],
  ['timecode', identity],
]);

const NO_TANGENT: Tangent = { width: 0, slope: 0, algorithm: 'none' };

/** `{ bezier, pre: held, 1: 5; post curve (2, 0.3), … }`: of two knots at one time the first stands, as in OpenUSD. */
export function parseSpline(s: Scanner, typeName: string): Spline {
  const round = ROUNDINGS.get(typeName);
  if (!round) return s.fail(msg`a spline is of type double, float or half, not ${typeName}`);
  const head: Partial<Record<'before' | 'after', Extrapolation>> & { curve?: Spline['curve']; loop?: SplineLoop } = {};
  const knots = new Map<number, SplineKnot>();
  s.expect('{', msg`before a spline`);
  while (!s.take('}')) {
    const word = s.takeName();
    if (word === 'bezier' || word === 'hermite') head.curve = word;
    else if (word === 'pre') head.before = parseExtrapolation(s);
    else if (word === 'post') head.after = parseExtrapolation(s);
    else if (word === 'loop') head.loop = parseLoop(s);
    else if (word === undefined) addKnot(s, round, knots);
    else s.fail(msg`'${word}' is not bezier, hermite, pre, post, loop or the time of a knot`);
    if (!s.take(',') && s.peek() !== '}') s.expected(msg`',' or '}' in a spline`);
  }
  const { curve = 'bezier', before = { kind: 'held' }, after = { kind: 'held' }, loop } = head;
  const sorted = [...knots.values()].sort((a, b) => a.time - b.time);
  return {
    curve,
    before,
    after,
    ...(loop ? { loop } : {}),
    knots: curve === 'hermite' ? sorted.map(withoutWidths) : sorted,
  };
}

const withoutWidths = (knot: SplineKnot): SplineKnot => ({
  ...knot,
  pre: { ...knot.pre, width: 0 },
  post: { ...knot.post, width: 0 },
});

/** `: held`, `: sloped(0.5)`, `: loop repeat` */
function parseExtrapolation(s: Scanner): Extrapolation {
  s.expect(':', msg`before the kind of extrapolation`);
  const word = s.name(msg`none, held, linear, sloped or loop`);
  if (word === 'none' || word === 'held' || word === 'linear') return { kind: word };
  if (word === 'sloped') {
    s.expect('(', msg`before a slope`);
    const slope = finite(s);
    s.expect(')', msg`after a slope`);
    return { kind: 'sloped', slope };
  }
  if (word !== 'loop') s.fail(msg`'${word}' is not none, held, linear, sloped or loop`);
  const mode = s.name(msg`repeat, reset or oscillate`);
  if (mode !== 'repeat' && mode !== 'reset' && mode !== 'oscillate')
    return s.fail(msg`'loop ${mode}' is not loop repeat, loop reset or loop oscillate`);
  return { kind: mode };
}

const isInt32 = (x: number): boolean => (x | 0) === x;

/** `: (start, end, before, after, offset)` */
function parseLoop(s: Scanner): SplineLoop {
  s.expect(':', msg`after 'loop'`);
  s.expect('(', msg`before the five numbers of a loop`);
  const numbers = Array.from({ length: 5 }, (_, i) => {
    if (i > 0) s.expect(',', msg`between the five numbers of a loop`);
    return finite(s);
  });
  s.expect(')', msg`after the five numbers of a loop`);
  const [start, end, before, after, offset] = numbers;
  if (!isInt32(before) || !isInt32(after)) s.fail(msg`how often a spline is looped, is a whole number`);
  return { start, end, before, after, offset };
}

/** `time: value` or `time: preValue & value`, then what shapes it, each after a ';'. */
function addKnot(s: Scanner, round: Rounding, knots: Map<number, SplineKnot>): void {
  const time = finite(s);
  s.expect(':', msg`after the time ${time}`);
  const first = round(finite(s));
  const value = s.take('&') ? round(finite(s)) : undefined;
  const shape = parseShape(s, round);
  const values = value === undefined ? { value: first } : { value, preValue: first };
  if (!knots.has(time)) knots.set(time, { time, ...values, ...shape });
}

type KnotShape = Omit<SplineKnot, 'time' | 'value' | 'preValue'>;

/** `; pre (1, 0.5); post curve (2, 0.3); { int a = 1 }` */
function parseShape(s: Scanner, round: Rounding): KnotShape {
  let interpolation: KnotShape['interpolation'] = 'held';
  let [pre, post] = [NO_TANGENT, NO_TANGENT];
  let customData: Dictionary | undefined;
  while (s.take(';')) {
    if (s.peek() === '{') customData = parseDictionary(s);
    else if (s.takeKeyword('pre')) pre = parseTangent(s, round);
    else if (s.takeKeyword('post')) {
      interpolation = parseInterpolation(s);
      post = s.peek() === '(' ? parseTangent(s, round) : NO_TANGENT;
    } else s.expected(msg`'pre', 'post' or a dictionary`);
  }
  return { interpolation, pre, post, ...(customData?.size ? { customData } : {}) };
}

function parseInterpolation(s: Scanner): SplineKnot['interpolation'] {
  const word = s.name(msg`none, held, linear or curve`);
  if (word === 'none' || word === 'held' || word === 'linear' || word === 'curve') return word;
  return s.fail(msg`'${word}' is not none, held, linear or curve`);
}

/** `(slope)`, `(width, slope)`, either with the algorithm last. */
function parseTangent(s: Scanner, round: Rounding): Tangent {
  s.expect('(', msg`before a tangent`);
  const at = s.pos;
  const numbers = [finite(s)];
  let algorithm: Tangent['algorithm'] = 'none';
  while (s.take(',')) {
    const word = s.takeName();
    if (word !== undefined) {
      algorithm = algorithmOf(s, word);
      break;
    }
    if (numbers.length === 2) s.expected(msg`')' after the width and the slope of a tangent`);
    numbers.push(finite(s));
  }
  s.expect(')', msg`after a tangent`);
  const [width, slope] = numbers.length === 2 ? numbers : [0, numbers[0]];
  if (width < 0) s.fail(msg`the width of a tangent is ${width}; it cannot be negative`, at);
  return { width, slope: round(slope), algorithm };
}

function algorithmOf(s: Scanner, word: string): Tangent['algorithm'] {
  if (word === 'custom' || word === 'autoEase') return word;
  return s.fail(msg`'${word}' is not custom or autoEase`);
}

function finite(s: Scanner): number {
  const value = s.number();
  return Number.isFinite(value) ? value : s.fail(msg`${value} cannot be in a spline`);
}
