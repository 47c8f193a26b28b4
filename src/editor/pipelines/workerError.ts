import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/** The error of a worker that failed with a message, or without one because it did not start. */
export const workerError = (message: string, notStarted = msg`a worker could not be started`): Error =>
  message ? new Error(message) : new MessageError(notStarted);
