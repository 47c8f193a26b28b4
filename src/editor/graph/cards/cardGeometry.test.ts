import { expect, it } from 'vitest';
import { cardSize, freePosition, withoutCoveringPictures } from './cardGeometry.ts';
import type { CardModel } from './cardModel.ts';

const card = (id: string, picture?: CardModel['picture']): CardModel => ({
  id,
  type: 'tone-map',
  category: 'render',
  title: id,
  muted: false,
  collapsed: false,
  rows: [],
  more: 0,
  hasPreview: false,
  blocked: false,
  ...(picture && { picture }),
});

it('a preview is omitted only where it would cover another node', () => {
  const [above, below, beside] = [card('above', 'metered'), card('below', 'plain'), card('beside')];
  const cards = new Map([above, below, beside].map((each) => [each.id, each]));
  const room = cardSize(above)[1];
  const tight = withoutCoveringPictures(cards, { above: [0, 0], below: [100, room - 1], beside: [300, 40] });
  expect([tight.get('above')?.picture, tight.get('below')?.picture]).toEqual([undefined, 'plain']);
  const pendingEnd = withoutCoveringPictures(cards, { above: [0, 0], below: [100, room], beside: [200, 40] });
  expect([...pendingEnd.values()]).toEqual([...cards.values()]);
});

it('a free position is below all obstacles', () => {
  const boxes = [
    { at: [0, 0] as const, size: [200, 100] as const },
    { at: [50, 130] as const, size: [200, 100] as const },
  ];
  expect(freePosition([10, 10], [200, 50], boxes)).toEqual([10, 254]);
  expect(freePosition([260, 10], [200, 50], boxes)).toEqual([260, 10]);
});
