import { IDENTITY } from '../../math/quat.ts';
import type { Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import type { PoseKey } from '../../scene/compose/motionPaths.ts';
import { nodeRefusal, rotationXYZ } from '../common/params.ts';

type KeyframeRow = [number, number, number, number, ...([] | [number, number, number])];

/** Maximum number of keys. */
const MAX_KEYS = 10_000;

/** `x y z` per text [m]; at least two, neighbours distinct. */
export function parsePathPoints(texts: readonly string[], node: string): Vec3[] {
  const places = texts.map((text, i) => parseNumbers(text, [3], `${node}.places ${i + 1}`) as unknown as Vec3);
  checkCount(places, `${node}.places`);
  places.slice(1).forEach((place, i) => {
    if (place.every((x, k) => x === places[i]![k]))
      throw nodeRefusal(
        'path.same',
        `${node}.places ${i + 2}`,
        msg`it is the place before it again; leave one of them out`,
      );
  });
  return places;
}

/** `t x y z` or `t x y z rx ry rz` per text [s, m, °]; times increase. */
export function parsePoseKeys(texts: readonly string[], node: string): PoseKey[] {
  const keys = texts.map((text, i): PoseKey => {
    const [time, x, y, z, ...angles] = parseNumbers(text, [4, 7], `${node}.keys ${i + 1}`) as KeyframeRow;
    return { time, position: [x, y, z], orientation: angles.length === 3 ? rotationXYZ(angles) : IDENTITY };
  });
  checkCount(keys, `${node}.keys`);
  keys.slice(1).forEach(({ time }, i) => {
    if (!(time > keys[i]!.time)) {
      const message = msg`its time ${time} s is not after ${keys[i]!.time} s, that of the one before it; put them in order`;
      throw nodeRefusal('keys.order', `${node}.keys ${i + 2}`, message);
    }
  });
  return keys;
}

function checkCount(all: readonly unknown[], place: string): void {
  if (all.length < 2)
    throw nodeRefusal(
      'path.short',
      place,
      msg`it takes at least two; there ${all.length === 1 ? msg`is one` : msg`are none`}`,
    );
  if (all.length > MAX_KEYS)
    throw nodeRefusal('path.long', place, msg`there are ${all.length}, more than ${MAX_KEYS}; take fewer`);
}

function parseNumbers(text: string, counts: readonly number[], place: string): number[] {
  const numbers = text
    .trim()
    .split(/[\s,;]+/)
    .map(Number);
  if (counts.includes(numbers.length) && numbers.every(Number.isFinite)) return numbers;
  throw nodeRefusal(
    'path.numbers',
    place,
    msg`"${text.slice(0, 80)}" is not ${counts.join(' or ')} numbers; write them with blanks between them`,
  );
}
