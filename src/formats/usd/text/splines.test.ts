import { describe, expect, it } from 'vitest';
import type { AttributeSpec, Spline } from '../layer/layer.ts';
import { parseLayer } from './parser.ts';

function spline(text: string, type = 'double'): Spline | undefined {
  const layer = parseLayer(
    new TextEncoder().encode(`#usda 1.1\ndef "A"\n{\n${type} x.spline = {${text}}\n}\n`),
    'a.usda',
  );
  return (layer.rootPrims.get('A')!.properties.get('x') as AttributeSpec).spline;
}

const none = { width: 0, slope: 0, algorithm: 'none' };

describe('a spline', () => {
  it('has the authored values', () => {
    const text = `
      pre: sloped(0.25), post: loop oscillate,
      loop: (0, 4, 2, 1, 0.5),
      4: 2; pre (0.5, -1); post linear; { int a = 1 },
      -1: 5 & 7.5; post curve (2, 0.5, autoEase),
      8: 1; post none`;
    expect(spline(text)).toEqual({
      curve: 'bezier',
      before: { kind: 'sloped', slope: 0.25 },
      after: { kind: 'oscillate' },
      loop: { start: 0, end: 4, before: 2, after: 1, offset: 0.5 },
      knots: [
        {
          time: -1,
          value: 7.5,
          preValue: 5,
          interpolation: 'curve',
          pre: none,
          post: { width: 2, slope: 0.5, algorithm: 'autoEase' },
        },
        {
          time: 4,
          value: 2,
          interpolation: 'linear',
          pre: { width: 0.5, slope: -1, algorithm: 'none' },
          post: none,
          customData: new Map([['a', { type: 'int', data: 1 }]]),
        },
        { time: 8, value: 1, interpolation: 'none', pre: none, post: none },
      ],
    });
  });

  it('has held extrapolation by default', () => {
    const held = { kind: 'held' };
    expect(spline('')).toEqual({ curve: 'bezier', before: held, after: held, knots: [] });
    expect(spline('1: 2')!.knots[0].interpolation).toBe('held');
  });

  it('has values of its attribute’s type, and times and widths as doubles', () => {
    const { knots } = spline('0.1: 0.1; pre (0.1, 0.1)', 'float')!;
    const f = Math.fround(0.1);
    expect(knots[0]).toMatchObject({ time: 0.1, value: f, pre: { width: 0.1, slope: f } });
    expect(spline('0: 0.1', 'half')!.knots[0].value).toBe(0.0999755859375);
  });

  it('of Hermite curves has no tangent widths', () => {
    expect(spline('hermite, 1: 2; pre (1, 2); post curve (3)')!.knots[0]).toMatchObject({
      pre: { width: 0, slope: 2 },
      post: { width: 0, slope: 3 },
    });
  });

  it('keeps the first of two knots at one time, as usd-core does', () => {
    expect(spline('1: 5, 1: 7')!.knots.map((k) => k.value)).toEqual([5]);
  });

  it.each([
    ['1: 2; foo', 'double', "expected 'pre', 'post' or a dictionary, found 'foo'"],
    ['1: 2; post (1, 2)', 'double', 'expected none, held, linear or curve'],
    ['1: 2; post quick', 'double', "'quick' is not none, held, linear or curve"],
    ['1: nan', 'double', 'NaN cannot be in a spline'],
    ['1: 2; pre (-1, 2)', 'double', 'the width of a tangent is -1; it cannot be negative'],
    ['1: 2; pre (1, 2, 3)', 'double', "expected ')' after the width and the slope"],
    ['1: 2; pre (1, smooth)', 'double', "'smooth' is not custom or autoEase"],
    ['loop: (0, 1, 0.5, 1, 0)', 'double', 'is a whole number'],
    ['pre: loop twice', 'double', "'loop twice' is not"],
    ['pre: bent', 'double', "'bent' is not none, held, linear, sloped or loop"],
    ['cubic', 'double', "'cubic' is not bezier"],
    ['1: 2 3: 4', 'double', "expected ',' or '}' in a spline"],
    ['1: 2', 'int', 'a spline is of type double, float or half, not int'],
  ])('{ %s } of type %s is refused', (text, type, message) => {
    expect(() => spline(text, type)).toThrow(message);
  });
});
