import { describe, expect, it } from 'vitest';
import { inEnglish, msg } from '../../messages/message.ts';
import { DiagnosticLog, partOf } from './diagnosticLog.ts';

describe('diagnostics', () => {
  it('are recorded once, with their place', () => {
    const notes = new DiagnosticLog('a.obj');
    for (let i = 0; i < 3; i++) notes.add('warning', 'obj.missing-material', 'line 2', msg`no such file`);
    notes.add('info', 'file.units', '', msg`metres`);
    const list = notes
      .list()
      .map((each) => ({ ...each, place: inEnglish(each.place), message: inEnglish(each.message) }));
    expect(list).toEqual([
      { severity: 'warning', code: 'obj.missing-material', place: 'a.obj: line 2', message: 'no such file' },
      { severity: 'info', code: 'file.units', place: 'a.obj', message: 'metres' },
    ]);
  });

  it('of one code are limited to a hundred, and one that says so', () => {
    const notes = new DiagnosticLog('a.obj');
    for (let i = 0; i < 1000; i++) notes.add('warning', 'obj.missing-material', `line ${i}`, msg`no such file`);
    notes.add('info', 'file.units', '', msg`metres`);
    const list = notes.list();
    expect(list.length).toBe(102);
    expect(inEnglish(list[99].place)).toBe('a.obj: line 99');
    expect([list[100].place, inEnglish(list[100].message)]).toEqual([
      'a.obj',
      'there are more of these; the first 100 are listed',
    ]);
  });

  it('of less than a millimetre are one line, which has their number, the most and the first', () => {
    const notes = new DiagnosticLog('a.glb');
    const off = [4e-4, 2, 9e-4, 4e-4];
    for (const [i, metres] of off.entries())
      notes.add('warning', 'gltf.resampling', `node ${i}`, msg`moves wildly`, { off: metres });
    notes.add('info', 'usd.between-samples', 'alone', msg`goes straight`, { off: 1e-5 });
    expect(notes.list().map(({ place, message }) => [inEnglish(place), inEnglish(message)])).toEqual([
      [
        'a.glb',
        '3 things are elsewhere by less than a millimetre, at most 0.90 mm; the first is a.glb: node 0: moves wildly',
      ],
      ['a.glb: node 1', 'moves wildly'],
      ['a.glb: alone', 'goes straight'],
    ]);
  });

  it('say which part of the file they are of', () => {
    const notes = new DiagnosticLog('a.obj');
    notes.add('info', 'file.units', '/Box', msg`metres`);
    notes.add('info', 'file.units', '', msg`metres`);
    expect(notes.list().map(({ place }) => partOf('a.obj', place))).toEqual(['/Box', 'a.obj']);
    expect(partOf('b.obj', notes.list()[0]!.place)).toEqual(notes.list()[0]!.place);
  });
});
