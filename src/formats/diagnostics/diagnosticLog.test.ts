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

  it('say which part of the file they are of', () => {
    const notes = new DiagnosticLog('a.obj');
    notes.add('info', 'file.units', '/Box', msg`metres`);
    notes.add('info', 'file.units', '', msg`metres`);
    expect(notes.list().map(({ place }) => partOf('a.obj', place))).toEqual(['/Box', 'a.obj']);
    expect(partOf('b.obj', notes.list()[0]!.place)).toEqual(notes.list()[0]!.place);
  });
});
