import { afterEach, expect, it, vi } from 'vitest';
import { msg } from '../../messages/message.ts';
import type { Diagnostic } from '../../scene/types.ts';
import { reportOmissions } from './diagnostics.ts';

afterEach(() => vi.restoreAllMocks());

const info = (code: string, place: string, message = msg`its displacement is not drawn`): Diagnostic => ({
  severity: 'info',
  code,
  place,
  message,
});

it('what a picture lacks is printed once for all things of which it is said, and no more than five lines', () => {
  const print = vi.spyOn(console, 'error').mockImplementation(() => {});
  const many = Array.from({ length: 6 }, (_, i) =>
    info('gltf.ignored-extension', 'a.glb', msg`the extension ${`X_${i}`} is left out`),
  );
  reportOmissions([
    ...['/A', '/B', '/C'].map((path) => info('usd.material-input', path)),
    info('usd.units', 'a.usda'),
    { ...info('usd.material-input', '/D'), severity: 'warning' },
    ...many,
  ]);
  const lines = print.mock.calls.flat();
  expect(lines.slice(0, 2)).toEqual([
    'info: /A and 2 more: its displacement is not drawn',
    'info: a.glb: the extension X_0 is left out',
  ]);
  expect([lines.length, lines[5]]).toEqual([
    6,
    'info: 2 more remarks of what is not drawn; slowlight inspect lists them',
  ]);
});
