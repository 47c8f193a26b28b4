import { readFileSync } from 'node:fs';
import type { FlightRecording } from '../../flight/recording/recording.ts';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { FLIGHT_EXTENSION, parseFlight, serializeFlight } from '../../nodes/flights/flightFile.ts';
import { inputProblem, orRefuse, usageError } from '../terminal/exitCodes.ts';
import { writeFileAtomically } from './outputFile.ts';

/** Reads a file of a flight that a user names. */
export function readFlightFile(path: string): FlightRecording {
  let text: string;
  try {
    text = readFileSync(path, 'utf8');
  } catch (error) {
    throw inputProblem(msg`${path}: ${messageOf(error)}`);
  }
  return orRefuse(
    () => parseFlight(text),
    (problem) => inputProblem(msg`${path}: ${problem}`),
  );
}

export function writeFlightFile(path: string, recording: FlightRecording): void {
  if (!path.endsWith(FLIGHT_EXTENSION))
    throw usageError(msg`--output ${path}: its name must end in ${FLIGHT_EXTENSION}`);
  writeFileAtomically(path, new TextEncoder().encode(serializeFlight(recording)));
}
