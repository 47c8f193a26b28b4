import { describe, expect, it } from 'vitest';
import { messageTranslator } from './translateMessage.ts';

const translate = messageTranslator({
  'it ended at {} s: {}': '于 {1} s 结束：{2}',
  '{} of {}': '{2} 的 {1}',
  'vertex {} of {}': '{2} 的顶点 {1}',
  '{} has no place any more': '{1} 已没有位置',
  'at rest': '静止',
  '{}: {}': '{1}：{2}',
  node: '节点',
  'there is no {}': '没有{1}',
  '{}{} is muted': '{1}{2} 已静音',
});

describe('a translated message', () => {
  it('has its values in the order of the translation', () => {
    expect(translate('vertex 3 of /Cloth')).toBe('/Cloth 的顶点 3');
    expect(translate('vertex 10 of 3 of 7')).toBe('7 的 3 的顶点 10');
  });

  it('translates nested messages', () => {
    expect(translate('it ended at 0.5 s: vertex 3 of /Cloth has no place any more')).toBe(
      '于 0.5 s 结束：/Cloth 的顶点 3 已没有位置',
    );
    expect(translate('run: at rest')).toBe('run：静止');
  });

  it('does not translate names', () => {
    expect(translate('node')).toBe('node');
    expect(translate('there is no node')).toBe('没有节点');
  });

  it('is unchanged without a matching pattern', () => {
    for (const sentence of ['', 'nobody said this', 'a: b', 'vertex', 'it ended at', '已保存 a: b'])
      expect(translate(sentence)).toBe(sentence);
  });

  it('uses the pattern with the most literal text, matching completely', () => {
    expect(translate('vertex 1 of 2')).toBe('2 的顶点 1');
    expect(translate('at rest of all')).toBe('all 的 静止');
    expect(translate('a/b is muted')).toBe('a/b 已静音');
    expect(translate('{1} has no place any more')).toBe('{1} 已没有位置');
  });

  it('uses the pattern whose nested values are translated most', () => {
    const also = messageTranslator({
      '{}: {}': '{1}：{2}',
      '{} or {}': '{1} 或 {2}',
      'line {}': '行 {1}',
      'the file is damaged or cut off ({})': '文件已损坏或被截断（{1}）',
      '{} is too large': '{1} 太大',
    });
    expect(also('a.obj: line 3: the file is damaged or cut off (no end)')).toBe(
      'a.obj：行 3：文件已损坏或被截断（no end）',
    );
    expect(also('a.obj: line 3: 1e99 is too large')).toBe('a.obj：行 3：1e99 太大');
    expect(also('1 or 2 is too large')).toBe('1 或 2 太大');
  });

  it('is found quickly, also for adversarially long texts', () => {
    const hard = messageTranslator({
      ...Object.fromEntries(Array.from('abcdefghij', (x) => [`{}${x}{}: {}`, x])),
      '{}: {}': '{1}：{2}',
    });
    // Without the bound it would not terminate in reasonable time.
    expect(hard('abcdefghij: '.repeat(160))).toMatch(/^[a-j]$/);
    expect(translate('vertex '.repeat(100_000))).toHaveLength(700_000);
  });
});
