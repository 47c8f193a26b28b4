import { IDENTITY } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { Key } from '../../scene/compose/paths.ts';
import { refusal, rotation } from './shared.ts';

type Numbers = [number, number, number, number, ...([] | [number, number, number])];

/** Most places of a path. */
const MOST = 10_000;

/** `x y z` in each text [m]; at least two, no two neighbours the same. */
export function readPlaces(texts: readonly string[], node: string): Vec3[] {
  const places = texts.map((text, i) => numbersIn(text, [3], `${node}.places ${i + 1}`) as unknown as Vec3);
  checkCount(places, `${node}.places`);
  places.slice(1).forEach((place, i) => {
    if (place.every((x, k) => x === places[i]![k]))
      throw refusal('path.same', `${node}.places ${i + 2}`, 'it is the place before it again; leave one of them out');
  });
  return places;
}

/** `t x y z` or `t x y z rx ry rz` in each text [s, m, °]; times rise. */
export function readKeys(texts: readonly string[], node: string): Key[] {
  const keys = texts.map((text, i): Key => {
    const [time, x, y, z, ...angles] = numbersIn(text, [4, 7], `${node}.keys ${i + 1}`) as Numbers;
    return { time, position: [x, y, z], orientation: angles.length === 3 ? rotation(angles) : IDENTITY };
  });
  checkCount(keys, `${node}.keys`);
  keys.slice(1).forEach(({ time }, i) => {
    if (!(time > keys[i]!.time)) {
      const message = `its time ${time} s is not after ${keys[i]!.time} s, that of the one before it; put them in order`;
      throw refusal('keys.order', `${node}.keys ${i + 2}`, message);
    }
  });
  return keys;
}

function checkCount(all: readonly unknown[], place: string): void {
  if (all.length < 2)
    throw refusal('path.short', place, `it takes at least two; there ${all.length === 1 ? 'is one' : 'are none'}`);
  if (all.length > MOST) throw refusal('path.long', place, `there are ${all.length}, more than ${MOST}; take fewer`);
}

function numbersIn(text: string, counts: readonly number[], place: string): number[] {
  const numbers = text
    .trim()
    .split(/[\s,;]+/)
    .map(Number);
  if (counts.includes(numbers.length) && numbers.every(Number.isFinite)) return numbers;
  throw refusal(
    'path.numbers',
    place,
    `"${text.slice(0, 80)}" is not ${counts.join(' or ')} numbers; write them with blanks between them`,
  );
}
