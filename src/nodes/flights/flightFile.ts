import * as z from 'zod/mini';
import { flyArc, LOCKS } from '../../flight/arc.ts';
import { MAX_RAPIDITY } from '../../flight/controls.ts';
import { MAX_ARCS } from '../../flight/recording/recorder.ts';
import type { FlightLeg, FlightRecording } from '../../flight/recording/recording.ts';
import { DocumentError } from '../../graph/document/document.ts';
import { jsonOf, parseWithSchema } from '../../graph/document/parse.ts';
import type { Sum } from '../../math/sum.ts';
import { msg } from '../../messages/message.ts';

/** How names of files of flights end. */
export const FLIGHT_EXTENSION = '.flight.json';

/** Larger texts are no flights: a million arcs have about 250 characters each. */
const MAX_LENGTH = 2 ** 28;
const MAX_LEGS = 100_000;

const finite = z.number();
const positive = z.number().check(z.gt(0));
const notNegative = z.number().check(z.gte(0));
const vector = z.readonly(z.tuple([finite, finite, finite]));
const quaternion = z.readonly(z.tuple([finite, finite, finite, finite]));
/** A compensated sum: a number, or what is left of its rounding too. */
const sum = z.union([finite, z.readonly(z.tuple([finite, finite]))]);
const boost = { direction: vector, rapidity: z.number().check(z.gte(0), z.lte(MAX_RAPIDITY)) };

/** Version 1 of a file of a flight. docs/guide/flights.md explains it. */
const flightSchema = z.strictObject({
  slowlight: z.literal('flight'),
  version: z.literal(1),
  legs: z
    .array(
      z.strictObject({
        c: positive,
        lock: z.enum(LOCKS),
        playing: z.boolean(),
        start: z.strictObject({
          t: sum,
          position: z.readonly(z.tuple([sum, sum, sum])),
          ...boost,
          orientation: quaternion,
          properTime: sum,
        }),
        arcs: z
          .array(
            z.strictObject({
              dTau: notNegative,
              orientation: z.optional(quaternion),
              push: z.optional(z.strictObject({ direction: vector, size: notNegative })),
              reached: z.optional(z.strictObject(boost)),
            }),
          )
          .check(z.minLength(1), z.maxLength(MAX_ARCS)),
      }),
    )
    .check(z.minLength(1), z.maxLength(MAX_LEGS)),
});

/** How far from 1 lengths in a file may be. */
const UNIT_TOLERANCE = 1e-9;

const readSum = (value: z.infer<typeof sum>): Sum =>
  typeof value === 'number' ? { value, rest: 0 } : { value: value[0], rest: value[1] };
const writeSum = ({ value, rest }: Sum): z.infer<typeof sum> => (rest === 0 ? value : [value, rest]);

/** Reads the text of a file of a flight. Throws a DocumentError with the place of the first error. */
export function parseFlight(text: string): FlightRecording {
  if (text.length > MAX_LENGTH)
    throw new DocumentError(msg`the file: more than the ${MAX_LENGTH / 2 ** 20} MiB of a flight`);
  const { legs } = parseWithSchema(flightSchema, jsonOf(text));
  return {
    legs: legs.map(({ c, lock, playing, start, arcs }, i) => {
      const { t, position, direction, rapidity, orientation, properTime } = start;
      const place = `legs.${i}`;
      unit(`${place}.start.direction`, direction);
      unit(`${place}.start.orientation`, orientation);
      const [x, y, z] = position;
      const leg: FlightLeg = {
        conditions: { c, lock, playing },
        start: {
          t: readSum(t),
          position: [readSum(x), readSum(y), readSum(z)],
          velocity: { direction, rapidity },
          orientation,
          properTime: readSum(properTime),
        },
        arcs,
      };
      let state = leg.start;
      for (const [k, arc] of arcs.entries()) {
        const at = `${place}.arcs.${k}`;
        if (arc.push) unit(`${at}.push.direction`, arc.push.direction);
        if (arc.orientation) unit(`${at}.orientation`, arc.orientation);
        if (arc.reached) unit(`${at}.reached.direction`, arc.reached.direction);
        state = flyArc(state, arc, leg.conditions);
        if (!(state.velocity.rapidity <= MAX_RAPIDITY && Number.isFinite(state.t.value)))
          throw new DocumentError(
            msg`${at}: it pushes beyond rapidity ${MAX_RAPIDITY}, or lasts for ever; let it be shorter`,
          );
      }
      return leg;
    }),
  };
}

function unit(place: string, values: readonly number[]): void {
  const size = Math.hypot(...values);
  if (!(Math.abs(size - 1) <= UNIT_TOLERANCE))
    throw new DocumentError(msg`${place}: its length is ${size}; it must be 1`);
}

/** The text of a file of a flight: one line for each arc. */
export function serializeFlight({ legs }: FlightRecording): string {
  const texts = legs.map(({ conditions: { c, lock, playing }, start, arcs }) => {
    const { t, position, velocity, orientation, properTime } = start;
    const [x, y, z] = position;
    const state = {
      t: writeSum(t),
      position: [writeSum(x), writeSum(y), writeSum(z)],
      ...velocity,
      orientation,
      properTime: writeSum(properTime),
    };
    const lines = arcs.map((arc) => `\n  ${JSON.stringify(arc)}`);
    const head = JSON.stringify({ c, lock, playing, start: state });
    return `${head.slice(0, -1)},"arcs":[${lines.join(',')}\n ]}`;
  });
  return `{"slowlight":"flight","version":1,"legs":[\n ${texts.join(',\n ')}\n]}\n`;
}
