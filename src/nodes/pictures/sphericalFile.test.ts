import { expect, it } from 'vitest';
import { IDENTITY } from '../../math/quat.ts';
import { domeLens } from '../../scene/view/lenses/fisheyeLens.ts';
import type { Lens } from '../../scene/view/lenses/lenses.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import type { PictureView } from '../../scene/view/pictureViews.ts';
import { sphericalFileOf } from './sphericalFile.ts';

const view = (lens: Lens): PictureView => ({ t: 0, position: [0, 0, 0], u: [0, 0, 0], orientation: IDENTITY, lens });
const AROUND = view({ kind: 'equirectangular' });

it('a file is marked if it is a whole sphere in a layout that players know', () => {
  const equirectangular = { projection: 'equirectangular', stereo: 'none' };
  expect(sphericalFileOf([AROUND], { width: 64, height: 32 })).toEqual(equirectangular);
  const cube = view({ kind: 'cube', layout: '3x2' });
  expect(sphericalFileOf([cube], { width: 96, height: 64 })).toEqual({ projection: 'cubemap', stereo: 'none' });
});

it('a file is not marked with a legend below it, several views, or a lens without a mark', () => {
  expect(sphericalFileOf([AROUND], { width: 64, height: 50 })).toBeUndefined();
  const half = { ...AROUND, viewport: { x: 0, y: 0, width: 64, height: 32 } };
  const other = { ...AROUND, viewport: { x: 0, y: 32, width: 64, height: 32 } };
  expect(sphericalFileOf([half, other], { width: 64, height: 64 })).toBeUndefined();
  const size = { width: 60, height: 10 };
  for (const lens of [perspective(1), domeLens(Math.PI, 0), { kind: 'cube', layout: '6x1' }] as const)
    expect(sphericalFileOf([view(lens)], size)).toBeUndefined();
});
