import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { InputError } from '../../scene/types.ts';

/** Does something with a file, whose name is put in front of what its errors say. */
export async function inFile<Result>(name: string, use: () => Promise<Result>): Promise<Result> {
  try {
    return await use();
  } catch (thrown) {
    if (!(thrown instanceof MessageError) || thrown instanceof InputError) throw thrown;
    throw new MessageError(msg`${name}: ${thrown.text}`, { cause: thrown });
  }
}
