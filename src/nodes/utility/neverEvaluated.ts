import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/** For structural types, which the engine removes before evaluation (graph/document/structuralTypes.ts). */
export function neverEvaluated(): never {
  throw new MessageError(msg`groups and reroutes are removed before evaluation`);
}
