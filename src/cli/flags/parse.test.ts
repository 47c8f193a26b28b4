import { describe, expect, test } from 'vitest';
import { InvalidValue } from '../terminal/commandLineErrors.ts';
import { parseAovs, parseBeta, parseFrames, parsePixel, parsePort, parseSize, parseVec3 } from './parse.ts';

describe('flag values', () => {
  test('are parsed', () => {
    expect(parseSize('640x360')).toEqual({ width: 640, height: 360 });
    expect(parseVec3('1,-2.5, 3e2')).toEqual([1, -2.5, 300]);
    expect(parseBeta('0,0,-0.999999')).toEqual([0, 0, -0.999999]);
    expect(parseFrames('-4:12')).toEqual({ first: -4, last: 12 });
    expect(parseAovs('depth, doppler,depth')).toEqual(['depth', 'doppler']);
    expect(parseAovs('emission_time,depth')).toEqual(['emission_time', 'emission_time_relative', 'depth']);
    expect(parsePixel('10,20.5')).toEqual([10, 20.5]);
  });

  const wrong: [string, (text: string) => unknown, string][] = [
    ['a size without height', parseSize, '640'],
    ['a size of nothing', parseSize, '0x10'],
    ['two numbers for three', parseVec3, '1,2'],
    ['an empty number', parseVec3, '1,,2'],
    ['light as an observer', parseBeta, '0.6,0.8,0'],
    ['frames backwards', parseFrames, '5:4'],
    ['an unknown AOV', parseAovs, 'depth,colour'],
    ['a port that is none', parsePort, '70000'],
  ];
  test.each(wrong)('%s is rejected', (_, parse, text) => {
    expect(() => parse(text)).toThrow(InvalidValue);
  });
});
